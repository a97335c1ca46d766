// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/evaluation/alignment.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/evaluation/trajectory_error.hpp>

#include "semantic_slam.hpp"
#include "tum_sequence.hpp"

namespace semantic {

/// A line of figures: how many, median, 95th percentile, largest. Other numbers look as before.
inline void print_times(const std::string& name, std::vector<double> ms,
                        std::ostream& out = std::cout) {
  if (ms.empty()) return;
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double share) {
    return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
  };
  std::ostringstream line;
  line << "  " << std::left << std::setw(36) << name << std::right << std::setw(6) << ms.size()
       << std::fixed << std::setprecision(2) << std::setw(9) << at(0.5) << std::setw(9) << at(0.95)
       << std::setw(9) << ms.back() << '\n';
  out << line.str();
}

inline std::ptrdiff_t wrong_of(const std::vector<topobag::PoseError>& errors) {
  return std::count_if(errors.begin(), errors.end(), [](const auto& error) {
    return topobag::judge(error) != topobag::PoseVerdict::correct;
  });
}

inline void print_errors(const std::string& name, const std::vector<topobag::PoseError>& errors,
                         std::ostream& out = std::cout) {
  const auto m = topobag::translation_statistics(errors);
  if (!m) return;
  const auto degrees = topobag::rotation_statistics(errors);
  out << name << ": median " << m->median << " m, " << degrees->median << " degrees; largest "
      << m->max << " m, " << degrees->max << " degrees\n";
}

/// What the objects alone make of the frames shown, and together with the host.
/// @param places       what was offered for these frames, and for no others
/// @param relocalized  stamps of the frames in which the host found itself
/// @param alignment    of the map's world with the truth's
inline void report_places(const std::vector<OfferedPlaces>& places,
                          const std::set<double>& relocalized,
                          const topobag::Trajectory& true_poses,
                          const topobag::Alignment& alignment, std::ostream& out = std::cout) {
  std::size_t verified = 0, by_place = 0, guesses = 0;
  std::size_t directions = 0, directions_verified = 0, directions_wrong = 0;
  std::set<double> found = relocalized;
  std::vector<topobag::PoseError> errors;
  for (const OfferedPlaces& offered : places) {
    const auto truth = true_pose(true_poses, offered.stamp);
    by_place += offered.accepted >= 0 ? 1U : 0U;
    guesses += offered.verified == 0 && offered.guesses > 0 ? 1U : 0U;
    directions += offered.by_bearings ? 1U : 0U;
    if (!truth || !offered.T_world_camera) continue;
    ++verified;
    found.insert(offered.stamp);
    errors.push_back(topobag::pose_error(*truth, alignment * *offered.T_world_camera));
    if (!offered.by_bearings) continue;
    ++directions_verified;
    directions_wrong += topobag::judge(errors.back()) != topobag::PoseVerdict::correct ? 1U : 0U;
  }
  out << "by objects alone: " << verified << " verified, " << wrong_of(errors)
      << " of them not within 0.3 m and 15 degrees; by objects or the host: " << found.size()
      << "; frames with guesses alone: " << guesses << "; the host took the objects' pose in "
      << by_place << '\n';
  if (directions > 0) {
    out << "without depth, by directions: " << directions << " frames asked, "
        << directions_verified << " verified, " << directions_wrong
        << " of them not within 0.3 m and 15 degrees\n";
  }
  print_errors("error of the objects' poses", errors, out);
}

/// What became of the key frames, and of the features where they are masked.
inline void report_map(const SemanticSlam& semantic, bool mask) {
  const auto counts = semantic.counts();
  std::cout << "key frames, and looks at the poses while lost: " << counts.pushed << " made, "
            << counts.processed << " through the topology thread, " << counts.failed << " failed, "
            << counts.given_up << " given up; " << semantic.size()
            << " in the bag; exceptions: " << semantic.failures().first;
  if (semantic.failures().first > 0) std::cout << ", the last: " << semantic.failures().second;
  std::cout << '\n';
  for (const auto& [why, count] : semantic.lost_key_frames()) {
    std::cout << "  " << count << " key frames without objects: " << why << '\n';
  }
  if (mask) {
    const MaskedFeatures masked = semantic.masked_features();
    std::cout << "features masked: " << masked.dropped << " of " << masked.seen << ", in "
              << masked.frames << " frames; " << masked.failed << " frames failed\n";
  }
}

/// The candidates that were offered for loops or merges, scored by the truth as far as it is known.
/// @param scale  m in the host's unit
/// @param path   of a table of them
inline void report_offers(const std::string& what, const std::vector<OfferedLoop>& offered,
                          const topobag::Trajectory& truth, double scale, const std::string& path,
                          std::ostream& out = std::cout) {
  std::ofstream file(path);
  file << "query_stamp,candidate_stamp,error_m,error_deg\n" << std::setprecision(17);
  std::size_t known = 0, wrong = 0;
  for (const OfferedLoop& loop : offered) {
    file << loop.query_stamp << ',' << loop.candidate_stamp << ',';
    const auto query = true_pose(truth, loop.query_stamp);
    const auto candidate = true_pose(truth, loop.candidate_stamp);
    if (query && candidate) {
      Eigen::Isometry3d T_candidate_query = loop.T_candidate_query;
      T_candidate_query.translation() *= scale;
      const auto error = topobag::pose_error(candidate->inverse() * *query, T_candidate_query);
      ++known;
      wrong += topobag::judge(error) == topobag::PoseVerdict::wrong ? 1U : 0U;
      file << error.translation_m << ',' << error.rotation_deg;
    } else {
      file << ',';
    }
    file << '\n';
  }
  out << what << " candidates offered: " << offered.size();
  if (known < offered.size()) out << ", of which the truth knows: " << known;
  out << ", wrong by the truth: " << wrong << '\n';
}

/// For how many key frames the bag has merge candidates beside the host's own.
inline void report_merges(const MergeQueries& queries, std::ostream& out = std::cout) {
  out << "key frames asked for merges: " << queries.asked
      << "; with candidates of the host: " << queries.of_host << ", of the bag: " << queries.of_bag
      << ", of both: " << queries.of_both << '\n';
}

}  // namespace semantic
