// SPDX-License-Identifier: MIT
// A key frame of a small ORB-SLAM3 and one of another map, and the hooks that are asked between.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include <MergeFromPlaces.h>

using MergedKeyFrame = ORB_SLAM3::KeyFrame;
using MergedPoint = ORB_SLAM3::MapPoint;

struct MergeHooks {
  std::vector<topobag_hooks::Place<MergedKeyFrame>> places;
  std::vector<int> tried;
  int asked = 0;

  std::vector<topobag_hooks::Place<MergedKeyFrame>> MergePlaces() {
    ++asked;
    return places;
  }
  void MergePlacesTried(int accepted) { tried.push_back(accepted); }
};

/// A key frame, one of another map that sees the same, and how the two worlds' units go together.
struct MergeScene {
  explicit MergeScene(double scale_of_place) : scale(scale_of_place) {
    other.T_world_camera.t << 0.5F, 0.0F, 1.0F;
    const Eigen::Quaterniond rotation(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
    const Eigen::Vector3d translation(0.2, -0.1, 0.4);  // in the other map's unit
    now.S_camera_other = {rotation, translation / scale, 1.0 / scale};
    now.mpCamera = &camera;
    see(100, 1);
    for (MergedKeyFrame& each : beside) now.neighbors.push_back(&each);
  }

  /// Points of both maps, and where the key frame sees them: every `nth` there, the others where
  /// they are not.
  void see(std::size_t count, std::size_t nth) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> in(-1.0, 1.0);
    const auto draw = [&] {  // the same under every compiler
      const double x = in(random), y = in(random), z = in(random);
      return Eigen::Vector3d(x, y, z);
    };
    points = std::vector<MergedPoint>(count);
    now.points.resize(count);
    now.mvKeysUn.clear();
    other.points.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3d seen = Eigen::Vector3d(0.0, 0.0, 3.0) + draw();  // in this map's unit
      const g2o::Sim3 back = now.S_camera_other.inverse();
      const Eigen::Vector3d position = back.s * (back.q * seen) + back.t;
      points[i].position = position.cast<float>();
      points[i].seen_by = {&other};
      other.points.push_back(&points[i]);
      const bool wrong = i % nth != 0;
      Eigen::Vector2d pixel = 500.0 / seen.z() * seen.head<2>();
      if (wrong) pixel = 250.0 * draw().head<2>();
      const Eigen::Vector2f at = pixel.cast<float>();
      now.mvKeysUn.emplace_back(cv::Point2f(at.x(), at.y()), 31.0F, -1.0F, wrong ? -1.0F : 1.0F);
    }
  }

  /// Of the truth, the camera that far off.
  topobag_hooks::Place<MergedKeyFrame> place(float off = 0.05F) {
    Eigen::Matrix4f T = Eigen::Matrix4f::Identity();
    T.topLeftCorner<3, 3>() = now.S_camera_other.q.toRotationMatrix().cast<float>();
    T.topRightCorner<3, 1>() = (scale * now.S_camera_other.t).cast<float>();
    T(0, 3) += off;
    topobag_hooks::Place<MergedKeyFrame> made{&other, {}, static_cast<float>(scale)};
    Eigen::Map<Eigen::Matrix<float, 4, 4, Eigen::RowMajor>>(made.Tcw.data()) = T;
    return made;
  }

  /// Whether a merge has begun, where so many of the key frames beside agree.
  bool begins(MergeHooks& hooks, bool fixed_scale, std::size_t that_agree = 1) {
    merges = topobag_hooks::MergeFromPlaces(
        hooks, &now, fixed_scale, {matched, last, Slw, coincidences, map_points, matches},
        [&](MergedKeyFrame* asked, MergedKeyFrame*, g2o::Sim3& Sow) {
          given = Sow;
          return static_cast<std::size_t>(asked - beside.data()) < that_agree;
        });
    return matched != nullptr;
  }

  const double scale;
  ORB_SLAM3::GeometricCamera camera;
  std::vector<MergedPoint> points;
  MergedKeyFrame now, other;
  std::vector<MergedKeyFrame> beside = std::vector<MergedKeyFrame>(4);  // where `now` is
  MergedKeyFrame *matched = nullptr, *last = nullptr;
  g2o::Sim3 Slw, given;
  int coincidences = 0;
  bool merges = false;
  std::vector<MergedPoint*> map_points, matches;
};
