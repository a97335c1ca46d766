// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Geometry>

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/session_number.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {

/// How the entries of another bag come into this one.
struct MergeOptions {
  std::uint32_t session_offset = 0;  ///< added to their sessions
  std::optional<Eigen::Isometry3d>
      T_world_other;  ///< from the other map's world to this one's; moves their poses when set

  /// Throws InvalidValue when `T_world_other` is no rigid motion.
  void validate() const {
    if (T_world_other) require_rigid(*T_world_other, "T_world_other");
  }

  /// What is known of an entry, as it comes in. Throws InvalidId when the sessions run out,
  /// InvalidValue when its pose becomes infinite.
  template <typename Info>
  Info moved(Info info) const {
    info.session = session_after(info.session, session_offset);
    if (T_world_other && info.T_world_camera) {
      info.T_world_camera = *T_world_other * *info.T_world_camera;
    }
    info.validate();
    return info;
  }
};

}  // namespace v0
}  // namespace topobag
