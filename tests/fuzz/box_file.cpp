// SPDX-License-Identifier: MIT
// Text that claims to be a YOLO file or COCO's JSON: refused with an Error, or read.
#include "box_files.hpp"

#include "fuzz/fuzz_input.hpp"
#include "scratch_folder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFolder json, yolo;
  static const program::BoxReading reading{
      {topobag::ClassId{0}, topobag::ClassId{62}}, topobag::ClassCatalog::coco80(), 640, 480};
  FuzzInput input(data, size);
  const bool is_json = input.below(2) == 0;
  const std::string text = input.rest();
  try {
    const std::string path = is_json ? json.write("boxes.json", text) : yolo.path();
    if (!is_json) yolo.write("image.txt", text);
    program::read_boxes(path, {"left/1.png", "image.png"}, reading);
  } catch (const topobag::Error&) {
  }
  return 0;
}
