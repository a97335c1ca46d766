// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include <host.hpp>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/adaptors/topology_thread.hpp>
#include <topobag/sensing/dynamic_feature_mask.hpp>
#include <topobag/sensing/sparse_depth.hpp>
#include <topobag/sensing/still_view.hpp>

#include "slam_records.hpp"

namespace semantic {

/// The images of one frame, and what the host made of them.
struct Images {
  cv::Mat rgb;
  cv::Mat depth;                              ///< or the right one; empty: there is one camera
  double stamp = 0.0;                         ///< s
  std::vector<topobag::DepthPoint> points{};  ///< features whose depth the host knows, undistorted
};

/// What is seen in images, undistorted, with depths. Called on the topology thread and, when
/// tracking is lost or features are masked, on tracking's, not on both at a time.
using Detect = std::function<std::vector<topobag::RangedDetection>(const Images&)>;

/// Where odometry says a lost camera is, in a frame of its own; nothing = it does not know.
using Odometry = std::function<std::optional<Eigen::Isometry3d>(double stamp)>;

struct Settings {
  topobag::PinholeCamera<> camera;
  topobag::OrbSlamOptions database =
      topobag::orb_slam_options(topobag::ClassCatalog::coco80());  ///< of another catalog: its own
  topobag::TopologyThreadOptions thread{};
  double lost_window = 0.0;  ///< s of frames of a lost camera that are fused by odometry
  /// A monocular host: it knows the depths of its key frames' map points alone, in its own unit.
  bool map_point_depths = false;
  /// Key frames whose view hardly changed are not looked at and hold no objects; lengths are in the
  /// host's unit.
  std::optional<topobag::StillViewOptions> still{};
  /// Drops the features on dynamic boxes from every frame before it is tracked; needs a detector
  /// that answers at the camera's pace.
  std::optional<topobag::DynamicFeatureOptions> mask{};
};

/// What the mask dropped.
struct MaskedFeatures {
  std::size_t frames = 0;  ///< with a feature dropped
  std::size_t dropped = 0;
  std::size_t seen = 0;    ///< features of all frames
  std::size_t failed = 0;  ///< frames left whole because of an exception
};

/// The semantic topology graph thread and the bag beside an ORB-SLAM2 or an ORB-SLAM3.
class SemanticSlam final : public topobag_hooks::SemanticObserver<host::KeyFrame, host::Frame> {
 public:
  using KeyFrame = host::KeyFrame;
  using Frame = host::Frame;

  SemanticSlam(const Settings& settings, topobag::ClassCatalog catalog, Detect detect,
               Odometry odometry = {});
  ~SemanticSlam() override;

  void FrameMade(Frame& frame, const cv::Mat& rgb, const cv::Mat& depth) override;
  void KeyFrameMade(KeyFrame* key_frame) override;
  void Added(KeyFrame* key_frame) override;
  void Erased(KeyFrame* key_frame) override;
  void Cleared() override;
  void ClearedMap(const void* map) override;
  void LoopCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) override;
  void MergeCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) override;
  Places MergePlaces() override;
  void RelocalizationCandidates(Frame* frame, std::vector<KeyFrame*>& candidates,
                                const void* map) override;
  Places RelocalizationPlaces() override;
  void PlacesTried(int accepted) override;
  void MergePlacesTried(int accepted) override;

  /// Before an observer is set: the lock under which the host moves its one map.
  void hold_poses_with(std::mutex& mutex) { database_.hold_poses_with(mutex); }

  /// What was seen, beside the map that the host saves; and back, for the map that it has loaded.
  void save(const std::string& path) const;
  std::size_t load(const std::string& path);

  /// Returns when the topology thread has nothing left to do; ends it. Before the host's shutdown.
  void wait_idle() { thread_.wait_idle(); }
  void stop() { thread_.stop(); }

  std::size_t size() const { return database_.size(); }
  topobag::TopologyThreadCounts counts() const { return thread_.counts(); }
  /// How many key frames failed or were given up, by the reason.
  std::map<std::string, std::size_t> lost_key_frames() const { return records_.lost_key_frames(); }
  std::pair<std::size_t, std::string> failures() const { return database_.failures(); }
  MaskedFeatures masked_features() const { return masked_; }  ///< on tracking's thread
  std::vector<OfferedLoop> offered_loops() const { return records_.loops(); }
  /// The same for the host's other maps.
  std::vector<OfferedLoop> offered_merges() const { return records_.merges(); }
  MergeQueries merge_queries() const { return records_.merge_queries(); }
  std::vector<OfferedPlaces> offered_places() const { return records_.places(); }
  std::size_t merges_begun() const { return merges_begun_; }  ///< from object poses

  /// How long each stage took, ms, by name, a value a call.
  SlamRecords::Times times() const { return records_.times(); }

 private:
  struct Job {
    std::uint64_t epoch = 0;
    std::optional<std::uint64_t> id;  ///< none: only the graphs are looked after
    Images images;
  };

  topobag::LostSight sight_of_lost(const Frame& frame);
  std::vector<topobag::RangedDetection> detect(const Images& images);
  std::vector<topobag::RangedDetection> detect(const Images& images, const char* stage);
  void drop_dynamic_features(Frame& frame);
  void refresh();
  bool should_look(KeyFrame& key_frame);
  void give_up(std::uint64_t epoch, std::uint64_t id, const std::string& why);
  static Places plain(const std::vector<topobag::OrbSlamPlace<KeyFrame>>& places);
  std::vector<OfferedLoop> offers(const KeyFrame& key_frame,
                                  const std::vector<topobag::OrbSlamPlace<KeyFrame>>& places) const;
  void work(const Job& job);

  const Settings settings_;
  const topobag::ClassCatalog catalog_;
  const Detect detect_;
  const Odometry odometry_;

  // Tracking's alone.
  Images current_;
  std::deque<topobag::PosedSighting> lost_;
  std::vector<topobag::OrbSlamPlace<KeyFrame>> places_;
  double graph_ms_ = 0.0;     ///< what the last lost frame's graph took; 0 = it has none
  bool by_bearings_ = false;  ///< whether the last lost frame has its directions alone
  MaskedFeatures masked_;
  std::optional<topobag::StillView> still_;
  const void* still_map_ = nullptr;  ///< of several: that of the last look

  double last_check_ = 0.0;  ///< s; stamp of the lost frame at which the graphs were looked after

  // Loop closing's alone.
  std::vector<topobag::OrbSlamPlace<KeyFrame>> merges_;

  SlamRecords records_;
  std::atomic<std::size_t> merges_begun_{0};
  std::atomic<std::uint64_t> last_look_{0};  ///< the key frame
  std::atomic<bool> look_again_{false};      ///< the last look came to nothing
  std::mutex detect_mutex_;
  topobag::OrbSlamDatabase<KeyFrame, Frame, host::Map> database_;
  topobag::TopologyThread<Job> thread_;
};

}  // namespace semantic
