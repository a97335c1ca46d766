// SPDX-License-Identifier: MIT
#include <string>

#include "catch.hpp"
#include "coco_file.hpp"
#include "scratch.hpp"

using namespace program;

namespace {

const topobag::ClassCatalog coco_classes = topobag::ClassCatalog::coco80();

/// What is said of a file.
std::string coco_complaint(const std::string& text) {
  const ScratchFolder folder;
  return error_in(folder, [&] { read_coco(folder.write("f.json", text), coco_classes); });
}

/// A list of results of one box.
std::string result(const std::string& category, const std::string& box,
                   const std::string& score = "0.5") {
  return R"([{"image_id": 1, "category_id": )" + category + R"(, "bbox": )" + box +
         R"(, "score": )" + score + "}]";
}

}  // namespace

TEST_CASE("COCO results go by COCO's own numbers", "[examples]") {
  const ScratchFolder folder;
  const auto images = read_coco(folder.write("results.json", R"([
    {"image_id": 42, "category_id": 72, "bbox": [10, 20, 30, 40], "score": 0.5},
    {"image_id": "left/7.png", "category_id": 90, "bbox": [0, 0, 1, 1], "score": 0.25},
    {"image_id": 42, "category_id": 1, "bbox": [0, 0, 1, 1], "score": 0.125}])"),
                                coco_classes);
  REQUIRE(images.size() == 2);
  CHECK(images[0].name == "42");
  REQUIRE(images[0].boxes.size() == 2);
  CHECK(images[0].boxes[0].label == coco_classes.at("tv"));
  CHECK(images[0].boxes[0].box.x1 == 9.5);
  CHECK(images[0].boxes[0].box.y2 == 59.5);
  CHECK(images[0].boxes[1].label == coco_classes.at("person"));
  CHECK(images[1].name == "left/7.png");
  CHECK(images[1].boxes[0].label == coco_classes.at("toothbrush"));
}

TEST_CASE("results of other classes go by the catalog's numbers", "[examples]") {
  topobag::ClassCatalog own;
  own.add(topobag::ClassId{0}, "forklift", topobag::Dynamics::high);
  own.add(topobag::ClassId{1}, "tote", topobag::Dynamics::medium);
  const ScratchFolder folder;
  const std::string known = folder.write("known.json", result("1", "[0, 0, 9, 9]"));
  CHECK(read_coco(known, own).at(0).boxes.at(0).label == own.at("tote"));
  for (const std::string category : {"2", "-1", "4294967296", "0.5", "null"}) {
    const std::string odd = folder.write("odd.json", result(category, "[0, 0, 9, 9]"));
    CHECK(error_in(folder, [&] { read_coco(odd, own); }) ==
          "odd.json, entry 1: category " + category +
              " is the number of no class, from 0 to 1; number them so, or give a data set that "
              "lists its categories by name");
  }
}

TEST_CASE("a COCO category that is no whole number of an int is refused",
          "[examples][regression]") {
  for (const std::string category :
       {"3.3e26", "4294967297", "-1", "0", "91", "12", "1.5", "null"}) {
    const std::string error = coco_complaint(result(category, "[0, 0, 9, 9]"));
    CAPTURE(category, error);
    CHECK(error.find("f.json, entry 1: category ") == 0);
    CHECK(error.find(" is none of COCO's") != std::string::npos);
  }
}

TEST_CASE("a COCO box or score of another kind is refused with its entry", "[examples]") {
  for (const std::string score : {"90", "-0.5"}) {
    CHECK(coco_complaint(result("1", "[0, 0, 9, 9]", score)) ==
          "f.json, entry 1: the score has to lie in [0, 1], not " + score);
  }
  for (const std::string box : {"[1, 2, 3]", "[1, 2, 3, 4, 5]", "[1, 2, null, 4]", "7"}) {
    CHECK(coco_complaint(result("1", box)) ==
          "f.json, entry 1: bbox has to be four numbers: x, y, width, height");
  }
  CHECK(coco_complaint(result("1", "[1, 2, -3, 4]")) ==
        "f.json, entry 1: bbox has a negative width or height");
  CHECK(coco_complaint(result("72", "[0.4, 0.35, 0.2, 0.3]")).find("as shares of the image do") !=
        std::string::npos);
  CHECK(coco_complaint(result("1", "[1, 2, 3, 4]", "\"0.9\"")) ==
        "f.json, entry 1: the score has to be a number in [0, 1]");
}

TEST_CASE("what is no COCO file is refused in words of its own", "[examples][regression]") {
  const std::string neither =
      "f.json: it is neither COCO's list of results nor a data set with 'annotations'";
  CHECK(coco_complaint("{}") == neither);
  CHECK(coco_complaint(R"({"predictions": [{"x": 1}]})") == neither);
  CHECK(coco_complaint(R"({"image_id": 1})") == neither);
  CHECK(coco_complaint("{\"annotations\": [") ==
        "f.json: the JSON ends in the middle: the file is cut off; write it anew");
  CHECK(coco_complaint("[1,\n2,\n}") == "f.json: line 3 is no JSON, byte 8 of the file");
  CHECK(coco_complaint("") == "f.json: the file is empty");
  CHECK(coco_complaint(" \n") == "f.json: the file is empty");
  CHECK(coco_complaint("\xFF\xFE[") == "f.json: this is UTF-16: save it as UTF-8");
  CHECK(coco_complaint("[{\"image_id\": 1}]") == "f.json, entry 1: key 'category_id' not found");
}

TEST_CASE("what a data set does not list is not taken for COCO's or for an image's name",
          "[examples][regression]") {
  const std::string lists = R"({"images": [{"id": 1, "file_name": "a.png"}],
    "categories": [{"id": 1, "name": "tv"}], "annotations": [{"bbox": [0, 0, 9, 9], )";
  CHECK(coco_complaint(lists + R"("image_id": 1, "category_id": 2}]})") ==
        "f.json, entry 1: category 2 is not among the file's categories");
  const ScratchFolder folder;
  const std::string file =
      folder.write("f.json", lists + R"("image_id": 100, "category_id": 1}]})");
  CHECK(read_coco(file, coco_classes).at(1).name == "unlisted image_id 100");
}

TEST_CASE("an id of two images or of two categories is refused", "[examples]") {
  CHECK(coco_complaint(R"({"images": [{"id": 3, "file_name": "a.png"},
                                      {"id": "3", "file_name": "b.png"}], "annotations": []})") ==
        "f.json: images gives id 3 to 'a.png' and to 'b.png'");
  CHECK(coco_complaint(R"({"categories": [{"id": 1, "name": "tv"}, {"id": 1.0, "name": "cup"}],
                           "annotations": []})") ==
        "f.json: categories gives id 1 to 'tv' and to 'cup'");
}
