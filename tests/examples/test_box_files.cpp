// SPDX-License-Identifier: MIT
#include <string>
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

/// Reads boxes of images of 640 × 480 px.
ImageBoxes read(const std::string& path, const std::vector<std::string>& images) {
  return read_boxes(path, images, {catalog.ids(), catalog, 640, 480});
}

/// What is said of one line in the YOLO file of the one image.
std::string complaint_of_line(const std::string& line) {
  const ScratchFolder folder;
  folder.write("a.txt", line + "\n");
  return error_in(folder, [&] { read(folder.path(""), {"a.png"}); });
}

}  // namespace

TEST_CASE("YOLO text files give boxes in pixels", "[examples]") {
  const ScratchFolder folder;
  folder.write("12.5.txt",
               "\xEF\xBB\xBF"
               "62.0 0.5 0.25 0.1 0.2 0.75\r\n\n# a person\n0,0.25,0.5,0.5,0.5\n");
  folder.write("13.txt", "");
  folder.write("notes.md", "nothing");
  const ImageBoxes boxes = read(folder.path(""), {"rgb/12.5.png", "rgb/13.png", "rgb/14.png"});
  REQUIRE(boxes.of_image.size() == 3);
  CHECK(boxes.of_image[1].empty());
  CHECK(boxes.without_boxes == 1);
  CHECK(boxes.other_images == 0);
  const auto& found = boxes.of_image[0];
  REQUIRE(found.size() == 2);
  CHECK(found[0].label == catalog.at("tv"));
  CHECK(found[0].box.center().isApprox(Eigen::Vector2d(319.5, 119.5)));
  CHECK(found[0].box.width() == Approx(64.0));
  CHECK(found[0].box.height() == Approx(96.0));
  CHECK(found[0].confidence == 0.75);
  CHECK(found[1].confidence == 1.0);
}

TEST_CASE("broken YOLO text is told with file and line", "[examples]") {
  const ScratchFolder empty;
  CHECK(error_in(empty, [&] { read(empty.path(""), {"a.png"}); }) ==
        ": there is no .txt file in the folder");
  CHECK(complaint_of_line("0 0.5 0.5 0.1 0.1\n0 0.5 0.5 0.1") ==
        "a.txt:2: here are 4 fields; a line is: class cx cy w h [score]");
  CHECK(complaint_of_line("0 0.5 0.5 0.1 0.1 much") == "a.txt:1: 'much' is not a number.");
  CHECK(
      complaint_of_line("62 0.1 0.1 0.6 0.1 0.6 0.7 0.1 0.7") ==  // a polygon
      "a.txt:1: here are 9 fields, as of a polygon of 4 corners, and boxes are needed; a line is: "
      "class cx cy w h [score]");
  CHECK(complaint_of_line("0 0.5 0.5 0.1 0.1 0.9 17") ==  // a tracker's
        "a.txt:1: here are 7 fields, a track's id behind the score, or three corners; a line is: "
        "class cx cy w h [score]");
  CHECK(complaint_of_line("0 0.5 0.5 0.1 0.1 90") ==
        "a.txt:1: the score has to lie in [0, 1], not 90; is 90 the id of a track?");
  for (const std::string score : {"1.01", "-0.1", "nan"}) {
    CHECK(complaint_of_line("0 0.5 0.5 0.1 0.1 " + score) ==
          "a.txt:1: the score has to lie in [0, 1], not " + score);
  }
  for (const std::string number : {"80", "-1"}) {
    CHECK(complaint_of_line(number + " 0.5 0.5 0.1 0.1") ==
          "a.txt:1: there is no class " + number +
              " among 0 to 79; give the detector's own classes by --names");
  }
  CHECK(complaint_of_line("62.5 0.5 0.5 0.1 0.1") ==
        "a.txt:1: the class '62.5' is no whole number; a line is: class cx cy w h [score], by the "
        "class' number, with decimal points");
}

TEST_CASE("a box that is no share of the image is refused, one of no size counted",
          "[examples][regression]") {
  CHECK(complaint_of_line("62 320 240 64 72 0.9") ==
        "a.txt:1: cx 320 is no share of the image in [0, 1]; divide px by the image's size");
  CHECK(complaint_of_line("62 0.5 0.5 -0.2 0.3") ==
        "a.txt:1: w -0.2 is no share of the image in [0, 1]");
  CHECK(complaint_of_line("62 1.5 0.5 0.2 0.3").find("a.txt:1: cx 1.5 is no share") == 0);
  CHECK(complaint_of_line("62 0.5 nan 0.2 0.3") ==
        "a.txt:1: cy nan is no share of the image in [0, 1]");
  const ScratchFolder folder;
  folder.write("a.txt", "62 0.5 0.5 0 0\n62 0.5 0.5 0.1 0.1\n");
  const ImageBoxes boxes = read(folder.path(""), {"a.png"});
  CHECK(boxes.of_image[0].size() == 1);
  CHECK(boxes.empty == 1);
}

TEST_CASE("label files of other images are counted, and refused when all are", "[examples]") {
  const ScratchFolder folder;
  folder.write("classes.txt", "tv\nlaptop\n");  // as some tools put beside the labels
  folder.write("b.txt", "62 0.5 0.5 0.1 0.1\n");
  CHECK(read(folder.path(""), {"a.png", "b.png"}).other_images == 1);
  CHECK(read(folder.path(""), {"a.png", "b.png"}).without_boxes == 1);
  CHECK(error_in(folder, [&] { read(folder.path(""), {"rgb/7.png"}); }) ==
        ": it speaks of none of the sequence's 1 images, but of 2 others, such as 'b.txt'; the "
        "first is '7.png'");
}

TEST_CASE("a COCO file's boxes go to the sequence's images", "[examples]") {
  const ScratchFolder folder;
  const std::string file = folder.write("set.json", R"({
    "images": [{"id": 3, "file_name": "C:\\data\\rgb\\1.25.png", "width": 640, "height": 480},
               {"id": 4, "file_name": "rgb/9.png"}, {"id": 5, "file_name": "rgb/10.png"}],
    "categories": [{"id": 5, "name": "keyboard"}],
    "annotations": [{"image_id": 3.0, "category_id": 5, "bbox": [1, 2, 3, 4]},
                    {"image_id": "3", "category_id": 5.0, "bbox": [1, 2, 0, 4]},
                    {"image_id": 77, "category_id": 5, "bbox": [1, 2, 3, 4]},
                    {"image_id": 4, "category_id": 5, "bbox": [1, 2, 3, 4]}]})");
  const ImageBoxes boxes = read(file, {"seq/rgb/1.25.png", "seq/rgb/2.png"});
  REQUIRE(boxes.of_image[0].size() == 1);
  CHECK(boxes.of_image[0][0].label == catalog.at("keyboard"));
  CHECK(boxes.empty == 1);
  CHECK(boxes.without_boxes == 1);
  CHECK(boxes.other_images == 2);  // 9.png, and the one that the list of images lacks
  const std::string larger = folder.write("larger.json", R"({
    "images": [{"id": 3, "file_name": "a.png", "width": 1280, "height": 960}],
    "annotations": []})");
  CHECK(error_in(folder, [&] { read(larger, {"a.png"}); }) ==
        "larger.json: image 'a.png' is 1280 x 960 px, the camera's 640 x 480");
}

TEST_CASE("COCO boxes by their corners, and files without a box, are refused",
          "[examples][regression]") {
  const ScratchFolder folder;
  const auto complaint = [&](const std::string& box) {
    folder.write("r.json", R"([{"image_id": "a", "category_id": 72, "bbox": )" + box + "}]");
    return error_in(folder, [&] { read(folder.path("r.json"), {"a.png"}); });
  };
  CHECK(complaint("[500, 300, 620, 400]") ==
        "r.json: a bbox of image 'a' ends at 1120, 700 px, the camera's image at 640, 480; a bbox "
        "is x, y, width, height");
  CHECK(complaint("[500, 300, 200, 200]") == "nothing was thrown");  // partly outside
  for (const std::string text : {"[]", R"({"annotations": []})"}) {
    folder.write("empty.json", text);
    CHECK(error_in(folder, [&] { read(folder.path("empty.json"), {"a.png"}); }) ==
          "empty.json: it holds neither an image nor a box");
  }
}

TEST_CASE("boxes of hardly any width or height are counted as those without",
          "[examples][regression]") {
  const ScratchFolder folder;
  folder.write("a.txt",
               "0 0.5 0.5 1e-12 0.1\n0 0.5 0.5 0.1 1e-12\n0 0.5 0.5 0 0.1\n0 0.5 0.5 0.1 0.1\n");
  const ImageBoxes boxes = read(folder.path(""), {"a.png"});
  CHECK(boxes.empty == 3);
  CHECK(boxes.of_image.at(0).size() == 1);
}
