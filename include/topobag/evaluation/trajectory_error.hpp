// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/evaluation/association.hpp>
#include <topobag/evaluation/pose_error.hpp>

namespace topobag {
inline namespace v0 {

/// What a list of errors comes to, in its own unit.
struct ErrorStatistics {
  std::size_t count = 0;
  double rmse = 0.0;  ///< root of the mean square
  double mean = 0.0;
  double median = 0.0;
  double max = 0.0;
};

/// Statistics of non-negative errors; nothing of an empty list. O(n).
inline std::optional<ErrorStatistics> error_statistics(std::vector<double> errors) {
  if (errors.empty()) return std::nullopt;
  ErrorStatistics statistics;
  statistics.count = errors.size();
  const auto n = static_cast<double>(errors.size());
  for (const double error : errors) {
    statistics.mean += error / n;
    statistics.rmse += error * error / n;
    statistics.max = std::max(statistics.max, error);
  }
  statistics.rmse = std::sqrt(statistics.rmse);
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  statistics.median = *middle;
  if (errors.size() % 2 == 0) {
    statistics.median = (statistics.median + *std::max_element(errors.begin(), middle)) / 2.0;
  }
  return statistics;
}

/// The error of every pair. Of aligned pairs these are the absolute errors of the trajectory: the
/// translation is the ATE's e_k = ‖p̂_k − p_k‖, the rotation the AOE's angle of R_trueᵀ R_estimate.
/// @param pairs  a vector of `PosePair`
template <typename Pairs = std::vector<PosePair>>
std::vector<PoseError> pose_errors(const Pairs& pairs) {
  std::vector<PoseError> errors;
  errors.reserve(pairs.size());
  for (const auto& pair : pairs) errors.push_back(pose_error(pair.T_true, pair.T_estimate));
  return errors;
}

/// Statistics of the translations, m.
inline std::optional<ErrorStatistics> translation_statistics(const std::vector<PoseError>& errors) {
  std::vector<double> values;
  for (const PoseError& error : errors) values.push_back(error.translation_m);
  return error_statistics(std::move(values));
}

/// Statistics of the rotations, degrees.
inline std::optional<ErrorStatistics> rotation_statistics(const std::vector<PoseError>& errors) {
  std::vector<double> values;
  for (const PoseError& error : errors) values.push_back(error.rotation_deg);
  return error_statistics(std::move(values));
}

}  // namespace v0
}  // namespace topobag
