// SPDX-License-Identifier: MIT
#include <vector>

#include <topobag/types/class_catalog.hpp>

#include "box_files.hpp"
#include "catch.hpp"
#include "scratch.hpp"

using namespace program;
using topobag::ClassCatalog;
using topobag::ClassId;

namespace {

const ClassCatalog catalog = ClassCatalog::coco80();

BoxesByImage read(const std::string& path) {
  return read_boxes(path, catalog.ids(), catalog, 640, 480);
}

}  // namespace

TEST_CASE("YOLO text files give boxes in pixels", "[examples]") {
  const ScratchFolder folder;
  folder.write("12.5.txt", "62 0.5 0.25 0.1 0.2 0.75\n\n0 0.25 0.5 0.5 0.5\n");
  folder.write("13.txt", "");
  folder.write("notes.md", "nothing");
  const BoxesByImage boxes = read(folder.path(""));
  REQUIRE(boxes.size() == 2);
  CHECK(boxes.at("13").empty());
  const auto& found = boxes.at("12.5");
  REQUIRE(found.size() == 2);
  CHECK(found[0].label == catalog.at("tv"));
  CHECK(found[0].box.center().isApprox(Eigen::Vector2d(319.5, 119.5)));
  CHECK(found[0].box.width() == Approx(64.0));
  CHECK(found[0].box.height() == Approx(96.0));
  CHECK(found[0].confidence == 0.75);
  CHECK(found[1].confidence == 1.0);
}

TEST_CASE("broken YOLO text is told with file and line", "[examples]") {
  const ScratchFolder folder;
  CHECK(error_in(folder, [&] { read(folder.path("")); }) ==
        ": there is no .txt file in the folder");
  folder.write("a.txt", "0 0.5 0.5 0.1 0.1\n0 0.5 0.5 0.1\n");
  CHECK(error_in(folder, [&] { read(folder.path("")); }) ==
        "a.txt:2: a line is: class cx cy w h [score]");
  folder.write("a.txt", "0 0.5 0.5 0.1 0.1 much\n");
  CHECK(error_in(folder, [&] { read(folder.path("")); }) == "a.txt:1: the score is not a number");
  folder.write("a.txt", "62 0.1 0.1 0.6 0.1 0.6 0.7 0.1 0.7\n");  // a polygon
  CHECK(error_in(folder, [&] { read(folder.path("")); }) ==
        "a.txt:1: a line is: class cx cy w h [score]");
  for (const std::string score : {"90", "1.01", "-0.1"}) {
    folder.write("a.txt", "0 0.5 0.5 0.1 0.1 " + score + "\n");
    CHECK(error_in(folder, [&] { read(folder.path("")); }) ==
          "a.txt:1: the score has to lie in [0, 1]");
  }
  folder.write("a.txt", "80 0.5 0.5 0.1 0.1\n");
  CHECK(error_in(folder, [&] { read(folder.path("")); }) ==
        "a.txt:1: there is no class 80; give --names");
}

TEST_CASE("COCO results go by COCO's own numbers", "[examples]") {
  const ScratchFolder folder;
  const BoxesByImage boxes = read(folder.write("results.json", R"([
    {"image_id": 42, "category_id": 72, "bbox": [10, 20, 30, 40], "score": 0.5},
    {"image_id": "left/7.png", "category_id": 90, "bbox": [0, 0, 1, 1], "score": 0.25},
    {"image_id": 42, "category_id": 1, "bbox": [0, 0, 1, 1], "score": 0.125}])"));
  REQUIRE(boxes.at("42").size() == 2);
  CHECK(boxes.at("42")[0].label == catalog.at("tv"));
  CHECK(boxes.at("42")[0].box.x1 == 9.5);
  CHECK(boxes.at("42")[0].box.y2 == 59.5);
  CHECK(boxes.at("42")[1].label == catalog.at("person"));
  CHECK(boxes.at("7")[0].label == catalog.at("toothbrush"));
  const std::string wrong = folder.write(
      "wrong.json", R"([{"image_id": 1, "category_id": 12, "bbox": [0, 0, 1, 1], "score": 1}])");
  CHECK(error_in(folder, [&] { read(wrong); }) ==
        "wrong.json, entry 1: category 12 is none of COCO's");
  for (const std::string score : {"90", "-1e-9"}) {
    const std::string beyond = folder.write(
        "beyond.json",
        R"([{"image_id": 1, "category_id": 1, "bbox": [0, 0, 1, 1], "score": )" + score + "}]");
    CHECK(error_in(folder, [&] { read(beyond); }) ==
          "beyond.json, entry 1: the score has to lie in [0, 1]");
  }
}

TEST_CASE("a COCO category that is no whole number of an int is refused",
          "[examples][regression]") {
  const ScratchFolder folder;
  for (const std::string category : {"3.3e26", "4294967297", "-1", "0", "91", "1.5", "null"}) {
    const std::string file =
        folder.write("results.json", R"([{"image_id": 1, "category_id": )" + category +
                                         R"(, "bbox": [0, 0, 1, 1]}])");
    const std::string error = error_in(folder, [&] { read(file); });
    CAPTURE(category, error);
    CHECK(error.find("results.json, entry 1: category ") == 0);
    CHECK(error.find(" is none of COCO's") != std::string::npos);
  }
}

TEST_CASE("a COCO data set names its images and categories", "[examples]") {
  const ScratchFolder folder;
  const BoxesByImage boxes = read(folder.write("set.json", R"({
    "images": [{"id": 3, "file_name": "rgb/1.25.png"}],
    "categories": [{"id": 5, "name": "keyboard"}],
    "annotations": [{"image_id": 3, "category_id": 5, "bbox": [1, 2, 3, 4]}]})"));
  REQUIRE(boxes.at("1.25").size() == 1);
  CHECK(boxes.at("1.25")[0].label == catalog.at("keyboard"));
  CHECK(boxes.at("1.25")[0].confidence == 1.0);
  const std::string cut = folder.write("cut.json", "{\"annotations\": [");
  CHECK(error_in(folder, [&] { read(cut); }).find("cut.json, entry 0: ") == 0);
}
