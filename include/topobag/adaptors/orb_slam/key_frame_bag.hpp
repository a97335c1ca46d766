// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <topobag/adaptors/orb_slam/asked_key_frames.hpp>
#include <topobag/adaptors/orb_slam/call_guard.hpp>
#include <topobag/adaptors/orb_slam/host_entries.hpp>
#include <topobag/adaptors/orb_slam/host_reader.hpp>
#include <topobag/adaptors/orb_slam/place.hpp>
#include <topobag/bag/savable_graph.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// A bag whose entries are key frames of a host that moves, culls and deletes them meanwhile.
///
/// Any function may be called from any thread. The one lock is a leaf: nothing of the host is
/// called with it held. `erase` and `clear` wait for whoever reads a key frame at that time, so
/// that the host may delete it afterwards; they must not be called with a lock of the host held
/// that its key frames' functions or its word on gravity take.
///
/// A graph is fused under the host's own lock of its map (`host_map_traits::pose_mutex`, or
/// `hold_poses_with`): `observe`, `add`, `graph_of`, `refresh` and `refresh_changed` must not be
/// called with it held. All else may: ORB-SLAM looks lost frames up under it, and erases some.
template <typename KeyFrame>
class KeyFrameBag {
 public:
  using Graph = TopologyGraph<>;
  using Pointer = host_pointer_t<KeyFrame>;
  using Places = std::vector<OrbSlamPlace<KeyFrame>>;
  using GravityOf = GravityOfHost<KeyFrame>;

  /// Empty, in the first epoch. Without `gravity_of` a sighting's own gravity is all that is known.
  KeyFrameBag(const LocalGraphOptions& fusing, const RecognitionOptions& recognition,
              GravityOf gravity_of = {}, const StaleTolerance& stale = {})
      : host_(fusing, std::move(gravity_of), stale), entries_(recognition) {}

  /// The host's lock of its one map, for hosts whose key frames do not lead to it. Before anything
  /// else is called; it outlives the bag.
  void hold_poses_with(std::mutex& mutex) { host_.hold_poses_with(mutex); }

  /// By what key frames are found at present.
  RecognitionOptions options() const {
    return locked([&] { return entries_.relocalizer().options(); });
  }
  /// From the next query on.
  void set_options(RecognitionOptions to) {
    locked([&] { entries_.set_options(std::move(to)); });
  }
  /// As `HostEntries::copy_of`. Whoever asks the bag waits meanwhile.
  Relocalizer<> copy_of(const void* map) const {
    return locked([&] { return entries_.copy_of(map); });
  }

  /// Goes up with every `clear`.
  std::uint64_t epoch() const {
    return locked([&] { return host_.known().epoch(); });
  }

  /// Key frames that can be found.
  std::size_t size() const {
    return locked([&] { return entries_.size(); });
  }

  /// What was seen in a key frame of an epoch; false when it was culled or the map reset meanwhile.
  /// Throws InvalidValue, with the node's index, for a stamp, a node or a gravity that a
  /// graph would refuse or that could not be saved; then the sighting is not kept.
  bool observe(std::uint64_t epoch, std::uint64_t id, KeyframeSighting sighting) {
    return observe(epoch, {id, 0, std::move(sighting)});
  }

  /// The same of a run that may be an earlier one.
  bool observe(std::uint64_t epoch, SavedSighting saved) {
    // Here: later it would come up in every graph of its neighbours.
    const KeyframeSighting& sighting = saved.sighting;
    if (!std::isfinite(sighting.stamp)) throw InvalidValue("the sighting's stamp is not finite");
    require_savable(Graph(sighting.nodes, {}, {}, sighting.gravity));
    const std::uint64_t id = saved.id;
    Lock lock(mutex_);
    if (!host_.known().observe(epoch, std::move(saved))) return false;
    sighted_.notify_all();
    lock.unlock();
    make_entry(id);
    return true;
  }

  /// What was seen in the key frames that are there, to be saved.
  std::vector<SavedSighting> sightings() const {
    return locked([&] { return host_.known().sightings(); });
  }

  /// The greatest session that was observed; the present one is 0.
  std::uint32_t last_session() const {
    return locked([&] { return host_.known().last_session(); });
  }

  /// Nothing will be seen in a key frame of an epoch: the detector failed, or its queue gave it up.
  /// Who waits for it, waits no longer.
  void give_up(std::uint64_t epoch, std::uint64_t id) {
    const Lock lock(mutex_);
    host_.known().give_up(epoch, id);
    sighted_.notify_all();
  }

  /// The host has a new key frame; nothing when it is bad or was culled.
  void add(Pointer key_frame) {
    if (is_bad(*key_frame)) return;
    const std::uint64_t id = id_of(*key_frame);
    Lock lock(mutex_);
    if (!host_.known().add(id, std::move(key_frame))) return;
    lock.unlock();
    make_entry(id);
  }

  /// The host culls a key frame, whether it was added or not.
  void erase(KeyFrame& key_frame) {
    const std::uint64_t id = id_of(key_frame);
    Lock lock(mutex_);
    forget(id);
    sighted_.notify_all();
    host_.pins().wait_for_older(lock);
  }

  /// Erases every key frame of one of several maps; the epoch goes on.
  void erase_map(const void* map) {
    Lock lock(mutex_);
    const std::vector<std::uint64_t> gone =
        host_.those_that(lock, [&](KeyFrame& key_frame) { return map_of(key_frame) == map; });
    for (const std::uint64_t id : gone) forget(id);
    sighted_.notify_all();
    host_.pins().wait_for_older(lock);
  }

  /// Forgets all key frames; the epoch goes up.
  void clear() {
    Lock lock(mutex_);
    host_.clear();
    entries_.clear();
    sighted_.notify_all();  // what they wait for does not come any more
    host_.pins().wait_for_older(lock);
  }

  /// Makes every graph anew with the host's poses of now. Throws the first error, when the others
  /// are made; a graph that cannot be made stays as it was.
  void refresh() {
    make_entries(locked([&] { return host_.known().ids(); }));
  }

  /// Makes those graphs anew whose key frames moved against each other, were culled or came to
  /// another map since: after a loop, a merge, a change of scale, whether the host tells of it or
  /// not; what was seen stays in its unit (`fuse_sightings`). Moves the others. Returns how many
  /// graphs are new; throws as `refresh`. Some µs for each of the n key frames, and their fusing for
  /// those that changed.
  std::size_t refresh_changed() {
    Lock lock(mutex_);
    const HostChanges changes = host_.changes(lock);
    entries_.move(changes.cameras);
    lock.unlock();
    make_entries(changes.stale);
    return changes.stale.size();
  }

  /// The graph of a key frame that the caller keeps alive, added or not; nothing when its sighting
  /// does not come within `wait`, and at once when it is known that it does not come.
  std::optional<Graph> graph_of(Pointer key_frame, std::chrono::milliseconds wait) {
    const std::uint64_t id = id_of(*key_frame);
    Lock lock(mutex_);
    const std::uint64_t epoch = host_.known().epoch();
    const auto& known = host_.known();
    sighted_.wait_for(lock, wait, [&] { return known.epoch() != epoch || known.is_settled(id); });
    if (known.epoch() != epoch || !known.is_sighted(id)) return std::nullopt;
    std::optional<FusedGraph> fused = host_.fuse(id, std::move(key_frame), lock);
    if (!fused) return std::nullopt;
    return std::move(fused->graph);
  }

  /// Every pose that a candidate offers: verified ones first, then by falling score, ties by id.
  /// Only those asked for compete to be candidates; they pass the filter of the options' retrieval
  /// too, which is asked with the lock held.
  /// @param query  a graph, or a `BearingSighting`
  template <typename Query>
  Places places(const Query& query, const AskedKeyFrames<KeyFrame>& asked) {
    Lock lock(mutex_);
    const std::uint64_t epoch = host_.known().epoch();
    const std::vector<std::uint64_t> among =
        host_.those_that(lock, [&](KeyFrame& key_frame) { return asked.contains(key_frame); });
    if (host_.known().epoch() != epoch) return {};
    const Recognition recognition = entries_.localize(
        query, detail::options_among(entries_.relocalizer().options(), among, asked));
    Places places = host_.places(recognition, asked.map, lock);
    for (auto& place : places) place.by_bearings = std::is_same_v<Query, BearingSighting>;
    return detail::best_first(places);
  }

 private:
  using Lock = KeyFramePins::Lock;

  void forget(std::uint64_t id) {
    host_.erase(id);
    entries_.erase(id);
  }

  template <typename F>
  auto locked(F f) const {
    const Lock lock(mutex_);
    return f();
  }

  void make_entries(const std::vector<std::uint64_t>& ids) {
    detail::call_for_all(ids, [this](std::uint64_t id) { make_entry(id); });
  }

  /// Puts a key frame into the bag, or its graph anew, once its pointer and its sighting are there.
  void make_entry(std::uint64_t id) {
    Lock lock(mutex_);
    const auto& known = host_.known();
    const std::uint64_t epoch = known.epoch();
    const Pointer key_frame = known.key_frame(id);
    if (key_frame == nullptr || !known.is_sighted(id)) return;
    EntryInfo info;
    info.stamp = known.stamp_of(id);
    info.session = known.session_of(id);
    auto fused = host_.fuse(id, key_frame, lock);
    if (!fused) return;
    lock.lock();
    if (known.epoch() != epoch || known.key_frame(id) == nullptr) return;
    entries_.put(id, std::move(fused->graph), std::move(info), fused->window.camera());
    host_.keep(id, std::move(fused->window));
  }

  mutable std::mutex mutex_;
  std::condition_variable sighted_;
  HostReader<KeyFrame> host_;
  HostEntries<> entries_;
};

}  // namespace v0
}  // namespace topobag
