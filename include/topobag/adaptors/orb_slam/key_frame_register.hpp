// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <topobag/adaptors/orb_slam/host_traits.hpp>
#include <topobag/adaptors/orb_slam/saved_sightings.hpp>
#include <topobag/graph/keyframe_sighting.hpp>

namespace topobag {
inline namespace v0 {

/// A sighting and the host's key frame it belongs to.
template <typename KeyFrame>
struct SightedKeyFrame {
  std::uint64_t id = 0;                              ///< the host's
  std::shared_ptr<const KeyframeSighting> sighting;  ///< what was seen in it
  host_pointer_t<KeyFrame> key_frame{};              ///< the host's; a plain pointer owns nothing
};

/// Which key frames the host has, by id, and what was seen in them. Pointer and sighting come
/// in any order; a key frame that is culled before either came stays culled. Not synchronised;
/// every call but `clear` and `sightings` is O(log n), `window_of` O(log n) for each that it gives.
template <typename KeyFrame>
class KeyFrameRegister {
 public:
  using Pointer = host_pointer_t<KeyFrame>;
  using Member = SightedKeyFrame<KeyFrame>;

  /// Goes up with every `clear`, for ids restart then.
  std::uint64_t epoch() const noexcept { return epoch_; }

  /// False when the key frame was culled before.
  bool add(std::uint64_t id, Pointer key_frame) {
    if (culled_.count(id) != 0) return false;
    key_frames_[id] = std::move(key_frame);
    return true;
  }

  /// False when the key frame was culled before, or is of another epoch.
  bool observe(std::uint64_t epoch, SavedSighting saved) {
    if (epoch != epoch_ || culled_.count(saved.id) != 0) return false;
    forget_sighting(saved.id);
    by_stamp_.emplace(saved.session, saved.sighting.stamp, saved.id);
    last_session_ = std::max(last_session_, saved.session);
    sightings_[saved.id] = {std::make_shared<const KeyframeSighting>(std::move(saved.sighting)),
                            saved.session};
    return true;
  }
  /// The same of the present run.
  bool observe(std::uint64_t epoch, std::uint64_t id, KeyframeSighting sighting) {
    return observe(epoch, {id, 0, std::move(sighting)});
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
    const std::uint64_t epoch = epoch_;
    *this = KeyFrameRegister();
    epoch_ = epoch + 1;
  }

  /// All of them, by id.
  const std::map<std::uint64_t, Pointer>& key_frames() const noexcept { return key_frames_; }

  /// Their ids, rising.
  std::vector<std::uint64_t> ids() const {
    std::vector<std::uint64_t> ids;
    for (const auto& entry : key_frames_) ids.push_back(entry.first);
    return ids;
  }

  /// Null when it is not there.
  Pointer key_frame(std::uint64_t id) const {
    const auto found = key_frames_.find(id);
    return found == key_frames_.end() ? Pointer() : found->second;
  }

  /// Whether it was told what was seen in the key frame.
  bool is_sighted(std::uint64_t id) const { return sightings_.count(id) != 0; }

  /// Whether there is nothing to wait for: it is sighted, given up or culled.
  bool is_settled(std::uint64_t id) const {
    return is_sighted(id) || given_up_.count(id) != 0 || culled_.count(id) != 0;
  }

  /// When it was seen, s. Precondition: it is sighted.
  double stamp_of(std::uint64_t id) const { return sightings_.at(id).sighting->stamp; }

  /// The run that saw it; 0 = the present one, also when nobody did.
  std::uint32_t session_of(std::uint64_t id) const {
    const auto found = sightings_.find(id);
    return found == sightings_.end() ? 0 : found->second.session;
  }

  /// The greatest session that was observed.
  std::uint32_t last_session() const noexcept { return last_session_; }

  /// What was seen in every key frame that was sighted and not culled, by id. O(n · nodes).
  std::vector<SavedSighting> sightings() const {
    std::vector<SavedSighting> all;
    for (const auto& [id, seen] : sightings_) all.push_back({id, seen.session, *seen.sighting});
    return all;
  }

  /// The sighted key frames of the same run in the last `window` s before this one, oldest first,
  /// and itself at the end; empty when it was not sighted. `key_frame` need not be registered.
  std::vector<Member> window_of(std::uint64_t id, Pointer key_frame, double window) const {
    std::vector<Member> members;
    const auto own = sightings_.find(id);
    if (own == sightings_.end()) return members;
    const double stamp = own->second.sighting->stamp;
    const std::uint32_t session = own->second.session;
    const auto stamp_of = [](const auto& seen) { return std::get<1>(seen); };
    const auto same_run = [&](const auto& seen) { return std::get<0>(seen) == session; };
    // From a little before: a difference of stamps is rounded.
    auto seen = by_stamp_.lower_bound({session, stamp - window, 0});
    while (seen != by_stamp_.begin() && same_run(*std::prev(seen)) &&
           stamp - stamp_of(*std::prev(seen)) <= window) {
      --seen;
    }
    for (; seen != by_stamp_.end() && same_run(*seen) && stamp_of(*seen) <= stamp; ++seen) {
      const std::uint64_t other = std::get<2>(*seen);
      const auto found = key_frames_.find(other);
      if (other == id || found == key_frames_.end() || stamp - stamp_of(*seen) > window) continue;
      members.push_back({other, sightings_.at(other).sighting, found->second});
    }
    members.push_back({id, own->second.sighting, std::move(key_frame)});
    return members;
  }

 private:
  struct Sighted {
    std::shared_ptr<const KeyframeSighting> sighting;
    std::uint32_t session = 0;
  };

  void forget_sighting(std::uint64_t id) {
    given_up_.erase(id);
    const auto seen = sightings_.find(id);
    if (seen == sightings_.end()) return;
    by_stamp_.erase({seen->second.session, seen->second.sighting->stamp, id});
    sightings_.erase(seen);
  }

  std::uint64_t epoch_ = 0;
  std::uint32_t last_session_ = 0;
  std::map<std::uint64_t, Pointer> key_frames_;
  std::map<std::uint64_t, Sighted> sightings_;
  /// The sighted ones: session, stamp, s, and id.
  std::set<std::tuple<std::uint32_t, double, std::uint64_t>> by_stamp_;
  std::set<std::uint64_t> given_up_, culled_;
};

}  // namespace v0
}  // namespace topobag
