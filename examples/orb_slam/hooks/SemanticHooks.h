// SPDX-License-Identifier: MIT
// What an ORB-SLAM2 tells and asks a semantic map. This header needs OpenCV alone, so that the host
// can be built without topobag and with other vector instructions.
#pragma once

#include <array>
#include <vector>

#include <opencv2/core/core.hpp>

namespace topobag_hooks {

/// Where a lost camera may be.
template <typename KeyFrame>
struct Place {
  KeyFrame* key_frame;        ///< that shows the same objects
  std::array<float, 16> Tcw;  ///< world to camera, row by row
};

/// What listens. Every function comes on a thread of the host and must not throw.
template <typename KeyFrame, typename Frame>
class SemanticObserver {
 public:
  virtual ~SemanticObserver() = default;
  /// `frame` was made of these images and of nothing else yet; its features may be dropped.
  virtual void FrameMade(Frame& frame, const cv::Mat& rgb, const cv::Mat& depth) = 0;
  virtual void KeyFrameMade(KeyFrame* key_frame) = 0;
  virtual void Added(KeyFrame* key_frame) = 0;
  virtual void Erased(KeyFrame* key_frame) = 0;
  virtual void Cleared() = 0;
  virtual void LoopCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) = 0;
  virtual void RelocalizationCandidates(Frame* frame, std::vector<KeyFrame*>& candidates) = 0;
  /// The places found by the last `RelocalizationCandidates`, best first.
  virtual std::vector<Place<KeyFrame>> Places() = 0;
  /// What became of them: which of the places stood the host's test, -1 for none.
  virtual void PlacesTried(int accepted) = 0;
};

/// The member of the host's KeyFrameDatabase: does nothing until an observer is set, which has to
/// happen before the first image.
template <typename KeyFrame, typename Frame>
class SemanticHooks {
 public:
  using Observer = SemanticObserver<KeyFrame, Frame>;

  void SetObserver(Observer* observer) { observer_ = observer; }

  void FrameMade(Frame& frame, const cv::Mat& rgb, const cv::Mat& depth) {
    if (observer_) observer_->FrameMade(frame, rgb, depth);
  }
  void KeyFrameMade(KeyFrame* key_frame) {
    if (observer_) observer_->KeyFrameMade(key_frame);
  }
  void Added(KeyFrame* key_frame) {
    if (observer_) observer_->Added(key_frame);
  }
  void Erased(KeyFrame* key_frame) {
    if (observer_) observer_->Erased(key_frame);
  }
  void Cleared() {
    if (observer_) observer_->Cleared();
  }
  void LoopCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) {
    if (observer_) observer_->LoopCandidates(key_frame, candidates);
  }
  void RelocalizationCandidates(Frame* frame, std::vector<KeyFrame*>& candidates) {
    if (observer_) observer_->RelocalizationCandidates(frame, candidates);
  }
  std::vector<Place<KeyFrame>> Places() {
    return observer_ ? observer_->Places() : std::vector<Place<KeyFrame>>{};
  }
  void PlacesTried(int accepted) {
    if (observer_) observer_->PlacesTried(accepted);
  }

 private:
  Observer* observer_ = nullptr;
};

}  // namespace topobag_hooks
