// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "draws.hpp"
#include "node_table.hpp"

namespace program {

/// How a table's frames know which way is down: as an accelerometer beside the camera would tell.
struct TableGravity {
  std::optional<Eigen::Vector3d> world_up;  ///< which way is up in the table's world, of any length
                                            ///< but 0; nothing: no frame knows
  double noise = 1.0;  ///< °; standard deviation of the tilt about each horizontal axis
};

/// Tells every frame with a pose which way is down in its camera's frame, and nothing else of the
/// pose. The direction is tilted by the noise, which is also the deviation that is stated, but for
/// 0.1° at least. A frame draws the same numbers whatever the noise is and whichever frames are
/// used.
void apply(const TableGravity& gravity, Draws draws, NodeTable& table);

}  // namespace program
