// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace semantic {

/// A place that was offered for a loop.
struct OfferedLoop {
  double query_stamp = 0.0;      ///< s
  double candidate_stamp = 0.0;  ///< s
  Eigen::Isometry3d T_candidate_query = Eigen::Isometry3d::Identity();
};

/// For how many key frames there were merge candidates: the host's own, ours, and either's of one.
struct MergeQueries {
  std::size_t asked = 0;
  std::size_t of_host = 0;
  std::size_t of_bag = 0;
  std::size_t of_both = 0;
};

/// What the lost tracker was offered for one frame.
struct OfferedPlaces {
  double stamp = 0.0;  ///< s
  std::size_t verified = 0;
  std::size_t guesses = 0;
  bool by_bearings = false;  ///< by directions, for too few objects had a depth
  int accepted = -1;         ///< which of them stood the host's test; -1 = none, or it needed none
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< by the best one, when it is verified
};

/// What is told when a run is over. From any thread.
class SlamRecords {
 public:
  using Loops = std::vector<OfferedLoop>;
  using Times = std::map<std::string, std::vector<double>>;

  /// A call of a stage took so long.
  void took(const std::string& stage, double ms) {
    const std::lock_guard<std::mutex> lock(mutex_);
    times_[stage].push_back(ms);
  }
  void lost(const std::string& why) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++lost_key_frames_[why];
  }
  void offered_for_loops(const Loops& loops) { add(loops, loops_); }
  void offered_for_merges(const Loops& loops) { add(loops, merges_); }
  /// What a key frame's query for merges came to.
  void asked_for_merges(bool host_has_some, bool bag_has_some) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++merge_queries_.asked;
    merge_queries_.of_host += host_has_some ? 1U : 0U;
    merge_queries_.of_bag += bag_has_some ? 1U : 0U;
    merge_queries_.of_both += host_has_some && bag_has_some ? 1U : 0U;
  }
  void offered(const OfferedPlaces& places) {
    const std::lock_guard<std::mutex> lock(mutex_);
    places_.push_back(places);
  }
  /// Which of the places that were offered last stood the host's test.
  void accepted(int place) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!places_.empty()) places_.back().accepted = place;
  }

  Times times() const { return copy_of(times_); }
  std::map<std::string, std::size_t> lost_key_frames() const { return copy_of(lost_key_frames_); }
  Loops loops() const { return copy_of(loops_); }
  Loops merges() const { return copy_of(merges_); }
  MergeQueries merge_queries() const { return copy_of(merge_queries_); }
  std::vector<OfferedPlaces> places() const { return copy_of(places_); }

 private:
  void add(const Loops& loops, Loops& to) {
    const std::lock_guard<std::mutex> lock(mutex_);
    to.insert(to.end(), loops.begin(), loops.end());
  }
  template <typename T>
  T copy_of(const T& record) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return record;
  }

  mutable std::mutex mutex_;
  Times times_;
  std::map<std::string, std::size_t> lost_key_frames_;  ///< by the reason
  Loops loops_, merges_;
  MergeQueries merge_queries_;
  std::vector<OfferedPlaces> places_;
};

}  // namespace semantic
