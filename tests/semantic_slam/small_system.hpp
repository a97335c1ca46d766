// SPDX-License-Identifier: MIT
// The rest of what the program calls of an ORB-SLAM: included by each small host's host.hpp, behind
// its own types.
#pragma once

#include <iostream>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include <topobag/adaptors/orb_slam/host_maps.hpp>

namespace host {

inline constexpr const char* name = "a small SLAM";
using Pose = cv::Mat;  ///< world to camera

struct KeyFrameDatabase {
  topobag_hooks::SemanticHooks<KeyFrame, Frame> semantic;
};

/// Tracks whatever is not black, along x, before a wall at 2.5 units; every frame becomes a key
/// frame. Black images it gets lost in, and then it believes the first place it is told.
class System {
 public:
  enum eSensor { MONOCULAR, STEREO, RGBD };

  System(const std::string&, const std::string&, eSensor sensor, bool) : sensor_(sensor) {}

  Pose TrackRGBD(const cv::Mat& image, const cv::Mat& second, double stamp) {
    return track(image, second, stamp);
  }
  Pose TrackStereo(const cv::Mat& image, const cv::Mat& second, double stamp) {
    return track(image, second, stamp);
  }
  Pose TrackMonocular(const cv::Mat& image, double stamp) { return track(image, {}, stamp); }

  KeyFrameDatabase* GetKeyFrameDatabase() { return &database_; }
  Map* GetMap() { return &map_; }
  void ActivateLocalizationMode() { mapping_ = false; }
  void Shutdown() {}
  /// As the hosts, which refuse to where there is one camera.
  void SaveTrajectoryTUM(const std::string&) {
    if (sensor_ == MONOCULAR) std::cerr << "not for one camera\n";
  }
  void SaveKeyFrameTrajectoryTUM(const std::string&) {}
  bool is_tracking() const { return tracking_; }

 private:
  Pose track(const cv::Mat& image, const cv::Mat& second, double stamp) {
    Frame frame(stamp);
    if (sensor_ == MONOCULAR) frame.mvDepth.assign(frame.mvDepth.size(), -1.0F);
    database_.semantic.FrameMade(frame, image, second);
    if (cv::countNonZero(image.reshape(1)) == 0) {
      tracking_ = false;
      return {};
    }
    if (!tracking_) return relocalize(frame);
    const Eigen::Isometry3d T_world_camera(Eigen::Translation3d(0.1 * stamp, 0.0, 0.0));
    if (mapping_) make_key_frame(stamp, T_world_camera);
    return pose_of(T_world_camera.inverse().matrix().cast<float>());
  }

  Pose relocalize(Frame& frame) {
    const std::lock_guard<std::mutex> lock(map_.mMutexMapUpdate);
    std::vector<KeyFrame*> candidates;
    database_.semantic.RelocalizationCandidates(&frame, candidates,
                                                topobag::has_maps_v<KeyFrame> ? &map_ : nullptr);
    const auto places = database_.semantic.RelocalizationPlaces();
    database_.semantic.PlacesTried(places.empty() ? -1 : 0);
    tracking_ = !places.empty();
    if (!tracking_) return {};
    return pose_of(
        Eigen::Map<const Eigen::Matrix<float, 4, 4, Eigen::RowMajor>>(places.front().Tcw.data()));
  }

  void make_key_frame(double stamp, const Eigen::Isometry3d& T_world_camera) {
    auto made = std::make_unique<KeyFrame>(key_frames_.size(), stamp, T_world_camera, map_);
    for (int u = 5; u < 640; u += 10) {
      for (int v = 5; v < 480; v += 10) {
        made->mvKeysUn.emplace_back(cv::Point2f(static_cast<float>(u), static_cast<float>(v)),
                                    31.0F);
        made->map_points.push_back(&wall_);
      }
    }
    key_frames_.push_back(std::move(made));
    KeyFrame* const key_frame = key_frames_.back().get();
    {
      const std::lock_guard<std::mutex> lock(map_.mMutexMapUpdate);
      database_.semantic.KeyFrameMade(key_frame);
    }
    std::vector<KeyFrame*> candidates;
    database_.semantic.LoopCandidates(key_frame, candidates);
    database_.semantic.Added(key_frame);
  }

  static Pose pose_of(const Eigen::Matrix4f& T) {
    Pose pose(4, 4, CV_32F);
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) pose.at<float>(row, column) = T(row, column);
    }
    return pose;
  }

  const eSensor sensor_;
  bool mapping_ = true, tracking_ = true;
  Map map_;
  MapPoint wall_{position({0.0, 0.0, 2.5})};
  std::vector<std::unique_ptr<KeyFrame>> key_frames_;
  KeyFrameDatabase database_;
};

inline bool is_tracking(System& slam) { return slam.is_tracking(); }

template <typename Database>
void hold_poses(Database& database, System& slam) {
  database.hold_poses_with(slam.GetMap()->mMutexMapUpdate);
}

inline void stop_mapping(System& slam) { slam.ActivateLocalizationMode(); }

}  // namespace host
