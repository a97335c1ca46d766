// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "node_table.hpp"

namespace program {

/// What was detected in a sequence, or in its beginning.
struct DetectedNodes {
  NodeTable table;
  std::size_t outside = 0;  ///< boxes that span less than a pixel of their image, left out
};

}  // namespace program
