// SPDX-License-Identifier: MIT
#include "semantic_slam.hpp"

#include <cmath>
#include <exception>
#include <memory>
#include <utility>

#include <topobag/adaptors/orb_slam/drop_features.hpp>

#include <stopwatch.hpp>

#include "feature_depths.hpp"

namespace semantic {

using program::Stopwatch;

SemanticSlam::SemanticSlam(const Settings& settings, topobag::ClassCatalog catalog, Detect detect,
                           Odometry odometry)
    : settings_(settings),
      catalog_(std::move(catalog)),
      detect_(std::move(detect)),
      odometry_(std::move(odometry)),
      database_(
          settings.database, [this](const Frame& frame) { return sight_of_lost(frame); },
          topobag::inertial_gravity<KeyFrame>),
      thread_([this](const Job& job) { work(job); }, settings.thread,
              [this](const Job& job, const std::string& why) {
                if (!job.id) return;
                look_again_ = true;
                give_up(job.epoch, *job.id, why);
              }) {
  if (settings.still) still_.emplace(*settings.still);
}

SemanticSlam::~SemanticSlam() { thread_.stop(); }

void SemanticSlam::FrameMade(Frame& frame, const cv::Mat& rgb, const cv::Mat& depth) {
  current_ = {rgb, depth, frame.mTimeStamp, feature_depths(frame)};
  if (!settings_.mask) return;
  const Stopwatch watch;
  try {
    drop_dynamic_features(frame);
  } catch (const std::exception&) {
    ++masked_.failed;
  }
  records_.took("tracking: mask features", watch.milliseconds());
}

void SemanticSlam::KeyFrameMade(KeyFrame* key_frame) {
  const Stopwatch watch;
  const std::uint64_t epoch = database_.epoch(), id = key_frame->mnId;
  if (key_frame->mTimeStamp != current_.stamp) {  // the first of a monocular map
    return give_up(epoch, id, "its images are those of an earlier frame");
  }
  if (!should_look(*key_frame)) return give_up(epoch, id, "the view hardly changed");
  // The caller may use its images again; the job outlives them.
  Images images{current_.rgb.clone(), current_.depth.clone(), current_.stamp, current_.points};
  if (settings_.map_point_depths) {
    try {
      images.points = map_point_depths(*key_frame);
    } catch (const std::exception& error) {
      look_again_ = true;
      return give_up(epoch, id, error.what());
    }
  }
  thread_.push({epoch, id, std::move(images)});
  records_.took("tracking: hand a key frame over", watch.milliseconds());
}

void SemanticSlam::Added(KeyFrame* key_frame) {
  const Stopwatch watch;
  database_.add(key_frame);
  records_.took("loop closing: add", watch.milliseconds());
}

void SemanticSlam::Erased(KeyFrame* key_frame) {
  if (key_frame->mnId == last_look_) look_again_ = true;
  database_.erase(key_frame);
}

void SemanticSlam::Cleared() {
  look_again_ = true;
  thread_.reset();
  database_.clear();
  lost_.clear();
  places_.clear();
}

void SemanticSlam::ClearedMap(const void* map) {
  if constexpr (topobag::has_maps_v<KeyFrame>) {
    database_.clearMap(static_cast<const host::Map*>(map));
  }
}

void SemanticSlam::LoopCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) {
  const Stopwatch watch;
  const auto places = database_.loop_places(key_frame);
  candidates = topobag::merge_candidates(places, candidates);
  records_.took("loop closing: query", watch.milliseconds());
  records_.offered_for_loops(offers(*key_frame, places));
}

void SemanticSlam::MergeCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) {
  if constexpr (topobag::has_maps_v<KeyFrame>) {
    const Stopwatch watch;
    merges_ = database_.merge_places(key_frame);
    records_.asked_for_merges(!candidates.empty(), !merges_.empty());
    candidates = topobag::merge_candidates(merges_, candidates);
    records_.took("loop closing: query other maps", watch.milliseconds());
    records_.offered_for_merges(offers(*key_frame, merges_));
  }
}

SemanticSlam::Places SemanticSlam::MergePlaces() { return plain(std::exchange(merges_, {})); }

void SemanticSlam::MergePlacesTried(int accepted) { merges_begun_ += accepted >= 0 ? 1U : 0U; }

void SemanticSlam::RelocalizationCandidates(Frame* frame, std::vector<KeyFrame*>& candidates,
                                            const void* map) {
  // While it is lost, no key frame comes. Here the host holds its map's lock: another thread does
  // it.
  if (std::abs(frame->mTimeStamp - last_check_) > 1.0) {
    last_check_ = frame->mTimeStamp;
    thread_.push({});
  }
  const Stopwatch watch;
  graph_ms_ = 0.0;
  by_bearings_ = false;
  places_ = database_.relocalization_places(*frame, static_cast<const host::Map*>(map));
  candidates = topobag::merge_candidates(places_, candidates);
  if (graph_ms_ > 0.0) {
    records_.took(by_bearings_ ? "tracking, lost: query by directions" : "tracking, lost: query",
                  watch.milliseconds() - graph_ms_);
  }
  OfferedPlaces offered;
  offered.stamp = frame->mTimeStamp;
  offered.by_bearings = by_bearings_;
  for (const auto& place : places_) ++(place.verified ? offered.verified : offered.guesses);
  if (offered.verified > 0) offered.T_world_camera = places_.front().T_world_query;
  records_.offered(offered);
}

SemanticSlam::Places SemanticSlam::RelocalizationPlaces() { return plain(places_); }

SemanticSlam::Places SemanticSlam::plain(
    const std::vector<topobag::OrbSlamPlace<KeyFrame>>& places) {
  Places plain;
  for (const auto& place : places) {
    plain.push_back({place.key_frame, place.camera_pose(), static_cast<float>(place.scale)});
  }
  return plain;
}

std::vector<OfferedLoop> SemanticSlam::offers(
    const KeyFrame& key_frame, const std::vector<topobag::OrbSlamPlace<KeyFrame>>& places) const {
  std::vector<OfferedLoop> offered;
  for (const auto& place : places) {
    offered.push_back({key_frame.mTimeStamp, place.key_frame->mTimeStamp, place.T_candidate_query});
  }
  return offered;
}

void SemanticSlam::save(const std::string& path) const {
  topobag::save_sightings(database_.sightings(), path);
}

std::size_t SemanticSlam::load(const std::string& path) {
  return database_.restore(topobag::load_sightings(path));
}

void SemanticSlam::PlacesTried(int accepted) { records_.accepted(accepted); }

/// The last frames in one graph where odometry joins them, else this frame alone, and this frame's
/// directions; nothing for a frame without features.
topobag::LostSight SemanticSlam::sight_of_lost(const Frame& frame) {
  if (frame.mTimeStamp != current_.stamp || frame.N == 0) return std::nullopt;
  const Stopwatch all;
  const auto detections = detect(current_, "tracking, lost: detect");
  const Stopwatch watch;
  auto sighting = std::make_shared<const topobag::KeyframeSighting>(
      topobag::sight_keyframe(current_.stamp, detections, settings_.camera, catalog_));
  const auto pose = odometry_ ? odometry_(frame.mTimeStamp) : std::nullopt;
  if (!pose || settings_.lost_window == 0.0) lost_.clear();
  const double begin = frame.mTimeStamp - settings_.lost_window;
  while (!lost_.empty() && lost_.front().sighting->stamp < begin) lost_.pop_front();
  lost_.push_back({std::move(sighting), pose.value_or(Eigen::Isometry3d::Identity())});
  topobag::LocalGraphOptions fusing = settings_.database.fusing;
  fusing.window = settings_.lost_window;
  topobag::LostSight seen(topobag::fuse_sightings({lost_.begin(), lost_.end()}, fusing),
                          topobag::sight_bearings(detections, settings_.camera, catalog_));
  by_bearings_ = seen.is_without_depth();
  records_.took("tracking, lost: fuse", watch.milliseconds());
  graph_ms_ = all.milliseconds();
  return seen;
}

std::vector<topobag::RangedDetection> SemanticSlam::detect(const Images& images) {
  const std::lock_guard<std::mutex> lock(detect_mutex_);
  return detect_(images);
}

/// The same, with its time noted.
std::vector<topobag::RangedDetection> SemanticSlam::detect(const Images& images,
                                                           const char* stage) {
  const Stopwatch watch;
  std::vector<topobag::RangedDetection> detections = detect(images);
  records_.took(stage, watch.milliseconds());
  return detections;
}

void SemanticSlam::drop_dynamic_features(Frame& frame) {
  const topobag::DynamicFeatureMask mask(detect(current_), catalog_, *settings_.mask);
  std::vector<bool> drop;
  for (int i = 0; i < frame.N; ++i) {
    const auto feature = static_cast<std::size_t>(i);
    const cv::Point2f& pixel = frame.mvKeysUn[feature].pt;  // boxes are undistorted too
    drop.push_back(mask(Eigen::Vector2d(pixel.x, pixel.y), frame.mvDepth[feature]));
  }
  const std::size_t dropped = topobag::drop_features(frame, drop);
  masked_.seen += drop.size();
  masked_.dropped += dropped;
  masked_.frames += dropped > 0 ? 1 : 0;
}

void SemanticSlam::refresh() {
  const Stopwatch watch;
  const std::size_t changed = database_.refresh_changed();
  records_.took("topology thread: what moved?", watch.milliseconds());
  if (changed > 0) records_.took("topology thread: graphs anew", watch.milliseconds());
}

void SemanticSlam::work(const Job& job) {
  refresh();
  if (!job.id) return;
  auto detections = detect(job.images, "topology thread: detect");
  const Stopwatch watch;
  database_.observe(
      job.epoch, *job.id,
      topobag::sight_keyframe(job.images.stamp, std::move(detections), settings_.camera, catalog_));
  records_.took("topology thread: fuse and add", watch.milliseconds());
}

/// Whether the detector has to look at a new key frame. Those after it stand for a look that came
/// to nothing, was culled, or is of another map.
bool SemanticSlam::should_look(KeyFrame& key_frame) {
  if (!still_) return true;
  const void* const map = topobag::map_of(key_frame);
  if (look_again_.exchange(false) || map != still_map_) still_->forget();
  try {
    const auto T_world_camera = topobag::host_pose(key_frame.GetPoseInverse());
    if (!still_->should_look(key_frame.mTimeStamp, T_world_camera)) return false;
  } catch (const std::exception&) {
    still_->forget();  // no pose to compare the next one with
  }
  still_map_ = map;
  last_look_ = key_frame.mnId;
  return true;
}

/// Nothing will be seen in the key frame: loop closing does not wait for it.
void SemanticSlam::give_up(std::uint64_t epoch, std::uint64_t id, const std::string& why) {
  database_.give_up(epoch, id);
  records_.lost(why);
}

}  // namespace semantic
