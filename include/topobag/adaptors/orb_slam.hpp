// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/orb_slam/call_guard.hpp>
#include <topobag/adaptors/orb_slam/drop_features.hpp>
#include <topobag/adaptors/orb_slam/host_key_frame.hpp>
#include <topobag/adaptors/orb_slam/inertial_gravity.hpp>
#include <topobag/adaptors/orb_slam/key_frame_bag.hpp>
#include <topobag/adaptors/orb_slam/lost_sight.hpp>
#include <topobag/adaptors/orb_slam/orb_slam_options.hpp>
#include <topobag/adaptors/orb_slam/sightings_file.hpp>
#include <topobag/graph/sight_keyframe.hpp>

namespace topobag {
inline namespace v0 {

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
/// @tparam KeyFrame  read by `host_traits`: as it stands with mnId, mTimeStamp, isBad(),
///                   GetPoseInverse() (camera to world), GetConnectedKeyFrames(); for hosts with
///                   several maps GetMap()
/// @tparam Frame     handed to `graph_of_frame` alone
/// @tparam Map       the host's map
template <typename KeyFrame, typename Frame, typename Map>
class OrbSlamDatabase {
 public:
  using Graph = TopologyGraph<>;
  using Pointer = host_pointer_t<KeyFrame>;  ///< `KeyFrame*`, unless the traits say otherwise
  using Pointers = std::vector<Pointer>;
  using Place = OrbSlamPlace<KeyFrame>;
  using Places = std::vector<Place>;

  /// What is seen in the frame that tracking is lost in, a `std::optional<Graph>` or a `LostSight`;
  /// called on the tracking thread. A lost tracker may afford the detector's time.
  using GraphOfFrame = std::function<LostSight(const Frame&)>;

  /// Which way is down in a key frame's camera frame, by what the host knows when the key frame's
  /// graph is made: `inertial_gravity` is ORB-SLAM3's word. Called on whichever thread makes the
  /// graph, with no lock of ours held. (A lost frame's gravity is a part of its graph.)
  using GravityOfKeyFrame = GravityOfHost<KeyFrame>;

  /// Without `graph_of_frame` lost frames find nothing. Without `gravity_of`, or where it says
  /// nothing, a sighting's own gravity is taken.
  explicit OrbSlamDatabase(const OrbSlamOptions& options = {}, GraphOfFrame graph_of_frame = {},
                           GravityOfKeyFrame gravity_of = {})
      : options_(options),
        graph_of_frame_(std::move(graph_of_frame)),
        bag_(options.fusing, options.recognition, std::move(gravity_of), options.stale) {}

  /// As `KeyFrameBag::hold_poses_with`: graphs are then fused while the host moves nothing.
  void hold_poses_with(std::mutex& mutex) { bag_.hold_poses_with(mutex); }
  /// By what key frames are found at present.
  RecognitionOptions options() const { return bag_.options(); }
  /// From the next query on, from whatever thread: a calibration comes in by this.
  void set_options(RecognitionOptions recognition) { bag_.set_options(std::move(recognition)); }

  /// To be read where a key frame is made, and given to `observe`.
  std::uint64_t epoch() const { return bag_.epoch(); }

  /// What was seen in key frame `id` of that epoch. False when it comes to nothing: the key frame
  /// was culled or the map reset meanwhile.
  bool observe(std::uint64_t epoch, std::uint64_t id, KeyframeSighting sighting) {
    return guarded_([&] { return bag_.observe(epoch, id, std::move(sighting)); });
  }

  /// Nothing will be seen in key frame `id` of that epoch: for a topology thread's `OnLost`. Loop
  /// closing then does not wait for it.
  void give_up(std::uint64_t epoch, std::uint64_t id) { bag_.give_up(epoch, id); }

  /// Makes every graph anew with the host's poses of now. Not with the host's lock of its map held.
  void refresh() {
    guarded_([&] { return bag_.refresh(), true; });
  }

  /// As `KeyFrameBag::refresh_changed`: cheap enough for every key frame. Likewise.
  std::size_t refresh_changed() {
    return guarded_([&] { return bag_.refresh_changed(); });
  }

  // ---- Beside the host's saved map

  /// What was seen in the key frames that are there: for `save_sightings`, when the host saves.
  std::vector<SavedSighting> sightings() const { return bag_.sightings(); }

  /// What `load_sightings` gave, for the map that the host has loaded; before or after its key
  /// frames are added. Those of earlier runs are never the present visit.
  /// @param id_offset  what the host added to the ids of its saved map
  /// @return how many are of key frames that were not culled
  std::size_t restore(std::vector<SavedSighting> saved, std::uint64_t id_offset = 0) {
    const std::uint64_t now = epoch();
    const std::uint32_t before = bag_.last_session() + 1;
    std::size_t taken = 0;
    for (SavedSighting& sighting : saved) {
      sighting.id += id_offset;
      sighting.session += before;
      taken += guarded_([&] { return bag_.observe(now, std::move(sighting)); }) ? 1U : 0U;
    }
    return taken;
  }

  // ---- As the host's KeyFrameDatabase

  /// As `KeyFrameBag::add`.
  void add(Pointer key_frame) {
    static_assert(is_host_key_frame_v<KeyFrame>,
                  "topobag: a host's key frame has mnId, mTimeStamp, isBad(), GetPoseInverse() and "
                  "GetConnectedKeyFrames(), as ORB-SLAM's, or a specialisation of host_traits.");
    guarded_([&] { return bag_.add(std::move(key_frame)), true; });
  }

  /// As `KeyFrameBag::erase`: returns when nobody reads the key frame any more.
  void erase(const Pointer& key_frame) { bag_.erase(*key_frame); }
  /// As `KeyFrameBag::clear`: returns when nobody reads a key frame any more.
  void clear() { bag_.clear(); }

  /// ORB-SLAM3's.
  void clearMap(const Map* map) {
    static_assert(has_maps_v<KeyFrame>, "topobag: clearMap needs a KeyFrame with GetMap().");
    bag_.erase_map(map);
  }

  /// @param of_the_host  what the host's own database found; see `merge_candidates`. The least BoW
  /// score means nothing to objects.
  Pointers DetectLoopCandidates(const Pointer& key_frame, float /*minScore*/,
                                const Pointers& of_the_host = {}) {
    return merge_candidates(loop_places(key_frame), of_the_host);
  }

  /// ORB-SLAM3's. `loops` and `merges` come with what the host found; `count` of ours join each.
  void DetectNBestCandidates(const Pointer& key_frame, Pointers& loops, Pointers& merges,
                             int count) {
    static_assert(has_maps_v<KeyFrame>,
                  "topobag: DetectNBestCandidates needs a KeyFrame with GetMap().");
    const auto most = static_cast<std::size_t>(std::max(count, 0));
    const std::optional<Graph> graph = graph_of(key_frame);
    loops = merge_candidates(best(loop_places(key_frame, graph), most), loops);
    merges = merge_candidates(best(merge_places(key_frame, graph), most), merges);
  }

  /// In whatever map.
  Pointers DetectRelocalizationCandidates(Frame* frame, const Pointers& of_the_host = {}) {
    return merge_candidates(relocalization_places(*frame), of_the_host);
  }

  /// ORB-SLAM3's: in that map alone.
  Pointers DetectRelocalizationCandidates(Frame* frame, Map* map,
                                          const Pointers& of_the_host = {}) {
    return merge_candidates(relocalization_places(*frame, map), of_the_host);
  }

  // ---- The same with poses

  /// Verified earlier places of a key frame in its own map, best first: none that is covisible with
  /// it, nor of the present visit. The host keeps `key_frame` alive meanwhile.
  Places loop_places(const Pointer& key_frame) {
    return loop_places(key_frame, graph_of(key_frame));
  }

  /// Verified places of a key frame in the host's other maps, best first, however long ago.
  Places merge_places(const Pointer& key_frame) {
    static_assert(has_maps_v<KeyFrame>, "topobag: merge_places needs a KeyFrame with GetMap().");
    return merge_places(key_frame, graph_of(key_frame));
  }

  /// Where the lost camera may be: verified places first, then guesses by falling score, for the
  /// host to test; in that map alone, where one is given. By the objects' directions where too few
  /// have a depth (`LostSight`). May be called with the host's lock of its map held.
  Places relocalization_places(const Frame& frame, const Map* map = nullptr) {
    return guarded_([&] {
      LostSight seen;
      if (graph_of_frame_) seen = graph_of_frame_(frame);
      AskedKeyFrames<KeyFrame> asked;
      asked.map = map;
      if (map != nullptr) asked.maps = AskedMaps::this_one;
      const std::size_t most = options_.max_relocalizations;
      if (seen.is_without_depth()) return best(bag_.places(*seen.bearings, asked), most);
      return seen.graph ? best(bag_.places(*seen.graph, asked), most) : Places{};
    });
  }

  /// As `KeyFrameBag::copy_of`: what is found in one of the host's maps, to calibrate by.
  Relocalizer<> copy_of(const Map* map = nullptr) const { return bag_.copy_of(map); }
  /// Key frames that can be found.
  std::size_t size() const { return bag_.size(); }
  /// Calls that ended in an exception, and what the last one said.
  std::pair<std::size_t, std::string> failures() const { return guarded_.failures(); }

 private:
  std::optional<Graph> graph_of(const Pointer& key_frame) {
    return guarded_([&] { return bag_.graph_of(key_frame, options_.loop_wait); });
  }

  Places loop_places(const Pointer& key_frame, const std::optional<Graph>& graph) {
    AskedKeyFrames<KeyFrame> asked;
    if constexpr (has_maps_v<KeyFrame>) asked.maps = AskedMaps::this_one;
    const double stamp = static_cast<double>(host_traits<KeyFrame>::stamp(*key_frame));
    if (options_.min_loop_gap > 0.0) asked.not_of = {0, stamp - options_.min_loop_gap};
    return verified_places(key_frame, graph, std::move(asked));
  }

  Places merge_places(const Pointer& key_frame, const std::optional<Graph>& graph) {
    AskedKeyFrames<KeyFrame> asked;
    asked.maps = AskedMaps::others;
    return verified_places(key_frame, graph, std::move(asked));
  }

  Places verified_places(const Pointer& key_frame, const std::optional<Graph>& graph,
                         AskedKeyFrames<KeyFrame> asked) {
    if (!graph) return {};
    return guarded_([&] {
      asked.map = map_of(*key_frame);
      asked.leave_out(*key_frame);
      Places places = bag_.places(*graph, asked);
      const auto is_guess = [](const Place& place) { return !place.verified; };
      places.erase(std::remove_if(places.begin(), places.end(), is_guess), places.end());
      return best(std::move(places), options_.max_loops);
    });
  }

  static Places best(Places places, std::size_t count) {
    if (places.size() > count) places.resize(count);
    return places;
  }

  const OrbSlamOptions options_;
  const GraphOfFrame graph_of_frame_;
  KeyFrameBag<KeyFrame> bag_;
  CallGuard guarded_;
};

}  // namespace v0
}  // namespace topobag
