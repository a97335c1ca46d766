// SPDX-License-Identifier: MIT
// What an ORB-SLAM tells and asks a semantic map. This header needs OpenCV and C++11 alone, so that
// the host can be built without topobag and with other vector instructions.
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
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
  std::array<float, 16> Tcw;  ///< that key frame's world to the camera, in its unit, row by row
  float scale;                ///< of that world's units in one of the query's own
};

/// What listens. Every function comes on a thread of the host and must not throw.
template <typename KeyFrame, typename Frame>
class SemanticObserver {
 public:
  using Places = std::vector<Place<KeyFrame>>;

  virtual ~SemanticObserver() = default;
  /// `frame` was made of these images and of nothing else yet; its features may be dropped. The
  /// second is the depth image, or the right one of a stereo camera; one camera has none: empty.
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
  /// loaded. Returns when no thread is in a call of the observer before, which may then be deleted;
  /// null: from then on nobody is told, not of key frames that are deleted either, so that what
  /// reads them has to be stopped before. Neither observer may wait for the caller meanwhile, nor the
  /// new one call the host.
  void SetObserver(Observer* observer) {
    std::unique_lock<std::mutex> lock(mutex_);
    observer_ = nullptr;
    left_.wait(lock, [this] { return calls_ == 0; });
    observer_ = observer;
    if (!observer_) return;
    for (KeyFrame* key_frame : present_) observer_->Added(key_frame);
  }

  void FrameMade(Frame& frame, const cv::Mat& image, const cv::Mat& second) {
    if (const Call told{*this}) told->FrameMade(frame, image, second);
  }
  void KeyFrameMade(KeyFrame* key_frame) {
    if (const Call told{*this}) told->KeyFrameMade(key_frame);
  }
  void Added(KeyFrame* key_frame) {
    if (const Call told{*this, [&] { present_.insert(key_frame); }}) told->Added(key_frame);
  }
  void Erased(KeyFrame* key_frame) {
    if (const Call told{*this, [&] { present_.erase(key_frame); }}) told->Erased(key_frame);
  }
  void Cleared() {
    if (const Call told{*this, [&] { present_.clear(); }}) told->Cleared();
  }
  template <typename Map>
  void ClearedMap(Map* map) {
    const Call told{*this, [&] {
                      for (auto each = present_.begin(); each != present_.end();) {
                        each = (*each)->GetMap() == map ? present_.erase(each) : std::next(each);
                      }
                    }};
    if (told) told->ClearedMap(map);
  }
  void LoopCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) {
    if (const Call told{*this}) told->LoopCandidates(key_frame, candidates);
  }
  void MergeCandidates(KeyFrame* key_frame, std::vector<KeyFrame*>& candidates) {
    if (const Call told{*this}) told->MergeCandidates(key_frame, candidates);
  }
  Places MergePlaces() {
    const Call told{*this};
    return told ? told->MergePlaces() : Places();
  }
  void RelocalizationCandidates(Frame* frame, std::vector<KeyFrame*>& candidates,
                                const void* map = nullptr) {
    if (const Call told{*this}) told->RelocalizationCandidates(frame, candidates, map);
  }
  Places RelocalizationPlaces() {
    const Call told{*this};
    return told ? told->RelocalizationPlaces() : Places();
  }
  void PlacesTried(int accepted) {
    if (const Call told{*this}) told->PlacesTried(accepted);
  }
  void MergePlacesTried(int accepted) {
    if (const Call told{*this}) told->MergePlacesTried(accepted);
  }

 private:
  /// A call of the observer as it is when the change is made: it hears of a key frame by
  /// `SetObserver` or by the host's call, whichever comes first, and at most twice.
  class Call {
   public:
    explicit Call(SemanticHooks& hooks) : Call(hooks, [] {}) {}
    template <typename Change>
    Call(SemanticHooks& hooks, Change change) : hooks_(hooks) {
      const std::lock_guard<std::mutex> lock(hooks_.mutex_);
      change();
      observer_ = hooks_.observer_;
      if (observer_) ++hooks_.calls_;
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    ~Call() {
      if (!observer_) return;
      const std::lock_guard<std::mutex> lock(hooks_.mutex_);
      if (--hooks_.calls_ == 0) hooks_.left_.notify_all();
    }

    explicit operator bool() const { return observer_ != nullptr; }
    Observer* operator->() const { return observer_; }

   private:
    SemanticHooks& hooks_;
    Observer* observer_ = nullptr;
  };

  std::mutex mutex_;
  std::condition_variable left_;
  std::size_t calls_ = 0;  ///< threads in a call of the observer
  Observer* observer_ = nullptr;
  std::set<KeyFrame*> present_;
};

}  // namespace topobag_hooks
