// SPDX-License-Identifier: MIT
// Files that are likely to be given in another form than is read, and options that would be
// ignored: one sentence that says what was found and what to do.
#include <string>
#include <vector>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

const std::string misread_camera = " --camera 517.3,516.5,318.6,255.3 ";
const std::string misread_tables =
    " --map " + sample_map + " --query " + sample_query + misread_camera;
const std::string gzip_bytes("\x1F\x8B\x08\x00\x00\r\x03 a", 9);

/// The sample's query under another name.
std::string copied_set(const ScratchFolder& folder, const std::string& name) {
  for (const char* half : {".frames.csv", ".nodes.csv"}) {
    folder.write(name + half, program::read_file(sample_query + half));
  }
  return folder.path(name);
}

}  // namespace

TEST_CASE("a map is not written under the name of a table", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string set = copied_set(folder, "room");
  const std::string why =
      ": it is the name of a table, which the file would hide; give another name";
  CHECK(refusal("map --nodes " + set + " --out " + set + misread_camera) == "--out " + set + why);
  REQUIRE(run_program("map --nodes " + set + " --out " + folder.path("m.bag") + misread_camera)
              .exit_code == 0);
  CHECK(refusal("view " + folder.path("m.bag") + " --out " + set) == "--out " + set + why);
  CHECK(run_program("map --nodes " + set + " --out " + folder.path("n.bag") + misread_camera)
            .exit_code == 0);
}

TEST_CASE("compressed files are told by what they are", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string set = copied_set(folder, "room");
  folder.write("room.frames.csv", gzip_bytes);
  folder.write("gt.txt.gz", gzip_bytes);
  folder.write("m.bag.gz", gzip_bytes);
  const std::string packed = ":1: this is compressed: unpack it first";
  CHECK(refusal("loops --nodes " + set + misread_camera) == set + ".frames.csv" + packed);
  const std::string truth = folder.path("gt.txt.gz");
  CHECK(refusal("trajectory --groundtruth " + truth + " --estimate " + sample_map) ==
        truth + packed);
  CHECK(refusal("evaluate --scores " + truth + " --poses " + sample_map) == truth + packed);
  CHECK(refusal("info " + folder.path("m.bag.gz")) ==
        folder.path("m.bag.gz") + ": it is compressed; unpack it first");
}

TEST_CASE("scores with a header of their own are told", "[program][regression]") {
  const ScratchFolder folder;
  folder.write("head.csv", "Query,Candidate,Score\n0,1,0.5\n");
  folder.write("one.csv", "query,candidate,score\n1,62,0.5\n");
  const std::string poses = " --poses " + sample_query;
  CHECK(refusal("evaluate --scores " + folder.path("head.csv") + poses) ==
        folder.path("head.csv") +
            ":1: 'Query' is not a number: a matrix of scores has no header, and that of a list is "
            "query,candidate,score.");
  CHECK(refusal("evaluate --scores " + folder.path("one.csv") + poses) ==
        folder.path("one.csv") +
            ": query 1 or candidate 62 has no pose: they are row numbers of the poses, 61 queries "
            "and 61 candidates, from 0");
  folder.write("list.csv", "query,candidate,score\n0,40,0.5\n");
  const std::string list = folder.path("list.csv");
  CHECK(refusal("evaluate --scores " + list + poses + " --map-poses " + sample_map + " --against " +
                list)
            .find("--against " + list + ": these are the scores themselves") == 0);
}

TEST_CASE("options that would be ignored are refused", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string page = " --out " + folder.path("v.html");
  CHECK(refusal("compare" + misread_tables + "--min-gap 5") ==
        "--min-gap: it does nothing without --nodes; give that, or leave it out");
  CHECK(refusal("localize" + misread_tables + "--different-places --align-worlds")
            .find(" excludes --") != std::string::npos);
  CHECK(refusal("localize --map " + sample_map + " --query " + sample_query +
                " --camera 517.3,516.5,318.6,255.3,640,480 --image-size 1280,720") ==
        "--image-size: 1280 x 720 px is not the size that the camera has, 640 x 480; leave it out");
  CHECK(refusal("view " + sample_map + misread_camera + "--map-camera 500,500,320,240" + page) ==
        "--map-camera: it does nothing without --query; give that, or leave it out");
  CHECK(refusal("view " + sample_map + misread_camera + "--loops --min-gap 500" + page)
            .find("none of the 62 key frames could be looked up") != std::string::npos);
  CHECK(refusal("similarity --frames 0,0 --nodes " + sample_query + misread_camera) ==
        "--frames: it names frame 0 alone, which is like itself; name others to compare it with");
}

TEST_CASE("what a shell leaves of an argument is told", "[examples][regression]") {
  const std::string home = "; the shell leaves ~ as it is in quotes and behind =, so write $HOME";
  CHECK(refusal("localize --map= --query b" + misread_camera) ==
        "--map is empty; give it a value, or leave it out");
  CHECK(refusal("localize --map --query b" + misread_camera) ==
        "--map has no value; give it one, or leave it out; see topobag localize --help");
  CHECK(refusal("map --nodes " + sample_map + " '--out=~/none/m.bag'" + misread_camera) ==
        "--out ~/none/m.bag: the folder does not exist; make it first" + home);
  CHECK(refusal("loops '--nodes=~/none'" + misread_camera) ==
        "~/none.frames.csv: the file cannot be opened; check the path" + home);
  CHECK(refusal("info '~/none.bag'") ==
        "~/none.bag: the file cannot be opened; check the path" + home);
  CHECK(refusal("loops --window 0,4 --nodes " + sample_map + misread_camera) ==
        "--window: '0,4' is not a number in [0, inf); decimals have a point; see topobag loops "
        "--help");
  CHECK(refusal("info a.bag b.bag") == "'b.bag' is one argument too many; see topobag info --help");
  CHECK(refusal("fleet follow 'postgresql:/host/base?site=a'") ==
        "postgresql:/host/base?site=a: it is no server's address, as "
        "postgresql://USER@HOST/BASE?site=NAME is");
  CHECK(refusal("fleet follow 'postgresql://host/base?site=a' --seconds 1.5") ==
        "--seconds: '1.5' is not a whole number in [0, inf); see topobag fleet follow --help");
}
