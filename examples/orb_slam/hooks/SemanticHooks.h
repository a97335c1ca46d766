// SPDX-License-Identifier: MIT
// What an ORB-SLAM tells and asks a semantic map. This header needs OpenCV and C++11 alone, so that
// the host can be built without topobag and with other vector instructions.
#pragma once

#include <array>
#include <iterator>
#include <mutex>
#include <set>
#include <vector>

#include <opencv2/core/core.hpp>

namespace topobag_hooks {

/// Where a lost camera, or a key frame in another map, may be.
template <typename KeyFrame>
struct Place {
  KeyFrame* key_frame;        ///< that shows the same objects
  std::array<float, 16> Tcw;  ///< that key frame's world to the camera, row by row
};

/// What listens. Every function comes on a thread of the host and must not throw.
template <typename KeyFrame, typename Frame>
class SemanticObserver {
 public:
  using Places = std::vector<Place<KeyFrame>>;

  virtual ~SemanticObserver() = default;
  /// `frame` was made of these images and of nothing else yet; its features may be dropped. The
  /// second is the depth image, or the right one of a stereo camera.
  virtual void FrameMade(Frame& frame, const cv::Mat& image, const cv::Mat& second) = 0;
  virtual void KeyFrameMade(KeyFrame* key_frame) = 0;
  virtual void Added(KeyFrame* key_frame) = 0;
  virtual void Erased(KeyFrame* key_frame) = 0;
  virtual void Cleared() = 0;
  /// One of several maps is given up; its key frames live until this returns.
  virtual void ClearedMap(const void* /*map*/) {}
  virtual void LoopCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) = 0;
  /// In the other ones of several maps.
  virtual void MergeCandidates(KeyFrame* /*key_frame*/, std::vector<KeyFrame*>& /*candidates*/) {}
  /// The places found by the last `MergeCandidates`, best first.
  virtual Places MergePlaces() { return {}; }
  /// @param map  the host's present one of several; null: it has one alone
  virtual void RelocalizationCandidates(Frame* frame, std::vector<KeyFrame*>& candidates,
                                        const void* map) = 0;
  /// The places found by the last `RelocalizationCandidates`, best first.
  virtual Places RelocalizationPlaces() = 0;
  /// What became of them: which of the places stood the host's test, -1 for none.
  virtual void PlacesTried(int accepted) = 0;
  /// The same of `MergePlaces`.
  virtual void MergePlacesTried(int /*accepted*/) {}
};

/// The member of the host's KeyFrameDatabase: does nothing but remember the key frames until an
/// observer is set.
template <typename KeyFrame, typename Frame>
class SemanticHooks {
 public:
  using Observer = SemanticObserver<KeyFrame, Frame>;
  using Places = typename Observer::Places;

  /// May come late: the observer is told of the key frames that are there, as after a map was
  /// loaded. It must not call the host meanwhile.
  void SetObserver(Observer* observer) {
    const std::lock_guard<std::mutex> lock(mutex_);
    observer_ = observer;
    if (!observer_) return;
    for (KeyFrame* key_frame : present_) observer_->Added(key_frame);
  }

  void FrameMade(Frame& frame, const cv::Mat& image, const cv::Mat& second) {
    if (Observer* const told = observer()) told->FrameMade(frame, image, second);
  }
  void KeyFrameMade(KeyFrame* key_frame) {
    if (Observer* const told = observer()) told->KeyFrameMade(key_frame);
  }
  void Added(KeyFrame* key_frame) {
    if (Observer* const told = after([&] { present_.insert(key_frame); })) told->Added(key_frame);
  }
  void Erased(KeyFrame* key_frame) {
    if (Observer* const told = after([&] { present_.erase(key_frame); })) told->Erased(key_frame);
  }
  void Cleared() {
    if (Observer* const told = after([&] { present_.clear(); })) told->Cleared();
  }
  template <typename Map>
  void ClearedMap(Map* map) {
    Observer* const told = after([&] {
      for (auto each = present_.begin(); each != present_.end();) {
        each = (*each)->GetMap() == map ? present_.erase(each) : std::next(each);
      }
    });
    if (told) told->ClearedMap(map);
  }
  void LoopCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) {
    if (Observer* const told = observer()) told->LoopCandidates(key_frame, candidates);
  }
  void MergeCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) {
    if (Observer* const told = observer()) told->MergeCandidates(key_frame, candidates);
  }
  Places MergePlaces() {
    Observer* const told = observer();
    return told ? told->MergePlaces() : Places();
  }
  void RelocalizationCandidates(Frame* frame, std::vector<KeyFrame*>& candidates,
                                const void* map = nullptr) {
    if (Observer* const told = observer()) told->RelocalizationCandidates(frame, candidates, map);
  }
  Places RelocalizationPlaces() {
    Observer* const told = observer();
    return told ? told->RelocalizationPlaces() : Places();
  }
  void PlacesTried(int accepted) {
    if (Observer* const told = observer()) told->PlacesTried(accepted);
  }
  void MergePlacesTried(int accepted) {
    if (Observer* const told = observer()) told->MergePlacesTried(accepted);
  }

 private:
  Observer* observer() {
    return after([] {});
  }

  /// The observer as it is when the change is made: it hears of a key frame by `SetObserver` or by
  /// the host's call, whichever comes first, and at most twice.
  template <typename Change>
  Observer* after(Change change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change();
    return observer_;
  }

  std::mutex mutex_;
  Observer* observer_ = nullptr;
  std::set<KeyFrame*> present_;
};

}  // namespace topobag_hooks
