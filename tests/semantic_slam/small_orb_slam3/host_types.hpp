// SPDX-License-Identifier: MIT
// What the hooks of ORB-SLAM3 call of it, on types of our own: under the names that they include.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "../small_matches.hpp"

namespace Sophus {

template <typename S>
struct SE3 {
  using Quaternion = Eigen::Quaternion<S>;
  using Vector = Eigen::Matrix<S, 3, 1>;

  SE3() = default;
  SE3(const Quaternion& rotation, const Vector& translation) : q(rotation), t(translation) {}

  template <typename Other>
  SE3<Other> cast() const {
    return {q.template cast<Other>(), t.template cast<Other>()};
  }
  Quaternion unit_quaternion() const { return q; }
  Vector translation() const { return t; }
  SE3 inverse() const { return {q.conjugate(), -(q.conjugate() * t)}; }
  SE3 operator*(const SE3& other) const { return {q * other.q, q * other.t + t}; }

  Quaternion q = Quaternion::Identity();
  Vector t = Vector::Zero();
};
using SE3f = SE3<float>;
using SE3d = SE3<double>;

struct Sim3f {
  Sim3f(const Eigen::Quaternionf& rotation, const Eigen::Vector3f& translation)
      : q(rotation), t(translation) {}
  void setScale(float scale) { s = scale; }

  Eigen::Quaternionf q;
  Eigen::Vector3f t;
  float s = 1.0F;
};

}  // namespace Sophus

namespace g2o {

/// x ↦ s · R · x + t.
struct Sim3 {
  Sim3() = default;
  Sim3(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& translation, double scale)
      : q(rotation), t(translation), s(scale) {}

  Sim3 operator*(const Sim3& other) const {
    return {q * other.q, s * (q * other.t) + t, s * other.s};
  }
  Sim3 inverse() const {
    const Eigen::Quaterniond back = q.conjugate();
    return {back, -(back * t) / s, 1.0 / s};
  }
  Eigen::Quaterniond rotation() const { return q; }
  Eigen::Vector3d translation() const { return t; }
  double scale() const { return s; }
  /// Where the camera stands in the world that it takes to it.
  Eigen::Vector3d center() const { return inverse().t; }

  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  double s = 1.0;
};

}  // namespace g2o

namespace ORB_SLAM3 {

struct KeyFrame;

struct MapPoint {
  bool bad = false;
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  std::set<const KeyFrame*> seen_by;

  bool isBad() const { return bad; }
  bool IsInKeyFrame(KeyFrame* key_frame) const { return seen_by.count(key_frame) != 0; }
  Eigen::Vector3f GetWorldPos() const { return position; }
};

/// A pinhole camera: its focal length is its first parameter.
struct GeometricCamera {
  float focal = 500.0F;

  float getParameter(int) const { return focal; }
  cv::Point3f unproject(const cv::Point2f& pixel) const {
    return {pixel.x / focal, pixel.y / focal, 1.0F};
  }
};

struct KeyFrame {
  bool bad = false, kept = false;
  Sophus::SE3f T_world_camera;
  g2o::Sim3 S_camera_other;  ///< the truth: the other map's world to this camera, in its own unit
  std::vector<MapPoint*> points;
  std::vector<KeyFrame*> neighbors;
  std::vector<cv::KeyPoint> mvKeysUn;
  GeometricCamera* mpCamera = nullptr;

  bool isBad() const { return bad; }
  void SetNotErase() { kept = true; }
  Sophus::SE3f GetPose() const { return T_world_camera.inverse(); }
  Sophus::SE3f GetPoseInverse() const { return T_world_camera; }
  std::vector<MapPoint*> GetMapPointMatches() const { return points; }
  std::vector<KeyFrame*> GetBestCovisibilityKeyFrames(int most) const {
    const auto count = std::min(neighbors.size(), static_cast<std::size_t>(most));
    return {neighbors.begin(), neighbors.begin() + static_cast<std::ptrdiff_t>(count)};
  }
};

struct Frame {
  int N = 0;
  std::vector<MapPoint*> mvpMapPoints;
  std::vector<bool> mvbOutlier;
  std::vector<cv::KeyPoint> mvKeysUn;
  GeometricCamera* mpCamera = nullptr;
  Sophus::SE3f pose;

  void SetPose(const Sophus::SE3f& Tcw) { pose = Tcw; }
};

/// A feature of a key frame that resembles a point which it does not show.
inline bool is_wrong(const KeyFrame& key_frame, std::size_t feature) {
  return feature < key_frame.mvKeysUn.size() && key_frame.mvKeysUn[feature].response < 0.0F;
}

/// A camera that is 1 cm off projects 2 px off; wrong features match in wide windows alone.
struct ORBmatcher {
  ORBmatcher(float, bool) {}

  void SearchByProjection(Frame& frame, KeyFrame* key_frame, const std::set<MapPoint*>&, float,
                          int) {
    match_in_order(frame, *key_frame);
  }
  int SearchByProjection(KeyFrame* key_frame, Sophus::Sim3f& Scw,
                         const std::vector<MapPoint*>& points, std::vector<MapPoint*>& matches,
                         int window, float) {
    const Eigen::Vector3f center = -(Scw.q.conjugate() * Scw.t) / Scw.s;
    const double off = (center.cast<double>() - key_frame->S_camera_other.center()).norm();
    if (200.0 * off > window) return 0;
    int found = 0;
    for (std::size_t i = 0; i < std::min(points.size(), matches.size()); ++i) {
      if (window < 40 && is_wrong(*key_frame, i)) continue;
      matches[i] = points[i];
      ++found;
    }
    return found;
  }
};

struct Optimizer {
  static int PoseOptimization(Frame* frame) { return frame->N; }

  /// Finds the truth from a scale that is a tenth off, and from no other; not among matches of
  /// which most are wrong, or one is not seen by the other key frame.
  static int OptimizeSim3(KeyFrame* key_frame, KeyFrame* other, std::vector<MapPoint*>& matches,
                          g2o::Sim3& S, float, bool fixed_scale, Eigen::Matrix<double, 7, 7>&,
                          bool) {
    const Sophus::SE3d T = other->T_world_camera.cast<double>();
    const g2o::Sim3 truth = key_frame->S_camera_other * g2o::Sim3(T.q, T.t, 1.0);
    if (S.s < 0.9 * truth.s || S.s > 1.1 * truth.s) return 0;
    if (fixed_scale && S.s != 1.0) return 0;
    int wrong = 0;
    for (std::size_t i = 0; i < matches.size(); ++i) {
      if (!matches[i]) continue;
      if (!matches[i]->IsInKeyFrame(other)) return 0;
      wrong += is_wrong(*key_frame, i) ? 1 : 0;
    }
    if (2 * wrong > count_matches(matches)) return 0;
    S = truth;
    return count_matches(matches);
  }
};

}  // namespace ORB_SLAM3
