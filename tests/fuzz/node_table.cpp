// SPDX-License-Identifier: MIT
// The two files of a node table, parted by a zero byte: refused with an Error, or read.
#include "node_table.hpp"

#include <cmath>

#include "fuzz/fuzz_input.hpp"
#include "scratch_folder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFolder folder;
  const std::string text = FuzzInput(data, size).rest();
  const std::size_t end = std::min(text.find('\0'), text.size());
  folder.write("set.frames.csv", text.substr(0, end));
  folder.write("set.nodes.csv", text.substr(std::min(end + 1, text.size())));
  try {
    for (const program::FrameRow& frame : program::read_node_table(folder.path("set")).frames) {
      require(std::isfinite(frame.timestamp), "a time stamp is finite");
      for (const auto& detection : frame.detections) {
        require(std::isfinite(detection.box.x1), "a box is finite");
      }
    }
  } catch (const topobag::Error&) {
  }
  return 0;
}
