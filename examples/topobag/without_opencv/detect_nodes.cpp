// SPDX-License-Identifier: MIT
#include "detect_nodes.hpp"

#include "input_error.hpp"

namespace program {
namespace {

[[noreturn]] void fail() {
  throw InputError("'nodes' was not built: it needs OpenCV 4.5 or newer; install it, build again");
}

}  // namespace

ImageSize size_of_image(const std::string&) { fail(); }

DetectedNodes detect_nodes(const std::vector<RgbdFrame>&, const DetectionSource&, double,
                           const topobag::PinholeCamera<>&, NodesCheckpoint&) {
  fail();
}

}  // namespace program
