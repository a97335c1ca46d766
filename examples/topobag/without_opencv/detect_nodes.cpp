// SPDX-License-Identifier: MIT
#include "detect_nodes.hpp"

#include "input_error.hpp"

namespace program {

DetectedNodes detect_nodes(const std::vector<RgbdFrame>&, const DetectionSource&, double,
                           topobag::PinholeCamera<>&) {
  throw InputError("'nodes' was not built: it needs OpenCV 4.5 or newer; install it, build again");
}

}  // namespace program
