// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <topobag/graph/keyframe_sighting.hpp>

namespace topobag {
inline namespace v0 {

/// A sighting and the host's key frame it belongs to.
template <typename KeyFrame>
struct SightedKeyFrame {
  std::shared_ptr<const KeyframeSighting> sighting;  ///< what was seen in it
  KeyFrame* key_frame = nullptr;                     ///< the host's; not owned
};

/// Which key frames the host has, by `mnId`, and what was seen in them. Pointer and sighting come
/// in any order; a key frame that is culled before either came stays culled. Not synchronised; every
/// call but `clear` is O(log n), `window_of` O(log n) for each that it gives.
template <typename KeyFrame>
class KeyFrameRegister {
 public:
  using Member = SightedKeyFrame<KeyFrame>;

  /// Goes up with every `clear`, for ids restart then.
  std::uint64_t epoch() const noexcept { return epoch_; }

  /// False when the key frame was culled before.
  bool add(std::uint64_t id, KeyFrame* key_frame) {
    if (culled_.count(id) != 0) return false;
    key_frames_[id] = key_frame;
    return true;
  }

  /// False when the key frame was culled before, or is of another epoch.
  bool observe(std::uint64_t epoch, std::uint64_t id, KeyframeSighting sighting) {
    if (epoch != epoch_ || culled_.count(id) != 0) return false;
    forget_sighting(id);
    by_stamp_.emplace(sighting.stamp, id);
    sightings_[id] = std::make_shared<const KeyframeSighting>(std::move(sighting));
    return true;
  }

  /// Nobody will say what was seen in the key frame, unless `observe` does after all.
  void give_up(std::uint64_t epoch, std::uint64_t id) {
    if (epoch == epoch_ && !is_sighted(id)) given_up_.insert(id);
  }

  /// Forgets a key frame for this epoch, whether it was there or not.
  void erase(std::uint64_t id) {
    culled_.insert(id);
    key_frames_.erase(id);
    forget_sighting(id);
  }

  /// Forgets everything; the epoch goes up.
  void clear() {
    ++epoch_;
    culled_.clear();
    given_up_.clear();
    key_frames_.clear();
    by_stamp_.clear();
    sightings_.clear();
  }

  /// All of them, by `mnId`.
  const std::map<std::uint64_t, KeyFrame*>& key_frames() const noexcept { return key_frames_; }

  /// Null when it is not there.
  KeyFrame* key_frame(std::uint64_t id) const {
    const auto found = key_frames_.find(id);
    return found == key_frames_.end() ? nullptr : found->second;
  }

  /// Whether it was told what was seen in the key frame.
  bool is_sighted(std::uint64_t id) const { return sightings_.count(id) != 0; }

  /// Whether there is nothing to wait for: it is sighted, given up or culled.
  bool is_settled(std::uint64_t id) const {
    return is_sighted(id) || given_up_.count(id) != 0 || culled_.count(id) != 0;
  }

  /// The sighted key frames of the last `window` s before this one, oldest first, and itself at the
  /// end; empty when it was not sighted. `key_frame` need not be registered.
  std::vector<Member> window_of(std::uint64_t id, KeyFrame* key_frame, double window) const {
    std::vector<Member> members;
    const auto own = sightings_.find(id);
    if (own == sightings_.end()) return members;
    const double stamp = own->second->stamp;
    // From a little before: a difference of stamps is rounded.
    auto seen = by_stamp_.lower_bound({stamp - window, 0});
    while (seen != by_stamp_.begin() && stamp - std::prev(seen)->first <= window) --seen;
    for (; seen != by_stamp_.end() && seen->first <= stamp; ++seen) {
      const auto found = key_frames_.find(seen->second);
      if (seen->second == id || found == key_frames_.end() || stamp - seen->first > window) continue;
      members.push_back({sightings_.at(seen->second), found->second});
    }
    members.push_back({own->second, key_frame});
    return members;
  }

 private:
  void forget_sighting(std::uint64_t id) {
    given_up_.erase(id);
    const auto seen = sightings_.find(id);
    if (seen == sightings_.end()) return;
    by_stamp_.erase({seen->second->stamp, id});
    sightings_.erase(seen);
  }

  std::uint64_t epoch_ = 0;
  std::map<std::uint64_t, KeyFrame*> key_frames_;
  std::map<std::uint64_t, std::shared_ptr<const KeyframeSighting>> sightings_;
  std::set<std::pair<double, std::uint64_t>> by_stamp_;  ///< the sighted ones: stamp, s, and id
  std::set<std::uint64_t> given_up_, culled_;
};

}  // namespace v0
}  // namespace topobag
