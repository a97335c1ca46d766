// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include <Eigen/Geometry>

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/session_number.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/detail/rescaled.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {

/// How the entries of another bag come into this one. A point of the other map's world is at
/// T_world_other · (scale · point) in this one's: a Sim(3).
struct MergeOptions {
  std::uint32_t session_offset = 0;  ///< added to their sessions
  std::optional<Eigen::Isometry3d>
      T_world_other;   ///< from the other map's world to this one's; moves their poses when set.
                       ///< Without it the two worlds are taken for one
  double scale = 1.0;  ///< units of this map in one of the other's: graphs and poses are scaled

  /// Throws InvalidValue when `T_world_other` is no rigid motion, or `scale` not positive.
  void validate() const {
    if (!(scale > 0.0 && std::isfinite(scale))) {
      throw InvalidValue("a map is scaled by a positive number");
    }
    if (T_world_other) require_rigid(*T_world_other, "T_world_other");
  }

  /// What is known of an entry, as it comes in. Throws InvalidId when the sessions run out,
  /// InvalidValue when its pose becomes infinite.
  template <typename Info>
  Info moved(Info info) const {
    info.session = session_after(info.session, session_offset);
    if (info.T_world_camera) info.T_world_camera->translation() *= scale;
    if (T_world_other && info.T_world_camera) {
      info.T_world_camera = *T_world_other * *info.T_world_camera;
    }
    info.validate();
    return info;
  }

  /// The graph of an entry, in this map's unit; refers to it. Throws as `scaled`.
  template <typename Graph>
  detail::Rescaled<Graph> in_this_unit(const Graph& graph) const {
    return {graph, scale};
  }
};

}  // namespace v0
}  // namespace topobag
