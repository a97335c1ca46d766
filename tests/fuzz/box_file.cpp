// SPDX-License-Identifier: MIT
// Text that claims to be a YOLO file or COCO's JSON: refused with an Error, or read.
#include "box_files.hpp"

#include "fuzz/fuzz_input.hpp"
#include "scratch_folder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFolder json, yolo;
  static const topobag::ClassCatalog catalog = topobag::ClassCatalog::coco80();
  static const std::vector<topobag::ClassId> classes{catalog.at("person"), catalog.at("tv")};
  FuzzInput input(data, size);
  const bool is_json = input.below(2) == 0;
  const std::string text = input.rest();
  try {
    const std::string path = is_json ? json.write("boxes.json", text) : yolo.path();
    if (!is_json) yolo.write("image.txt", text);
    program::read_boxes(path, classes, catalog, 640, 480);
  } catch (const topobag::Error&) {
  }
  return 0;
}
