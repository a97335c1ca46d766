// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "node_table.hpp"

namespace program {

/// What is done to a table's detections before they are used: how much of it does recognition bear?
struct TableStress {
  double depth_noise = 0.0;  ///< r: z becomes z · (1 + r · N(0, 1)); unknown where not positive
  double drop = 0.0;         ///< probability that a detection is dropped
  double flip = 0.0;         ///< probability that its class becomes another of the table's classes,
                             ///< each equally likely
  std::uint32_t seed = 1;
  std::uint32_t stream = 0;  ///< another one for each table of a run: independent numbers

  bool any() const { return depth_noise > 0.0 || drop > 0.0 || flip > 0.0; }
};

/// Applies `stress` to every detection independently. The same on every platform (but for the last
/// bit of a logarithm). A detection draws the same numbers whatever the other settings are, so that
/// runs of one seed compare.
void apply(const TableStress& stress, NodeTable& table);

}  // namespace program
