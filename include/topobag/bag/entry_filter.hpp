// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <topobag/bag/entry_info.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// A ball in the map, where a prior says that the camera is.
struct MapRegion {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< m, world
  double radius = 0.0;                               ///< m

  /// Whether the point (m, world) lies in the ball.
  bool contains(const Eigen::Vector3d& point) const {
    return (point - center).squaredNorm() <= radius * radius;
  }
};

/// A visit that goes on: a session, from a time on. Clocks are compared within a session alone, for
/// another may have started its clock anew.
struct PresentVisit {
  std::uint32_t session = 0;  ///< the present one
  double since = 0.0;  ///< s; what the session holds up to then is an earlier visit

  /// Whether an entry belongs to it: of its session, and not known to be earlier.
  bool contains(const EntryInfo& info) const {
    return info.session == session && !(info.stamp && *info.stamp <= since);
  }
};

/// Which entries of a bag are asked: those that pass every test that is set.
struct EntryFilter {
  KeyframeId min_id{0};                                          ///< the least that is asked
  KeyframeId max_id{std::numeric_limits<std::uint64_t>::max()};  ///< the greatest that is asked
  std::optional<double> min_stamp;      ///< s; with it, entries without a stamp are left out
  std::optional<double> max_stamp;      ///< s; likewise
  std::vector<std::uint32_t> sessions;  ///< any of these; empty = all
  std::vector<std::string> labels;      ///< any of these; empty = all
  std::optional<PresentVisit> not_of;   ///< entries of this visit are left out
  std::optional<MapRegion> region;      ///< of the entries' cameras; those without a pose are out

  /// Whether any test is set.
  bool restricts() const {
    const EntryFilter none;
    return min_id != none.min_id || max_id != none.max_id || min_stamp || max_stamp ||
           !sessions.empty() || !labels.empty() || not_of || region;
  }

  /// Whether the entry passes every test that is set.
  bool contains(KeyframeId id, const EntryInfo& info) const {
    const auto any_of = [](const auto& wanted, const auto& value) {
      return wanted.empty() || std::find(wanted.begin(), wanted.end(), value) != wanted.end();
    };
    if (id < min_id || id > max_id) return false;
    if (min_stamp && !(info.stamp && *info.stamp >= *min_stamp)) return false;
    if (max_stamp && !(info.stamp && *info.stamp <= *max_stamp)) return false;
    if (!any_of(sessions, info.session) || !any_of(labels, info.label)) return false;
    if (not_of && not_of->contains(info)) return false;
    return !region || (info.T_world_camera && region->contains(info.T_world_camera->translation()));
  }
};

}  // namespace v0
}  // namespace topobag
