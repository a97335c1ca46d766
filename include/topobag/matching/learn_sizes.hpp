// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/matching/size_prior.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// Consumes `values`, which are not empty. O(n) on average.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Appends |xᵢ − xⱼ| / √2 of every pair, which is distributed as |x − mean|.
inline void append_differences(const std::vector<double>& x, std::vector<double>& differences) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      differences.push_back(std::abs(x[i] - x[j]) / std::sqrt(2.0));
    }
  }
}

/// A variance, by the median difference, drawn towards `prior` as if that rested on `weight`
/// differences more.
inline double drawn_variance(const std::vector<double>& differences, double less, double freedom,
                             double prior, double weight) {
  if (differences.empty()) return prior * prior;
  const double deviation = 1.4826 * median(differences);  // of a Gaussian
  const double variance = std::max(0.0, deviation * deviation - less);
  return (weight * prior * prior + freedom * variance) / (weight + freedom);
}

}  // namespace detail

/// Learns how the sizes of each class's objects differ within places and between them.
///
/// Medians are taken of all differences, so that some misread boxes change nothing; of classes with
/// few objects the result stays near `prior.spread`, as if that rested on ten objects.
/// @param places  one graph a place, with each object of it once; at least two
/// Throws InvalidValue for fewer places. O(objects of a class and place, squared + places²).
template <typename Graph>
SizePrior learn_sizes(const std::vector<Graph>& places, SizePrior prior = {}) {
  if (places.size() < 2) throw InvalidValue("sizes are learnt from two places or more");
  const double weight = 10.0;
  using Side = std::vector<std::vector<double>>;  // logarithms of metres, place by place
  std::map<ClassId, std::array<Side, 2>> sizes;
  for (const Graph& place : places) {
    std::map<ClassId, std::array<std::vector<double>, 2>> here;
    for (const auto& node : place.nodes()) {
      for (int side = 0; side < 2; ++side) {
        const auto size = static_cast<double>(node.size[side]);
        if (size > 0.0) here[node.label][static_cast<std::size_t>(side)].push_back(std::log(size));
      }
    }
    for (auto& [label, sides] : here) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (!sides[side].empty()) sizes[label][side].push_back(std::move(sides[side]));
      }
    }
  }
  for (const auto& [label, sides] : sizes) {
    SizeSpread& spread = prior.classes[label];
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<double> middles, within, between;
      double objects = 0.0;
      for (const std::vector<double>& place : sides[side]) {
        middles.push_back(detail::median(place));
        detail::append_differences(place, within);
        objects += static_cast<double>(place.size());
      }
      detail::append_differences(middles, between);
      const auto count = static_cast<double>(middles.size());
      const double variance =
          detail::drawn_variance(within, 0.0, objects - count, prior.spread.within[side], weight);
      spread.within[side] = std::sqrt(variance);
      // The middle of a place errs by what its few objects differ.
      spread.between[side] =
          std::sqrt(detail::drawn_variance(between, variance * count / std::max(1.0, objects),
                                           count - 1.0, prior.spread.between[side], weight));
    }
  }
  return prior;
}

}  // namespace v0
}  // namespace topobag
