// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/orb_slam/drop_features.hpp>
#include <topobag/adaptors/orb_slam/host_key_frame.hpp>
#include <topobag/adaptors/orb_slam/key_frame_bag.hpp>
#include <topobag/graph/sight_keyframe.hpp>

namespace topobag {
inline namespace v0 {

/// What the adaptor takes of the library, and how much it offers the host.
struct OrbSlamOptions {
  LocalGraphOptions fusing{};  ///< key frames of `window` s make one graph; 0 = single ones
  /// Retrieval, matching and decision. A filter of the retrieval must not call the data base.
  RecognitionOptions recognition = few_candidates(3);
  std::size_t max_loops = 5;            ///< verified places offered for a loop
  std::size_t max_relocalizations = 5;  ///< places offered to a lost tracker, guesses among them
  double min_loop_gap = 0.0;  ///< s between the key frames of a loop; beside the host's rule that
                              ///< covisible ones make none
  std::chrono::milliseconds loop_wait{200};  ///< a loop query waits this long for a sighting
                                             ///< that was not given up

  /// The defaults, but fewer key frames are matched: tracking waits for the answer.
  static RecognitionOptions few_candidates(std::size_t count) {
    RecognitionOptions options;
    options.retrieval.max_results = count;
    return options;
  }
};

/// The bag of topology graphs beside ORB-SLAM's `KeyFrameDatabase`: under the host's names and
/// signatures, for the host's threads.
///
/// A key frame comes twice, in any order: `observe` brings what the detector saw in it (topology
/// thread), `add` its pointer (loop closing). With both it gets a graph, fused from the key frames
/// of the last seconds with the host's poses of that moment, and can be found. `erase` may come
/// before `add`; ids may restart after `clear`. On locks and lifetimes see `KeyFrameBag`.
///
/// Nothing is thrown at the host: what goes wrong is counted, and ours adds no candidates.
///
/// @tparam KeyFrame  with mnId, mTimeStamp, isBad(), GetPoseInverse() (camera to world),
///                   GetConnectedKeyFrames(); for hosts with several maps GetMap()
/// @tparam Frame     handed to `graph_of_frame` alone
/// @tparam Map       the host's map
template <typename KeyFrame, typename Frame, typename Map>
class OrbSlamDatabase {
 public:
  using Graph = TopologyGraph<>;
  using Place = OrbSlamPlace<KeyFrame>;
  using Places = std::vector<Place>;

  /// The graph of the frame that tracking is lost in, or nothing; called on the tracking thread. A
  /// lost tracker may afford the detector's time.
  using GraphOfFrame = std::function<std::optional<Graph>(const Frame&)>;

  /// Which way is down in a key frame's camera frame, by what the host knows when the key frame's
  /// graph is made; nothing where it does not know. Called on whichever thread makes the graph,
  /// with no lock of ours held. (A lost frame's gravity is a part of its graph.)
  using GravityOfKeyFrame = std::function<std::optional<Gravity<>>(KeyFrame&)>;

  /// Without `graph_of_frame` lost frames find nothing. Without `gravity_of`, or where it says
  /// nothing, a sighting's own gravity is taken.
  explicit OrbSlamDatabase(const OrbSlamOptions& options = {}, GraphOfFrame graph_of_frame = {},
                           GravityOfKeyFrame gravity_of = {})
      : options_(options),
        graph_of_frame_(std::move(graph_of_frame)),
        bag_(options.fusing, options.recognition, std::move(gravity_of)) {}

  /// To be read where a key frame is made, and given to `observe`.
  std::uint64_t epoch() const { return bag_.epoch(); }

  /// What was seen in key frame `id` of that epoch. False when it comes to nothing: the key frame
  /// was culled or the map reset meanwhile.
  bool observe(std::uint64_t epoch, std::uint64_t id, KeyframeSighting sighting) {
    return guarded([&] { return bag_.observe(epoch, id, std::move(sighting)); });
  }

  /// Nothing will be seen in key frame `id` of that epoch: for a topology thread's `OnLost`. Loop
  /// closing then does not wait for it.
  void give_up(std::uint64_t epoch, std::uint64_t id) { bag_.give_up(epoch, id); }

  /// Makes every graph anew with the host's poses of now: for after a loop was closed.
  void refresh() {
    guarded([&] { return bag_.refresh(), true; });
  }

  // ---- As the host's KeyFrameDatabase
  // ------------------------------------------------------------

  /// As `KeyFrameBag::add`.
  void add(KeyFrame* key_frame) {
    static_assert(is_host_key_frame_v<KeyFrame>,
                  "topobag: a host's key frame has mnId, mTimeStamp, isBad(), GetPoseInverse() and "
                  "GetConnectedKeyFrames(), as ORB-SLAM's.");
    guarded([&] { return bag_.add(*key_frame), true; });
  }

  /// As `KeyFrameBag::erase`: returns when nobody reads the key frame any more.
  void erase(KeyFrame* key_frame) { bag_.erase(*key_frame); }
  /// As `KeyFrameBag::clear`: returns when nobody reads a key frame any more.
  void clear() { bag_.clear(); }

  /// ORB-SLAM3's.
  void clearMap(Map* map) {
    static_assert(has_maps_v<KeyFrame>, "topobag: clearMap needs a KeyFrame with GetMap().");
    bag_.erase_map(map);
  }

  /// @param of_the_host  what the host's own database found; see `merge_candidates`. The least BoW
  /// score means nothing to objects.
  std::vector<KeyFrame*> DetectLoopCandidates(KeyFrame* key_frame, float /*minScore*/,
                                              const std::vector<KeyFrame*>& of_the_host = {}) {
    return merge_candidates(loop_places(key_frame), of_the_host);
  }

  /// ORB-SLAM3's. `loops` and `merges` come with what the host found; `count` of ours join each.
  void DetectNBestCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& loops,
                             std::vector<KeyFrame*>& merges, int count) {
    static_assert(has_maps_v<KeyFrame>,
                  "topobag: DetectNBestCandidates needs a KeyFrame with GetMap().");
    Places here, elsewhere;
    for (const Place& place : loop_places(key_frame)) {
      Places& side = place.other_map ? elsewhere : here;
      if (side.size() < static_cast<std::size_t>(std::max(count, 0))) side.push_back(place);
    }
    loops = merge_candidates(here, loops);
    merges = merge_candidates(elsewhere, merges);
  }

  /// In whatever map.
  std::vector<KeyFrame*> DetectRelocalizationCandidates(
      Frame* frame, const std::vector<KeyFrame*>& of_the_host = {}) {
    return merge_candidates(relocalization_places(*frame), of_the_host);
  }

  /// ORB-SLAM3's: in that map alone.
  std::vector<KeyFrame*> DetectRelocalizationCandidates(
      Frame* frame, Map* map, const std::vector<KeyFrame*>& of_the_host = {}) {
    return merge_candidates(relocalization_places(*frame, map), of_the_host);
  }

  // ---- The same with poses
  // -----------------------------------------------------------------------

  /// Verified earlier places of a key frame, best first: none that is covisible with it. The host
  /// keeps `key_frame` alive meanwhile.
  Places loop_places(KeyFrame* key_frame) {
    return guarded([&] {
      const std::optional<Graph> graph = bag_.graph_of(*key_frame, options_.loop_wait);
      if (!graph) return Places{};
      auto excluded = key_frame->GetConnectedKeyFrames();
      excluded.insert(key_frame);
      std::optional<double> newest;
      if (options_.min_loop_gap > 0.0) newest = key_frame->mTimeStamp - options_.min_loop_gap;
      Places places = bag_.places(*graph, excluded, newest, map_of(*key_frame));
      remove_if(places, [](const Place& place) { return !place.verified; });
      return best(std::move(places), options_.max_loops);
    });
  }

  /// Where the lost camera may be: verified places first, then guesses by falling score, for the
  /// host to test.
  Places relocalization_places(const Frame& frame, const Map* map = nullptr) {
    return guarded([&] {
      std::optional<Graph> graph;
      if (graph_of_frame_) graph = graph_of_frame_(frame);
      if (!graph) return Places{};
      Places places = bag_.places(*graph, {}, std::nullopt, map);
      remove_if(places, [](const Place& place) { return place.other_map; });
      return best(std::move(places), options_.max_relocalizations);
    });
  }

  // ---- Counts
  // ------------------------------------------------------------------------------------

  /// Key frames that can be found.
  std::size_t size() const { return bag_.size(); }

  /// Calls that ended in an exception, and what the last one said.
  std::pair<std::size_t, std::string> failures() const {
    const std::lock_guard<std::mutex> lock(failures_mutex_);
    return failures_;
  }

 private:
  /// What `call` returns, or a value of its type that says nothing when it throws.
  template <typename Call>
  auto guarded(Call call) -> decltype(call()) {
    try {
      return call();
    } catch (const std::exception& error) {
      note_failure(error.what());
    } catch (...) {
      note_failure("the call threw something that is not a std::exception");
    }
    return {};
  }

  void note_failure(const char* why) {
    const std::lock_guard<std::mutex> lock(failures_mutex_);
    ++failures_.first;
    failures_.second = why;
  }

  template <typename Condition>
  static void remove_if(Places& places, Condition condition) {
    places.erase(std::remove_if(places.begin(), places.end(), condition), places.end());
  }

  static Places best(Places places, std::size_t count) {
    if (places.size() > count) places.resize(count);
    return places;
  }

  const OrbSlamOptions options_;
  const GraphOfFrame graph_of_frame_;
  KeyFrameBag<KeyFrame> bag_;
  mutable std::mutex failures_mutex_;
  std::pair<std::size_t, std::string> failures_;
};

}  // namespace v0
}  // namespace topobag
