// SPDX-License-Identifier: MIT
// Tests where a key frame is in another map, by the pose of the objects and the host's own means;
// included by the host's LoopClosing.cc.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include "RelocalizeFromPlaces.h"

namespace topobag_hooks {

/// A world to a camera, `scale` of whose units are one of that world's.
inline g2o::Sim3 SimilarityOf(const Sophus::SE3f& Tcw, double scale) {
  const Sophus::SE3d T = Tcw.cast<double>();
  const Eigen::Vector3d translation = scale * T.translation();
  return g2o::Sim3(T.unit_quaternion(), translation, scale);
}

/// What the host keeps of a merge that it has begun to believe in.
struct MergeState {
  ORB_SLAM3::KeyFrame*& matched;
  ORB_SLAM3::KeyFrame*& last;
  g2o::Sim3& Slw;
  int& coincidences;
  std::vector<ORB_SLAM3::MapPoint*>& points;
  std::vector<ORB_SLAM3::MapPoint*>& matches;
};

/// Where a key frame is in another map: the object pose of a place is refined by matches, and
/// stands the tests that the host has for its own candidates once their points are matched.
class MergeSearch {
 public:
  using KeyFrame = ORB_SLAM3::KeyFrame;
  using MapPoint = ORB_SLAM3::MapPoint;

  /// @param fixed_scale  whether both maps have one unit
  MergeSearch(KeyFrame* key_frame, bool fixed_scale)
      : key_frame_(key_frame), fixed_scale_(fixed_scale) {}

  /// Whether the place holds, which `state` then has; with as many coincidences as other key frames
  /// beside this one agree, three at most.
  /// @param agrees  bool(KeyFrame* other, KeyFrame* matched, g2o::Sim3& Sow): the host's test
  template <typename Agrees>
  bool Try(const Place<KeyFrame>& place, MergeState state, Agrees agrees) {
    const std::vector<KeyFrame*> around = PlaceSearch<OrbSlam3>::Around(place.key_frame);
    const std::vector<MapPoint*> points = PointsOf(around);
    const double scale = fixed_scale_ ? 1.0 : 1.0 / static_cast<double>(place.scale);
    for (const Search& first : {Search{40.0f, 64, 20}, Search{100.0f, 50, 20}}) {
      std::vector<MapPoint*> matches;
      g2o::Sim3 Scw = SimilarityOf(PoseOf(place), scale);
      if (!Converges(points, first, Scw, matches)) continue;
      KeyFrame* const matched = KeepThoseOfOne(around, matches);
      if (!Optimize(matched, matches, Scw)) continue;
      if (!Match(Scw, points, {5.0f, 50, 80}, matches)) continue;
      const int others = OthersThatAgree(matched, Scw, agrees);
      if (others == 0) continue;
      matched->SetNotErase();
      state.matched = matched;
      state.last = key_frame_;
      state.Slw = Scw;
      state.coincidences = others;
      state.points = points;
      state.matches = matches;
      return true;
    }
    return false;
  }

 private:
  static std::vector<MapPoint*> PointsOf(const std::vector<KeyFrame*>& key_frames) {
    std::set<MapPoint*> known;
    for (KeyFrame* key_frame : key_frames) {
      for (MapPoint* point : key_frame->GetMapPointMatches()) {
        if (point && !point->isBad()) known.insert(point);
      }
    }
    return {known.begin(), known.end()};
  }

  /// Matches the points with the key frame's features; whether they are enough.
  bool Match(const g2o::Sim3& Scw, const std::vector<MapPoint*>& points, const Search& search,
             std::vector<MapPoint*>& matches) const {
    ORB_SLAM3::ORBmatcher matcher(0.9f, true);
    matches.assign(key_frame_->GetMapPointMatches().size(), nullptr);
    Sophus::Sim3f projection(Eigen::Quaternionf(Scw.rotation().cast<float>()),
                             Scw.translation().cast<float>());
    projection.setScale(static_cast<float>(Scw.scale()));
    // The host's least distance is 50 bits, times this ratio.
    return matcher.SearchByProjection(key_frame_, projection, points, matches,
                                      static_cast<int>(search.window),
                                      static_cast<float>(search.distance) / 50.0f) >= search.least;
  }

  /// Whether the pose (`Scw`: the place's world to the key frame) gets better in searches that
  /// narrow. In the first one most matches are wrong: RANSAC sorts them out.
  bool Converges(const std::vector<MapPoint*>& points, const Search& first, g2o::Sim3& Scw,
                 std::vector<MapPoint*>& matches) const {
    for (const Search& search : {first, Search{12.0f, 80, 20}}) {
      Sophus::SE3f Tcw;
      if (!Match(Scw, points, search, matches)) return false;
      if (!OrbSlam3::FindPose(*key_frame_, matches, Tcw)) return false;
      Scw = SimilarityOf(Tcw, Scw.scale());
    }
    return true;
  }

  /// Of the matches those that one of the key frames sees: the one that sees most of them. The
  /// host's `OptimizeSim3` is misled by points that its second key frame does not see.
  static KeyFrame* KeepThoseOfOne(const std::vector<KeyFrame*>& key_frames,
                                  std::vector<MapPoint*>& matches) {
    const auto seen_by = [](KeyFrame* key_frame) {
      return [key_frame](MapPoint* point) { return point && point->IsInKeyFrame(key_frame); };
    };
    const auto count = [&](KeyFrame* key_frame) {
      return std::count_if(matches.begin(), matches.end(), seen_by(key_frame));
    };
    KeyFrame* const most =
        *std::max_element(key_frames.begin(), key_frames.end(),
                          [&](KeyFrame* a, KeyFrame* b) { return count(a) < count(b); });
    const auto is_seen = seen_by(most);
    for (MapPoint*& point : matches) {
      if (!is_seen(point)) point = nullptr;
    }
    return most;
  }

  /// The host's optimisation, over the points that both key frames see; whether 20 agree.
  bool Optimize(KeyFrame* matched, std::vector<MapPoint*>& matches, g2o::Sim3& Scw) const {
    const Sophus::SE3d Twm = matched->GetPoseInverse().cast<double>();
    const g2o::Sim3 Swm(Twm.unit_quaternion(), Twm.translation(), 1.0);
    g2o::Sim3 Scm = Scw * Swm;
    Eigen::Matrix<double, 7, 7> information;
    const int inliers = ORB_SLAM3::Optimizer::OptimizeSim3(key_frame_, matched, matches, Scm, 10,
                                                           fixed_scale_, information, true);
    Scw = Scm * Swm.inverse();
    return inliers >= 20;
  }

  /// Of the ten that see most of the same, until there are three.
  template <typename Agrees>
  int OthersThatAgree(KeyFrame* matched, const g2o::Sim3& Scw, Agrees agrees) const {
    int others = 0;
    for (KeyFrame* other : key_frame_->GetBestCovisibilityKeyFrames(10)) {
      const Sophus::SE3d Toc = (other->GetPose() * key_frame_->GetPoseInverse()).cast<double>();
      g2o::Sim3 Sow = g2o::Sim3(Toc.unit_quaternion(), Toc.translation(), 1.0) * Scw;
      others += agrees(other, matched, Sow) ? 1 : 0;
      if (others == 3) break;
    }
    return others;
  }

  KeyFrame* const key_frame_;
  const bool fixed_scale_;
};

/// Where the host has no merge under way: tries the object poses of the key frame in other maps.
/// True where one holds in three other key frames as well: the host then merges at once, as by its
/// own candidates. One that holds in fewer has begun: the next key frames decide.
/// @param agrees  as `MergeSearch::Try`
template <typename Hooks, typename Agrees>
bool MergeFromPlaces(Hooks& hooks, ORB_SLAM3::KeyFrame* key_frame, bool fixed_scale,
                     MergeState state, Agrees agrees) {
  if (state.coincidences > 0) return false;
  const auto places = hooks.MergePlaces();
  MergeSearch search(key_frame, fixed_scale);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].key_frame->isBad() || !search.Try(places[i], state, agrees)) continue;
    hooks.MergePlacesTried(static_cast<int>(i));
    return state.coincidences >= 3;
  }
  if (!places.empty()) hooks.MergePlacesTried(-1);
  return false;
}

}  // namespace topobag_hooks
