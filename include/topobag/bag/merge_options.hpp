// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Geometry>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// How the entries of another bag come into this one.
struct MergeOptions {
  std::uint32_t session_offset = 0;  ///< added to their sessions
  std::optional<Eigen::Isometry3d>
      T_world_other;  ///< from the other map's world to this one's; moves their poses when set
};

}  // namespace v0
}  // namespace topobag
