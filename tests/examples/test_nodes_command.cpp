// SPDX-License-Identifier: MIT
#include <filesystem>
#include <numeric>
#include <regex>
#include <string>
#include <vector>

#include <topobag/sensing/color_descriptor.hpp>

#include "catch.hpp"
#include "node_table.hpp"
#include "run_program.hpp"

namespace {

/// A sequence of one image, 64 x 48 px, all of it 2 m away.
void write_sequence(const ScratchFolder& folder) {
  const std::string size = "64 48\n";
  const std::size_t pixels = 64 * 48;
  std::string depth = "P5\n" + size + "65535\n";
  for (std::size_t i = 0; i < pixels; ++i) depth += std::string("\x27\x10");  // 10000
  folder.write("rgb.ppm", "P6\n" + size + "255\n" + std::string(3 * pixels, '\0'));
  folder.write("depth.pgm", depth);
  folder.write("associations.txt", "1.0 rgb.ppm 1.0 depth.pgm\n");
}

}  // namespace

TEST_CASE("nodes keeps boxes that the image shows, and accounts for each", "[examples]") {
  const ScratchFolder folder;
  write_sequence(folder);
  const std::string boxes = folder.write("boxes.json", R"([
    {"image_id": "rgb", "category_id": 72, "bbox": [10, 10, 20, 20], "score": 0.9},
    {"image_id": "rgb", "category_id": 72, "bbox": [11, 10, 20, 20], "score": 0.8},
    {"image_id": "rgb", "category_id": 1, "bbox": [40, 10, 10, 10], "score": 0.7},
    {"image_id": "rgb", "category_id": 72, "bbox": [10, 10, 0, 5], "score": 0.6},
    {"image_id": "rgb", "category_id": 72, "bbox": [70, 10, 10, 10], "score": 0.5}])");
  const std::string set = folder.path("set");
  const ProgramRun run = run_program("nodes --images " + folder.path() + " --boxes " + boxes +
                                     " --camera 50,50,31.5,23.5 --out " + set);
  if (run.err.find("was not built") != std::string::npos) return;  // it needs OpenCV
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const auto detections = program::read_node_table(set).frames.at(0).detections;
  REQUIRE(detections.size() == 3);
  CHECK(detections[0].z == 2.0);

  const std::regex number("[0-9]+");
  const std::string counts = run.out.substr(set.size());
  std::vector<int> found;
  for (std::sregex_iterator it(counts.begin(), counts.end(), number), end; it != end; ++it) {
    found.push_back(std::stoi(it->str()));
  }
  REQUIRE(found.size() == 13);  // frames, detections, nodes and seven reasons; two left out, poses
  CHECK(found[1] == 3);
  CHECK(found[2] == 1);
  CHECK(std::accumulate(found.begin() + 2, found.begin() + 10, 0) == found[1]);
  CHECK(run.out.find("not in the table: 1 boxes of no size, 1 boxes outside the image; frames "
                     "without a pose: 1\n") != std::string::npos);
}

TEST_CASE("nodes that finds nothing says why and leaves nothing behind", "[examples]") {
  const ScratchFolder folder;
  write_sequence(folder);
  const auto said = [&](const std::string& boxes) {
    return refusal("nodes --images " + folder.path() + " --boxes " + folder.path(boxes) +
                   " --camera 50,50,31.5,23.5 --out " + folder.path("set"));
  };
  folder.write("outside.json", R"([
    {"image_id": "rgb", "category_id": 72, "bbox": [70, 10, 10, 10], "score": 0.5}])");
  const std::string outside = said("outside.json");
  if (outside.find("was not built") != std::string::npos) return;  // it needs OpenCV
  CHECK(outside ==
        folder.path("outside.json") +
            ": there is no detection in the 1 images; left out: 1 boxes outside the image");
  folder.write("other.json", R"([
    {"image_id": 7, "category_id": 72, "bbox": [7, 10, 10, 10], "score": 0.5}])");
  CHECK(said("other.json") ==
        folder.path("other.json") +
            ": it speaks of none of the sequence's 1 images, but of 1 others, such as '7'; the "
            "first is 'rgb.ppm'");
  CHECK_FALSE(std::filesystem::exists(folder.path("set.nodes.csv")));
  folder.write("associations.txt", "1.0 gone.ppm 1.0 depth.pgm\n");
  folder.write("gone.json", R"([
    {"image_id": "gone", "category_id": 72, "bbox": [7, 10, 10, 10], "score": 0.5}])");
  CHECK(said("gone.json") == folder.path("gone.ppm") + ": there is no such image");
}

TEST_CASE("a file of names may end in blank lines but not hold one", "[examples]") {
  const ScratchFolder folder, labels;
  write_sequence(folder);
  labels.write("rgb.txt", "1 0.5 0.5 0.4 0.4\n");
  const std::string arguments = "nodes --images " + folder.path() + " --boxes " + labels.path() +
                                " --camera 50,50,31.5,23.5,64,48 --out " + folder.path("set") +
                                " --names ";
  const std::string whole = folder.write("whole.txt", "\xEF\xBB\xBFtv\r\nlaptop\r\n\r\n");
  const ProgramRun run = run_program(arguments + whole);
  if (run.err.find("was not built") != std::string::npos) return;  // it needs OpenCV
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const auto detections = program::read_node_table(folder.path("set")).frames.at(0).detections;
  CHECK(topobag::ClassCatalog::coco80().name(detections.at(0).label) == "laptop");
  std::filesystem::remove(folder.path("set.nodes.csv"));  // a whole table is not written over
  const std::string holed = folder.write("holed.txt", "tv\n\nlaptop\n");
  CHECK(refusal(arguments + holed) ==
        holed + ":3: a blank or comment line above hides which number this class has");
}

TEST_CASE("nodes describes objects when it is asked to", "[examples][appearance]") {
  const ScratchFolder folder;
  write_sequence(folder);
  const std::string boxes = folder.write("boxes.json", R"([
    {"image_id": "rgb", "category_id": 72, "bbox": [10, 10, 20, 20], "score": 0.9}])");
  const std::string arguments =
      "nodes --images " + folder.path() + " --boxes " + boxes + " --camera 50,50,31.5,23.5 --out ";
  const ProgramRun plain = run_program(arguments + folder.path("set"));
  if (plain.err.find("was not built") != std::string::npos) return;  // it needs OpenCV
  CHECK(program::read_node_table(folder.path("set")).appearance.empty());
  CHECK(run_program(arguments + folder.path("none") + " --appearance none").exit_code == 0);
  CHECK(program::read_node_table(folder.path("none")).appearance.empty());
  REQUIRE(run_program(arguments + folder.path("color") + " --appearance color").exit_code == 0);
  const program::NodeTable table = program::read_node_table(folder.path("color"));
  CHECK(table.appearance == topobag::ColorDescriptor::name);
  CHECK(table.frames.at(0).detections.at(0).appearance.kind() == topobag::ColorDescriptor::kind);
  CHECK(run_program(arguments + folder.path("clip") + " --appearance clip").exit_code == 2);
  CHECK(
      refusal(arguments + folder.path("neck") + " --appearance layer:neck").find("give --model") !=
      std::string::npos);
}

TEST_CASE("nodes replaces a table, and says so", "[examples][regression]") {
  const ScratchFolder folder, labels;
  write_sequence(folder);
  labels.write("rgb.txt", "62 0.5 0.5 0.4 0.4\n");
  const std::string arguments = "nodes --images " + folder.path() + " --boxes " + labels.path() +
                                " --camera 50,50,31.5,23.5 --out " + folder.path("set");
  const ProgramRun first = run_program(arguments);
  if (first.err.find("was not built") != std::string::npos) return;  // it needs OpenCV
  CAPTURE(first.err);
  REQUIRE(first.exit_code == 0);
  const std::string replaced =
      "topobag: " + folder.path("set") + ": the table that was there is replaced\n";
  CHECK(first.err.find(replaced) == std::string::npos);
  const std::string before = content_of(folder.path("set.nodes.csv"));
  labels.write("rgb.txt", "62 0.5 0.5 0.5 0.4 0.9\n");
  const ProgramRun again = run_program(arguments);
  CHECK(again.exit_code == 0);
  CHECK(again.err.find(replaced) != std::string::npos);
  CHECK(content_of(folder.path("set.nodes.csv")) != before);
  CHECK(refusal(arguments + '/') ==
        "--out " + folder.path("set/") + ": it is a folder; name a file in it");
}

TEST_CASE("nodes says what leaves it nothing", "[examples][regression]") {
  const ScratchFolder folder, labels;
  write_sequence(folder);
  labels.write("rgb.txt", "62 0.5 0.5 0.4 0.4\n");
  const std::string out = " --camera 50,50,31.5,23.5 --out " + folder.path("set");
  const std::string images = "nodes --images " + folder.path();
  const std::string scaled =
      refusal(images + " --boxes " + labels.path() + out + " --depth-scale 1");
  if (scaled.find("was not built") != std::string::npos) return;  // it needs OpenCV
  CHECK(scaled ==
        "--depth-scale: none of the 1 detections becomes a node, and 1 have a depth out of range, "
        "0.1 to 10 m: depths are from 10000 to 10000 m; give the depth value that means one metre, "
        "5000 in the TUM RGB-D layout");
  const std::string model = folder.write("net.onnx", "\x08\x07\x12\x07pytorch");
  CHECK(refusal(images + " --boxes " + model + out) ==
        model + ": it is neither a folder of YOLO text files nor COCO's JSON");
  CHECK(refusal(images + " --model " + labels.path() + out) ==
        labels.path() + ": it is a folder; name an ONNX file");
  const std::string nowhere = folder.path("nowhere");
  CHECK(refusal("nodes --images " + nowhere + " --boxes " + labels.path() + out) ==
        nowhere + ": there is no such folder");
}
