// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include <host.hpp>
#include <semantic_slam.hpp>

#include "recognition/synthetic_room.hpp"

/// A front end of two threads that calls the hooks where an ORB-SLAM does, under the locks that it
/// holds there. Tracking makes key frames, is lost, gives up maps and deletes what was in them;
/// loop closing queries, adds, moves, merges and culls.
class SmallSlam {
 public:
  using Hooks = topobag_hooks::SemanticHooks<host::KeyFrame, host::Frame>;
  static constexpr bool several = topobag::has_maps_v<host::KeyFrame>;

  SmallSlam() : tracking_([this] { track(); }), loop_closing_([this] { close_loops(); }) {}
  SmallSlam(const SmallSlam&) = delete;
  SmallSlam& operator=(const SmallSlam&) = delete;
  ~SmallSlam() { shut_down(); }

  /// As ORB-SLAM3's: its threads end a while after it returned.
  void request_end() { finished_ = true; }
  void shut_down() {
    request_end();
    if (tracking_.joinable()) tracking_.join();
    if (loop_closing_.joinable()) loop_closing_.join();
  }

  Hooks& hooks() { return hooks_; }
  std::mutex& map_mutex() { return maps_[0].mMutexMapUpdate; }
  std::size_t candidates() const { return candidates_; }
  std::size_t places() const { return places_; }

  /// What the detector answers for the images of a stamp: the room from there, and a person.
  std::vector<topobag::RangedDetection> detect(double stamp) const {
    const std::lock_guard<std::mutex> lock(stamps_mutex_);
    std::vector<topobag::RangedDetection> found{{{0, 0, 100, 479}, topobag::ClassId{0}, 0.9, 3.0}};
    const auto at = stamps_.find(stamp);
    if (at == stamps_.end()) return found;
    const topobag::TopologyGraph<> seen = room_.seen_from(at->second);
    for (const auto& node : seen.nodes()) {
      const auto pixel = camera().project(*node.position);
      if (!pixel) continue;
      found.push_back({topobag::box_around(*pixel, 40.0, 40.0),
                       topobag::ClassId{static_cast<std::int32_t>(node.label) + 56}, 0.9, node.z});
    }
    return found;
  }

  static topobag::PinholeCamera<> camera() { return {520.0, 520.0, 319.5, 239.5, 640, 480}; }

 private:
  double next_stamp(const Eigen::Isometry3d& T_world_camera) {
    const std::lock_guard<std::mutex> lock(stamps_mutex_);
    stamp_ += 0.5;
    stamps_[stamp_] = T_world_camera;
    return stamp_;
  }

  void track() {
    std::mt19937 random(2);
    for (unsigned long id = 0; !finished_; ++id) {
      const Eigen::Isometry3d T_world_camera = random_camera(random);
      host::Frame frame(next_stamp(T_world_camera));
      host::Map& map = maps_[several ? random() % 2 : 0];
      hooks_.FrameMade(frame, image_, image_);
      {
        const std::lock_guard<std::mutex> lock(map.mMutexMapUpdate);
        if (random() % 3 == 0) {
          lose(frame, map);
        } else {
          auto made = std::make_unique<host::KeyFrame>(id, frame.mTimeStamp, T_world_camera, map);
          hooks_.KeyFrameMade(made.get());
          const std::lock_guard<std::mutex> queue(queue_mutex_);
          queue_.push_back(std::move(made));
        }
      }
      if (random() % 25 == 0 && give_up(map)) id = 0;
    }
  }

  void lose(host::Frame& frame, host::Map& map) {
    std::vector<host::KeyFrame*> candidates;
    hooks_.RelocalizationCandidates(&frame, candidates, several ? &map : nullptr);
    candidates_ += candidates.size();
    places_ += hooks_.RelocalizationPlaces().size();
    hooks_.PlacesTried(-1);
  }

  /// Whether ids begin anew. Loop closing stands still meanwhile, as the hosts see to; key frames
  /// that it has not taken yet are deleted too, once they were told to be gone.
  bool give_up(host::Map& map) {
    const std::lock_guard<std::mutex> still(work_mutex_);
    const std::lock_guard<std::mutex> queue(queue_mutex_);
    host::give_up(hooks_, map);
    for (auto* const list : {&queue_, &key_frames_}) {
      list->erase(std::remove_if(list->begin(), list->end(),
                                 [&](const auto& key_frame) { return key_frame->is_in(map); }),
                  list->end());
    }
    return !several;
  }

  std::unique_ptr<host::KeyFrame> next_key_frame() {
    const std::lock_guard<std::mutex> lock(queue_mutex_);
    if (queue_.empty()) return nullptr;
    auto next = std::move(queue_.front());
    queue_.erase(queue_.begin());
    return next;
  }

  void close_loops() {
    std::mt19937 random(1);
    while (!finished_) {
      const std::lock_guard<std::mutex> lock(work_mutex_);
      auto next = next_key_frame();
      if (!next) continue;
      host::KeyFrame* const current = next.get();
      key_frames_.push_back(std::move(next));
      std::vector<host::KeyFrame*> loops, merges;
      hooks_.LoopCandidates(current, loops);
      hooks_.MergeCandidates(current, merges);
      candidates_ += loops.size() + merges.size();
      places_ += hooks_.MergePlaces().size();
      hooks_.MergePlacesTried(-1);
      hooks_.Added(current);
      const std::lock_guard<std::mutex> first(maps_[0].mMutexMapUpdate);
      const std::lock_guard<std::mutex> second(maps_[1].mMutexMapUpdate);
      current->SetPoseInverse(random_camera(random));
      if (random() % 10 == 0) current->move_to(maps_[random() % 2]);
      if (random() % 5 != 0) continue;
      host::KeyFrame* const culled = key_frames_[random() % key_frames_.size()].get();
      culled->SetBadFlag();
      hooks_.Erased(culled);
    }
  }

  const SyntheticRoom room_{7, 9, 4};
  const cv::Mat image_ = cv::Mat::zeros(4, 4, CV_8U);
  Hooks hooks_;
  std::array<host::Map, 2> maps_;
  mutable std::mutex stamps_mutex_;  // of the stamps
  std::map<double, Eigen::Isometry3d> stamps_;
  double stamp_ = 0.0;
  std::mutex queue_mutex_, work_mutex_;
  std::vector<std::unique_ptr<host::KeyFrame>> queue_, key_frames_;
  std::atomic<std::size_t> candidates_{0}, places_{0};
  std::atomic<bool> finished_{false};
  std::thread tracking_, loop_closing_;
};
