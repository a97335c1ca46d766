// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <topobag/adaptors/fleet/uuid.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/image_descriptor.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {

/// A key frame among those of all robots: where, who, on which run, and the robot's own number.
struct FleetKey {
  std::string site;       ///< the building; its poses share one world
  Uuid robot{};           ///< who saw it
  Uuid session{};         ///< on which run
  KeyframeId keyframe{};  ///< as the robot numbers it

  /// By site, robot, session and number: the order of ties in a `FleetView`.
  friend bool operator<(const FleetKey& l, const FleetKey& r) noexcept {
    return l.fields() < r.fields();
  }
  friend bool operator==(const FleetKey& l, const FleetKey& r) noexcept {
    return l.fields() == r.fields();
  }

 private:
  std::tuple<const std::string&, const Uuid&, const Uuid&, const KeyframeId&> fields()
      const noexcept {
    return std::tie(site, robot, session, keyframe);
  }
};

/// What a robot says of one of its key frames at one moment. Never changed: a moved pose or an
/// erasure is another version, and the one with the greatest `seq` holds.
struct FleetVersion {
  FleetKey key;                 ///< whose it is
  std::int64_t seq = 0;         ///< rises with every change that the robot makes to its map
  std::string run;              ///< the robot's name for the session
  std::optional<double> stamp;  ///< s
  std::string label;            ///< as `EntryInfo::label`
  std::optional<std::array<double, 7>> pose;  ///< tx ty tz qx qy qz qw of `T_world_camera`
  std::vector<std::uint8_t> graph;            ///< as `encode` writes it; empty for a tombstone
  std::uint64_t catalog = 0;                  ///< fingerprint of the classes; 0 = not known
  AppearanceKind appearance;                  ///< of the graph's descriptors
  bool tombstone = false;                     ///< the key frame is erased
  ImageDescriptor image{};                    ///< as `EntryInfo::image`

  /// The entry's info, session 0. Throws InvalidValue as `pose_from_numbers`.
  EntryInfo info() const {
    EntryInfo info;
    info.stamp = stamp;
    info.label = label;
    info.image = image;
    if (pose) info.T_world_camera = pose_from_numbers(*pose);
    return info;
  }
};

/// What a robot says of a key frame that it has just seen; `seq` and what is its run's are still to
/// be said. Throws InvalidValue as `EntryInfo::validate` and `encode`.
template <typename Scalar>
FleetVersion version_of(FleetKey key, const EntryInfo& info, const TopologyGraph<Scalar>& graph) {
  info.validate();
  FleetVersion version;
  version.key = std::move(key);
  version.stamp = info.stamp;
  version.label = info.label;
  version.image = info.image;
  if (info.T_world_camera) {
    const Eigen::Vector3d t = info.T_world_camera->translation();
    const Eigen::Quaterniond q(info.T_world_camera->linear());
    version.pose = {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
  }
  version.graph = encode(graph);
  version.appearance = graph.appearance_kind();
  return version;
}

/// A version as it was read, or why it is none.
struct ReadVersion {
  FleetVersion version;  ///< as far as it could be read
  std::string fault;     ///< a sentence when the row is damaged; else empty
};

}  // namespace v0
}  // namespace topobag
