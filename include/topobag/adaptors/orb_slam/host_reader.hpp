// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <topobag/adaptors/orb_slam/fused_window.hpp>
#include <topobag/adaptors/orb_slam/host_state.hpp>
#include <topobag/adaptors/orb_slam/key_frame_pins.hpp>
#include <topobag/adaptors/orb_slam/key_frame_register.hpp>
#include <topobag/adaptors/orb_slam/place.hpp>
#include <topobag/recognition/recognition.hpp>

namespace topobag {
inline namespace v0 {

/// A graph, and what it was fused from.
struct FusedGraph {
  TopologyGraph<> graph;  ///< of its last key frame
  FusedWindow window;     ///< the key frames, where they stood
};

/// What the host's word of now changes.
struct HostChanges {
  std::vector<std::uint64_t> stale;             ///< rising; their graphs are to be made anew
  std::map<std::uint64_t, HostCamera> cameras;  ///< where the others stand, moved or not
};

/// The key frames a host has, and the graphs that are fused from what it says of them.
///
/// Every function needs the lock of the mutex that guards it; those that ask the host release it
/// meanwhile, with the key frames pinned.
template <typename KeyFrame>
class HostReader {
 public:
  using Lock = KeyFramePins::Lock;
  using Pointer = host_pointer_t<KeyFrame>;

  /// Of no key frames. Without `gravity_of` a sighting's own gravity is all that is known.
  HostReader(const LocalGraphOptions& fusing, GravityOfHost<KeyFrame> gravity_of,
             const StaleTolerance& stale)
      : fusing_(fusing), gravity_of_(std::move(gravity_of)), stale_(stale) {}

  /// The host's lock of its one map. Before anything else is called, without the lock.
  void hold_poses_with(std::mutex& mutex) { pose_mutex_ = &mutex; }

  /// The key frames and what was seen in them.
  KeyFrameRegister<KeyFrame>& known() { return known_; }
  /// The same, to be read.
  const KeyFrameRegister<KeyFrame>& known() const { return known_; }
  /// Who reads them.
  KeyFramePins& pins() { return pins_; }

  /// The ids, rising, of the key frames for which `holds` is true, which may call the host.
  template <typename Holds>
  std::vector<std::uint64_t> those_that(Lock& lock, Holds holds) {
    auto all = known_.key_frames();
    std::vector<std::uint64_t> ids;
    {
      const KeyFramePins::Scope pinned(pins_, lock);
      for (const auto& [id, key_frame] : all) {
        if (holds(*key_frame)) ids.push_back(id);
      }
    }
    all.clear();  // without the lock: it may be the last owner
    lock.lock();
    return ids;
  }

  /// The sighted key frames whose graph was never made, or would become another one by what the
  /// host says now, and where those stand whose graph remains; none when the epoch ends meanwhile.
  HostChanges changes(Lock& lock) {
    const std::uint64_t epoch = known_.epoch();
    auto all = known_.key_frames();
    std::map<std::uint64_t, HostKeyFrameState> now;
    {
      const KeyFramePins::Scope pinned(pins_, lock);
      for (const auto& [id, key_frame] : all) now[id] = host_state(*key_frame, gravity_of_);
    }
    all.clear();
    lock.lock();
    HostChanges changes;
    if (known_.epoch() != epoch) return changes;
    for (const auto& [id, state] : now) {
      if (state.is_bad) continue;
      if (is_stale(id, now)) {
        changes.stale.push_back(id);
      } else if (state.is_readable) {
        changes.cameras.emplace(id, HostCamera{state.map, state.T_world_camera});
      }
    }
    return changes;
  }

  /// The graph of a sighted key frame, registered or not, from those of its map; nothing when it is
  /// erased or the epoch ends meanwhile. Reads the poses and the gravity of now under the host's
  /// lock of its map; ours is not held afterwards. Nothing is pinned while that lock is waited for:
  /// the host may erase key frames with it held. Throws as `read_window` and `fuse_sightings`.
  std::optional<FusedGraph> fuse(std::uint64_t id, Pointer key_frame, Lock& lock) {
    const std::uint64_t epoch = known_.epoch();
    const bool registered = known_.key_frame(id) == key_frame;
    std::vector<PosedSighting> posed;
    FusedWindow window;
    while (true) {
      const bool is_gone = registered && known_.key_frame(id) != key_frame;
      const auto members = known_.window_of(id, key_frame, fusing_.window);
      if (known_.epoch() != epoch || is_gone || members.empty()) {
        lock.unlock();
        return std::nullopt;
      }
      {
        const KeyFramePins::Scope pinned(pins_, lock);
        if (detail::try_with_poses_held(*key_frame, pose_mutex_, [&] {
              read_window(members, gravity_of_, posed, window);
            })) {
          break;
        }
      }
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      lock.lock();
    }
    return FusedGraph{fuse_sightings(posed, fusing_), std::move(window)};
  }

  /// Every pose that candidates offer which are not bad, from where the host has them now; the lock
  /// is not held afterwards. Precondition: they are registered.
  /// @param map  places in another one are marked; null = whatever map
  std::vector<OrbSlamPlace<KeyFrame>> places(const Recognition& recognition, const void* map,
                                             Lock& lock) {
    std::vector<std::pair<const CandidateReport*, Pointer>> found;
    for (const CandidateReport& report : recognition.candidates) {
      if (report.pose) found.emplace_back(&report, known_.key_frame(value(report.id)));
    }
    const KeyFramePins::Scope pinned(pins_, lock);
    std::vector<OrbSlamPlace<KeyFrame>> places;
    for (const auto& [report, key_frame] : found) {
      if (!is_bad(*key_frame)) detail::append_places(*report, key_frame, map, places);
    }
    return places;
  }

  /// The key frame's graph was made from this.
  void keep(std::uint64_t id, FusedWindow window) { fused_[id] = std::move(window); }

  /// As `KeyFrameRegister::erase`.
  void erase(std::uint64_t id) {
    known_.erase(id);
    fused_.erase(id);
  }

  /// As `KeyFrameRegister::clear`.
  void clear() {
    known_.clear();
    fused_.clear();
  }

 private:
  bool is_stale(std::uint64_t id, const std::map<std::uint64_t, HostKeyFrameState>& now) const {
    const Pointer key_frame = known_.key_frame(id);
    if (key_frame == nullptr || !known_.is_sighted(id)) return false;
    const auto fused = fused_.find(id);
    if (fused == fused_.end()) return true;
    FusedWindow window;
    for (const auto& member : known_.window_of(id, key_frame, fusing_.window)) {
      const auto state = now.find(member.id);
      if (state == now.end()) return true;  // it came meanwhile
      if (member.id != id && !state->second.joins(now.at(id))) continue;
      if (!state->second.is_readable) return true;
      window.add(member.id, state->second.T_world_camera, state->second.gravity);
    }
    return fused->second.differs_from(window, stale_);
  }

  const LocalGraphOptions fusing_;
  const GravityOfHost<KeyFrame> gravity_of_;
  const StaleTolerance stale_;
  std::mutex* pose_mutex_ = nullptr;
  KeyFramePins pins_;
  KeyFrameRegister<KeyFrame> known_;
  std::map<std::uint64_t, FusedWindow> fused_;  ///< of what the graphs were made
};

}  // namespace v0
}  // namespace topobag
