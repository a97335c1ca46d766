// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <topobag/adaptors/orb_slam/fuse_sightings.hpp>
#include <topobag/adaptors/orb_slam/host_maps.hpp>
#include <topobag/adaptors/orb_slam/host_pose.hpp>
#include <topobag/adaptors/orb_slam/key_frame_pins.hpp>
#include <topobag/adaptors/orb_slam/key_frame_register.hpp>
#include <topobag/adaptors/orb_slam/place.hpp>
#include <topobag/error.hpp>
#include <topobag/recognition/relocalizer.hpp>

namespace topobag {
inline namespace v0 {

/// A bag whose entries are key frames of a host that moves, culls and deletes them meanwhile.
///
/// Any function may be called from any thread. The one lock is a leaf: nothing of the host is
/// called with it held. `erase` and `clear` wait for whoever reads a key frame at that time, so
/// that the host may delete it afterwards; they must not be called with a lock of the host held
/// that `isBad`, `GetPoseInverse`, `GetMap` or the host's word on gravity take.
template <typename KeyFrame>
class KeyFrameBag {
 public:
  using Graph = TopologyGraph<>;
  using Places = std::vector<OrbSlamPlace<KeyFrame>>;

  /// Which way is down in a key frame's camera frame, by what the host knows now; nothing where it
  /// does not know.
  using GravityOf = std::function<std::optional<Gravity<>>(KeyFrame&)>;

  /// Empty, in the first epoch. Without `gravity_of` a sighting's own gravity is all that is known.
  KeyFrameBag(const LocalGraphOptions& fusing, const RecognitionOptions& recognition,
              GravityOf gravity_of = {})
      : fusing_(fusing), gravity_of_(std::move(gravity_of)), relocalizer_(recognition) {}

  /// Goes up with every `clear`.
  std::uint64_t epoch() const {
    const Lock lock(mutex_);
    return known_.epoch();
  }

  /// Key frames that can be found.
  std::size_t size() const {
    const Lock lock(mutex_);
    return relocalizer_.map().size();
  }

  /// What was seen in a key frame of an epoch; false when it was culled or the map reset meanwhile.
  /// Throws InvalidValue, with the node's index, for a stamp, a node or a gravity that a
  /// graph would refuse; then the sighting is not kept.
  bool observe(std::uint64_t epoch, std::uint64_t id, KeyframeSighting sighting) {
    // Here: later it would come up in every graph of its neighbours.
    if (!std::isfinite(sighting.stamp)) throw InvalidValue("the sighting's stamp is not finite");
    static_cast<void>(Graph(sighting.nodes, {}, {}, sighting.gravity));
    {
      const Lock lock(mutex_);
      if (!known_.observe(epoch, id, std::move(sighting))) return false;
    }
    sighted_.notify_all();
    make_entry(id);
    return true;
  }

  /// Nothing will be seen in a key frame of an epoch: the detector failed, or its queue gave it up.
  /// Who waits for it, waits no longer.
  void give_up(std::uint64_t epoch, std::uint64_t id) {
    const Lock lock(mutex_);
    known_.give_up(epoch, id);
    sighted_.notify_all();
  }

  /// The host has a new key frame; nothing when it is bad or was culled.
  void add(KeyFrame& key_frame) {
    if (is_bad(key_frame)) return;
    const std::uint64_t id = key_frame.mnId;
    {
      const Lock lock(mutex_);
      if (!known_.add(id, &key_frame)) return;
    }
    make_entry(id);
  }

  /// The host culls a key frame, whether it was added or not.
  void erase(const KeyFrame& key_frame) {
    const std::uint64_t id = key_frame.mnId;
    Lock lock(mutex_);
    forget(id);
    sighted_.notify_all();
    pins_.wait_for_older(lock);
  }

  /// Erases every key frame of one of several maps; the epoch goes on.
  void erase_map(const void* map) {
    Lock lock(mutex_);
    const auto all = known_.key_frames();
    std::vector<std::uint64_t> gone;
    {
      const KeyFramePins::Scope pinned(pins_, lock);
      for (const auto& [id, key_frame] : all) {
        if (map_of(*key_frame) == map) gone.push_back(id);
      }
    }
    lock.lock();
    for (const std::uint64_t id : gone) forget(id);
    sighted_.notify_all();
    pins_.wait_for_older(lock);
  }

  /// Forgets all key frames; the epoch goes up.
  void clear() {
    Lock lock(mutex_);
    known_.clear();
    relocalizer_.map().clear();
    sighted_.notify_all();  // what they wait for does not come any more
    pins_.wait_for_older(lock);
  }

  /// Makes every graph anew with the host's poses of now. Throws the first error, when the others
  /// are made; a graph that cannot be made stays as it was.
  void refresh() {
    const auto all = [this] {
      const Lock lock(mutex_);
      return known_.key_frames();
    }();
    std::exception_ptr first_error;
    for (const auto& entry : all) {
      try {
        make_entry(entry.first);
      } catch (...) {
        if (!first_error) first_error = std::current_exception();
      }
    }
    if (first_error) std::rethrow_exception(first_error);
  }

  /// The graph of a key frame that the caller keeps alive, added or not; nothing when its sighting
  /// does not come within `wait`, and at once when it is known that it does not come.
  std::optional<Graph> graph_of(KeyFrame& key_frame, std::chrono::milliseconds wait) {
    const std::uint64_t id = key_frame.mnId;
    Lock lock(mutex_);
    const std::uint64_t epoch = known_.epoch();
    sighted_.wait_for(lock, wait,
                      [&] { return known_.epoch() != epoch || known_.is_settled(id); });
    if (known_.epoch() != epoch || !known_.is_sighted(id)) return std::nullopt;
    return fuse(known_.window_of(id, &key_frame, fusing_.window), lock);
  }

  /// Every pose that a candidate offers: verified ones first, then by falling score, ties by id.
  /// Candidates pass the filter of the options' retrieval, which is asked with the lock held.
  ///
  /// @param excluded  key frames that are no candidates
  /// @param newest    s; later ones are none either
  /// @param map       places in another one are marked; null = whatever map
  Places places(const Graph& graph, const std::set<KeyFrame*>& excluded,
                std::optional<double> newest, const void* map) {
    Lock lock(mutex_);
    std::set<KeyframeId> left_out;
    for (const auto& [id, key_frame] : known_.key_frames()) {
      if (excluded.count(key_frame) != 0) left_out.insert(KeyframeId{id});
    }
    RecognitionOptions options = relocalizer_.options();
    const auto& wanted = relocalizer_.options().retrieval.filter;
    options.retrieval.filter = [&](KeyframeId id, const EntryInfo& info) {
      return left_out.count(id) == 0 && (!newest || *info.stamp <= *newest) &&
             (!wanted || wanted(id, info));
    };
    const Recognition recognition = relocalizer_.localize(graph, options);
    std::vector<std::pair<const CandidateReport*, KeyFrame*>> found;
    for (const CandidateReport& report : recognition.candidates) {
      if (report.pose) found.emplace_back(&report, known_.key_frame(value(report.id)));
    }
    const KeyFramePins::Scope pinned(pins_, lock);
    Places places;
    for (const auto& [report, key_frame] : found) {
      if (!is_bad(*key_frame)) detail::append_places(*report, *key_frame, map, places);
    }
    return detail::best_first(places);
  }

 private:
  using Lock = KeyFramePins::Lock;
  using Members = std::vector<SightedKeyFrame<KeyFrame>>;

  void forget(std::uint64_t id) {
    known_.erase(id);
    relocalizer_.map().erase(KeyframeId{id});
  }

  /// Reads the poses and the gravity of now and fuses those of the last one's map. Needs the lock
  /// and releases it.
  Graph fuse(const Members& members, Lock& lock) {
    std::vector<PosedSighting> posed;
    {
      const KeyFramePins::Scope pinned(pins_, lock);
      KeyFrame* const own = members.back().key_frame;
      const void* const map = map_of(*own);
      for (const auto& [sighting, key_frame] : members) {
        if (key_frame != own && (is_bad(*key_frame) || map_of(*key_frame) != map)) continue;
        posed.push_back({sighting, host_pose(key_frame->GetPoseInverse()),
                         gravity_of_ ? gravity_of_(*key_frame) : std::nullopt});
      }
    }
    return fuse_sightings(posed, fusing_);
  }

  /// Puts a key frame into the bag, or its graph anew, once its pointer and its sighting are there.
  void make_entry(std::uint64_t id) {
    Lock lock(mutex_);
    const std::uint64_t epoch = known_.epoch();
    KeyFrame* const key_frame = known_.key_frame(id);
    if (key_frame == nullptr || !known_.is_sighted(id)) return;
    const Members members = known_.window_of(id, key_frame, fusing_.window);
    Graph graph = fuse(members, lock);
    lock.lock();
    if (known_.epoch() != epoch || known_.key_frame(id) == nullptr) return;
    EntryInfo info;
    info.stamp = members.back().sighting->stamp;
    auto& bag = relocalizer_.map();
    if (bag.contains(KeyframeId{id})) {
      bag.update(KeyframeId{id}, std::move(graph), info);
    } else if (graph.is_matchable()) {
      bag.add(KeyframeId{id}, std::move(graph), info);
    }
  }

  const LocalGraphOptions fusing_;
  const GravityOf gravity_of_;
  mutable std::mutex mutex_;
  std::condition_variable sighted_;
  KeyFramePins pins_;
  KeyFrameRegister<KeyFrame> known_;
  Relocalizer<> relocalizer_;
};

}  // namespace v0
}  // namespace topobag
