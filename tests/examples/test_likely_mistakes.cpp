// SPDX-License-Identifier: MIT
// What a newcomer does wrong first with each command: one sentence that says what to do.
#include <cstddef>
#include <string>
#include <vector>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

/// Arguments, where FOLDER stands for a folder of the files below, and how the sentence goes on
/// behind "topobag: ".
struct Mistake {
  std::string arguments;
  std::string sentence;
};

std::string in_folder(std::string text, const std::string& folder) {
  for (std::size_t at; (at = text.find("FOLDER")) != std::string::npos;) {
    text.replace(at, 6, folder);
  }
  return text;
}

void check_told(const std::vector<Mistake>& mistakes) {
  const ScratchFolder folder;
  folder.write("map.bag", "\x89TBG\r\n\x1a\n");
  folder.write("note.txt", "Monday: all well\n");
  folder.write("poses.txt", "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n");
  folder.write("later.txt", "90 0 0 0 0 0 0 1\n91 0 0 0 0 0 0 1\n");
  folder.write("kitti.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  folder.write("scores.csv", "0,1\n1,0\n");
  folder.write("list.csv", "query,candidate,score\n");
  for (const Mistake& mistake : mistakes) {
    const std::string sentence = refusal(in_folder(mistake.arguments, folder.path()));
    CHECK(sentence == in_folder(mistake.sentence, folder.path()));
  }
}

const std::string desk_camera = " --camera 517.3,516.5,318.6,255.3 ";
const std::string two_tables = " --map " + sample_map + " --query " + sample_query + " ";
const std::string no_table =
    ": it is no table, which is two files; name SET of SET.frames.csv and SET.nodes.csv";
const std::string no_camera = "--camera is required; see topobag ";
const std::string half_size =
    "--camera: the principal point 159.3, 127.6 lies far from the middle of an image of 640 x 480 "
    "px; give the intrinsics for that size, or the size that they are for";

}  // namespace

TEST_CASE("likely mistakes with localize and loops are told in a sentence", "[examples]") {
  check_told({
      {"localize" + two_tables, no_camera + "localize --help"},
      {"localize" + two_tables + "--camera 258,258,159.3,127.6", half_size},
      {"localize --map " + sample_map + " --query FOLDER/map.bag" + desk_camera,
       "FOLDER/map.bag" + no_table},
      {"localize --map FOLDER/map.bag --query " + sample_query + desk_camera +
           "--map-camera 500,500,320,240",
       "FOLDER/map.bag: it is a saved map, which has its poses, cameras and vertical: "
       "--map-trajectory, --map-camera and --map-world-up are for tables"},
      {"localize" + two_tables + desk_camera + "--report FOLDER/r.html --pairs FOLDER/r.html",
       "--report FOLDER/r.html: the file is also that of --pairs; give another name"},
      {"localize" + two_tables + desk_camera + "--seed -1",
       "--seed: '-1' is not a whole number in [0, inf); see topobag localize --help"},
      {"loops --nodes " + sample_map, no_camera + "loops --help"},
      {"loops --nodes FOLDER/map.bag" + desk_camera, "FOLDER/map.bag" + no_table},
      {"loops --nodes FOLDER/none" + desk_camera,
       "FOLDER/none.frames.csv: the file cannot be opened; check the path"},
      {"loops --min-gap 20s --nodes " + sample_map + desk_camera,
       "--min-gap: '20s' is not a number in [0, inf); see topobag loops --help"},
      {"loops --min-gap 2e10 --nodes " + sample_map + desk_camera,
       sample_map + ": none of the 62 key frames could be looked up: 0 have no usable graph, 62 "
                    "nothing to compare with, such as a key frame that is older by --min-gap"},
  });
}

TEST_CASE("likely mistakes with map, info and explain are told in a sentence", "[examples]") {
  check_told({
      {"map --nodes " + sample_map + desk_camera, "--out is required; see topobag map --help"},
      {"map --out FOLDER/m.bag --nodes " + sample_map, no_camera + "map --help"},
      {"map --out FOLDER/m.bag --nodes FOLDER/map.bag" + desk_camera, "FOLDER/map.bag" + no_table},
      {"map --out FOLDER/no/m.bag --nodes " + sample_map + desk_camera,
       "--out FOLDER/no/m.bag: the folder does not exist; make it first"},
      {"map --out FOLDER/note.txt --nodes " + sample_map + desk_camera,
       "FOLDER/note.txt: it exists; give --append to go on mapping, or another name"},
      {"info", "map is required; see topobag info --help"},
      {"info " + sample_map, sample_map + ": it is a table, no map; `topobag map` makes one of it"},
      {"info FOLDER/none.bag", "FOLDER/none.bag: the file cannot be opened; check the path"},
      {"info FOLDER/note.txt",
       "FOLDER/note.txt: it is no map: neither an SQLite map nor a snapshot of topobag"},
      {"info FOLDER", "FOLDER: it is a folder; name the map in it"},
      {"explain" + two_tables + desk_camera, "--frame is required; see topobag explain --help"},
      {"explain --frame 1" + two_tables, no_camera + "explain --help"},
      {"explain --frame 9999" + two_tables + desk_camera,
       "--frame 9999: the table has no frame of this idx; it has idx 0 to 60"},
      {"explain --frame 3 --candidates -1" + two_tables + desk_camera,
       "--candidates: '-1' is not a whole number in [1, inf); see topobag explain --help"},
      {"explain --frame 3 --svg " + sample_query + ".nodes.csv" + two_tables + desk_camera,
       "--svg " + sample_query + ".nodes.csv: the file is also that of --query; give another name"},
  });
}

TEST_CASE("likely mistakes with what scores are told in a sentence", "[examples]") {
  const std::string evaluate = "evaluate --poses FOLDER/poses.txt --scores FOLDER/";
  const std::string trajectory = "trajectory --groundtruth FOLDER/poses.txt --estimate FOLDER/";
  check_told({
      {"compare --map " + sample_map + desk_camera,
       "--map requires --query; see topobag compare --help"},
      {"compare" + two_tables, no_camera + "compare --help"},
      {"compare --map FOLDER/map.bag --query " + sample_query + desk_camera,
       "FOLDER/map.bag: compare makes the graphs anew and needs a node table, not a saved map"},
      {"compare --verified 0" + two_tables + desk_camera,
       "--verified: '0' is not a whole number in [1, inf); see topobag compare --help"},
      {"compare --scores FOLDER/scores.csv" + two_tables + desk_camera,
       "FOLDER/scores.csv: the scores are 2 × 2, but the poses make 60 queries × 62 candidates"},
      {"evaluate --scores FOLDER/scores.csv", "--poses is required; see topobag evaluate --help"},
      {evaluate + "note.txt",
       "FOLDER/note.txt:1: 'Monday:' is not a number: a matrix of scores has no header, and that "
       "of a list is query,candidate,score."},
      {evaluate + "list.csv", "FOLDER/list.csv: there is no score in the file"},
      {evaluate.substr(0, evaluate.size() - 1), "FOLDER: it is a folder; name a file in it"},
      {evaluate + "scores.csv --protocol radius=5",
       "protocol: 'radius' is not one of distance=, angle=, negative-distance=, negative-angle=, "
       "covisibility=, negative-covisibility=, frustum=, exclude-seconds=, exclude-frames=, "
       "past-only"},
      {evaluate + "scores.csv --bootstrap -1",
       "--bootstrap: '-1' is not a whole number in [0, inf); see topobag evaluate --help"},
      {"trajectory --groundtruth FOLDER/poses.txt",
       "--estimate is required; see topobag trajectory --help"},
      {trajectory + "kitti.txt",
       "FOLDER/kitti.txt: a KITTI trajectory has no time stamps, the other one has: give --times"},
      {trajectory + "later.txt",
       "FOLDER/later.txt: no pose lies between two true ones of its time: 2 poses from 90 to 91 s, "
       "the truth has 2 poses from 0 to 1 s; are both of one clock?"},
      {trajectory + "poses.txt --rpe-unit km",
       "--rpe-unit: 'km' is none of frames, metres, seconds; see topobag trajectory --help"},
      {trajectory.substr(0, trajectory.size() - 1), "FOLDER: it is a folder; name a file in it"},
  });
}

TEST_CASE("likely mistakes with nodes and similarity are told in a sentence", "[examples]") {
  const std::string nodes = "nodes --images FOLDER --out FOLDER/set" + desk_camera;
  check_told({
      {nodes, "Exactly 1 option from [--model,--boxes] is required; see topobag nodes --help"},
      {"nodes --images FOLDER --out FOLDER/set --boxes FOLDER", no_camera + "nodes --help"},
      {nodes + "--boxes FOLDER",
       "FOLDER: it is no sequence in the TUM RGB-D layout, which has associations.txt, or rgb.txt "
       "and depth.txt"},
      {nodes + "--boxes FOLDER --depth-scale 0",
       "--depth-scale: '0' is not a number in [1e-06, inf); see topobag nodes --help"},
      {"nodes --images FOLDER --boxes FOLDER --out FOLDER/no/set" + desk_camera,
       "--out FOLDER/no/set: the folder does not exist; make it first"},
      {"similarity", "--nodes is required; see topobag similarity --help"},
      {"similarity --frames 0 --nodes " + sample_map, no_camera + "similarity --help"},
      {"similarity --nodes FOLDER/map.bag" + desk_camera, "FOLDER/map.bag" + no_table},
      {"similarity --frames 0-5 --nodes " + sample_map + desk_camera,
       "--frames: '0-5' is not the idx of a frame, a whole number; see topobag similarity "
       "--help"},
      {"similarity --frames 0,9999 --nodes " + sample_map + desk_camera,
       sample_map + ".frames.csv: there is no frame idx 9999; name others by --frames"},
  });
}
