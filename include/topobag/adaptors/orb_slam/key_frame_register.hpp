// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
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
/// in any order; a key frame that is culled before either came stays culled. Not synchronised.
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
    sightings_[id] = std::make_shared<const KeyframeSighting>(std::move(sighting));
    return true;
  }

  /// Forgets a key frame for this epoch, whether it was there or not.
  void erase(std::uint64_t id) {
    culled_.insert(id);
    key_frames_.erase(id);
    sightings_.erase(id);
  }

  /// Forgets everything; the epoch goes up.
  void clear() {
    ++epoch_;
    culled_.clear();
    key_frames_.clear();
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

  /// The sighted key frames of the last `window` s before this one, oldest first, and itself at the
  /// end; empty when it was not sighted. `key_frame` need not be registered. O(key frames).
  std::vector<Member> window_of(std::uint64_t id, KeyFrame* key_frame, double window) const {
    std::vector<Member> members;
    const auto own = sightings_.find(id);
    if (own == sightings_.end()) return members;
    for (const auto& [other, pointer] : key_frames_) {
      const auto seen = sightings_.find(other);
      if (other == id || seen == sightings_.end()) continue;
      const double age = own->second->stamp - seen->second->stamp;
      if (age >= 0.0 && age <= window) members.push_back({seen->second, pointer});
    }
    std::stable_sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
      return a.sighting->stamp < b.sighting->stamp;
    });
    members.push_back({own->second, key_frame});
    return members;
  }

 private:
  std::uint64_t epoch_ = 0;
  std::map<std::uint64_t, KeyFrame*> key_frames_;
  std::map<std::uint64_t, std::shared_ptr<const KeyframeSighting>> sightings_;
  std::set<std::uint64_t> culled_;
};

}  // namespace v0
}  // namespace topobag
