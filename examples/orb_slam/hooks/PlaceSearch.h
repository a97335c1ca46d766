// SPDX-License-Identifier: MIT
// Tests the places of a semantic map by the host's own matcher and optimiser: what ORB-SLAM2 and
// ORB-SLAM3 have in common.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "SemanticHooks.h"

namespace topobag_hooks {

/// A search for the matches of a projected map point.
struct Search {
  float window;  // px at the finest level
  int distance;  // bits
  int least;     // inliers to go on with
};

/// Whether a frame stands at a place.
/// @tparam Host  its types KeyFrame, Frame, MapPoint, ORBmatcher, Optimizer, and static functions
///               SetPose(Frame&, const Place&) and ApplyRansac(Frame&): sets the pose that RANSAC
///               finds among the frame's matches and keeps its inliers; where it finds none, pose
///               and matches stay
template <typename Host>
class PlaceSearch {
 public:
  using KeyFrame = typename Host::KeyFrame;
  using Frame = typename Host::Frame;
  using MapPoint = typename Host::MapPoint;

  /// Tries the places one after the other. On success the frame has its pose and its map points;
  /// else it is left without points. Needs a frame for which `RelocalizationCandidates` was called.
  template <typename Hooks>
  static bool Relocalize(Hooks& hooks, Frame& frame) {
    const auto places = hooks.RelocalizationPlaces();
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i].key_frame->isBad() || !StandsAt(places[i], frame)) continue;
      hooks.PlacesTried(static_cast<int>(i));
      return true;
    }
    if (!places.empty()) {
      frame.mvpMapPoints.assign(static_cast<std::size_t>(frame.N), nullptr);
      hooks.PlacesTried(-1);
    }
    return false;
  }

  /// The key frame, and those that see most of its map points.
  static std::vector<KeyFrame*> Around(KeyFrame* key_frame) {
    std::vector<KeyFrame*> key_frames = key_frame->GetBestCovisibilityKeyFrames(10);
    key_frames.insert(key_frames.begin(), key_frame);
    return key_frames;
  }

 private:
  /// Matches the frame, at its present pose, with the map points of the key frames, besides what it
  /// is matched with.
  static int MatchByProjection(Frame& frame, const std::vector<KeyFrame*>& key_frames, float window,
                               int distance) {
    typename Host::ORBmatcher matcher(0.9f, true);
    std::set<MapPoint*> found;
    const auto note_matches = [&] {
      for (MapPoint* point : frame.mvpMapPoints) {
        if (point) found.insert(point);
      }
    };
    note_matches();
    for (KeyFrame* key_frame : key_frames) {
      matcher.SearchByProjection(frame, key_frame, found, window, distance);
      note_matches();
    }
    return static_cast<int>(found.size());
  }

  /// Optimises the frame's pose and lets go of outliers; the number of inliers.
  static int OptimizePose(Frame& frame) {
    const int good = Host::Optimizer::PoseOptimization(&frame);
    for (std::size_t i = 0; i < static_cast<std::size_t>(frame.N); ++i) {
      if (frame.mvbOutlier[i]) frame.mvpMapPoints[i] = nullptr;
    }
    return good;
  }

  /// Whether the frame, from the pose it has, gets a pose with 30 inliers, from which the host
  /// searches on elsewhere, in searches that narrow while the pose gets better.
  static bool Converges(Frame& frame, const std::vector<KeyFrame*>& key_frames,
                        const Search& first) {
    const Search searches[] = {first, {12.0f, 80, 20}, {4.0f, 100, 30}};
    for (const Search& search : searches) {
      frame.mvpMapPoints.assign(static_cast<std::size_t>(frame.N), nullptr);
      frame.mvbOutlier.assign(static_cast<std::size_t>(frame.N), false);
      if (MatchByProjection(frame, key_frames, search.window, search.distance) < search.least) {
        return false;
      }
      if (&search == searches) Host::ApplyRansac(frame);
      if (OptimizePose(frame) < search.least) return false;
    }
    return true;
  }

  /// Whether the place is the frame's: its map points are projected with the object pose. A pose of
  /// few objects may be 10 degrees off, 90 px: where a narrow first window fails, a wide one, that
  /// asks for more alike descriptors, gets its turn.
  static bool StandsAt(const Place<KeyFrame>& place, Frame& frame) {
    const std::vector<KeyFrame*> key_frames = Around(place.key_frame);
    for (const Search& first : {Search{40.0f, 64, 10}, Search{100.0f, 50, 10}}) {
      Host::SetPose(frame, place);
      if (Converges(frame, key_frames, first) && MatchFurther(frame, key_frames) >= 50) return true;
    }
    return false;
  }

  /// The host goes on with its local map, and ORB-SLAM3 looks for a lost frame's in windows five
  /// times as wide as usual: what is right there is better matched before, in narrow ones, or wrong
  /// matches outnumber it. With what the neighbors of the key frames see, too; the number of
  /// inliers, of which the host asks for 50 elsewhere.
  static int MatchFurther(Frame& frame, const std::vector<KeyFrame*>& key_frames) {
    std::set<KeyFrame*> known(key_frames.begin(), key_frames.end());
    std::vector<KeyFrame*> further;
    for (KeyFrame* key_frame : key_frames) {
      for (KeyFrame* next : key_frame->GetBestCovisibilityKeyFrames(10)) {
        if (known.insert(next).second) further.push_back(next);
      }
    }
    MatchByProjection(frame, further, 4.0f, 100);
    return OptimizePose(frame);
  }
};

}  // namespace topobag_hooks
