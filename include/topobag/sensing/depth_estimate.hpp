// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <topobag/sensing/depth_sampling.hpp>
#include <topobag/types/bounding_box.hpp>

namespace topobag {
inline namespace v0 {

/// A depth, and what the samples that it was taken from say of its error.
struct DepthEstimate {
  double z = 0.0;  ///< along the optical axis, m
  double deviation =
      0.0;  ///< m, one σ; beside the sensor's noise (`NodeNoise`), which no spread of
            ///< samples shows in full, for their errors have common causes. 0 = none
};

namespace detail {

template <typename Sampling, typename Depth, typename = void>
struct tells_deviation : std::false_type {};

template <typename Sampling, typename Depth>
struct tells_deviation<Sampling, Depth,
                       std::enable_if_t<std::is_convertible_v<
                           decltype(std::declval<const Sampling&>().estimate(
                               std::declval<const Depth&>(), std::declval<const BoundingBox&>())),
                           std::optional<DepthEstimate>>>> : std::true_type {};

/// The deviation of a median of these numbers, by how they spread about their own:
/// √(π/2) · 1.4826 · b_n · MAD / √n, with b_n for the little that few numbers spread (Croux and
/// Rousseeuw 1992). A single one tells nothing: 0. Precondition: there is one. O(n).
inline double deviation_of_median(std::vector<double> numbers) {
  constexpr std::array<double, 10> few{0.0,   0.0, 1.196, 1.495, 1.363,
                                       1.206, 1.2, 1.14,  1.129, 1.107};
  const auto median = [](std::vector<double>& of) {
    const auto upper = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
    std::nth_element(of.begin(), upper, of.end());
    if (of.size() % 2 == 1) return *upper;
    return (*std::max_element(of.begin(), upper) + *upper) / 2.0;
  };
  const auto n = static_cast<double>(numbers.size());
  const double middle = median(numbers);
  for (double& number : numbers) number = std::abs(number - middle);
  const double of_few = numbers.size() < few.size() ? few[numbers.size()] : n / (n - 0.8);
  return 1.2533141 * 1.4826 * of_few * median(numbers) / std::sqrt(n);
}

}  // namespace detail

/// Whether a depth sampling policy tells how well it knows a depth, too:
/// `sampling.estimate(depth source, box) -> std::optional<DepthEstimate>`.
template <typename Sampling, typename Depth>
inline constexpr bool tells_deviation_v = detail::tells_deviation<Sampling, Depth>::value;

/// The depth in a box by a sampling policy, with its deviation where that is told.
template <typename Sampling, typename Depth>
std::optional<DepthEstimate> sampled_depth(const Sampling& sampling, const Depth& depth,
                                           const BoundingBox& box) {
  if constexpr (tells_deviation_v<Sampling, Depth>) {
    return sampling.estimate(depth, box);
  } else {
    const std::optional<double> z = sampling(depth, box);
    return z ? std::make_optional(DepthEstimate{*z, 0.0}) : std::nullopt;
  }
}

}  // namespace v0
}  // namespace topobag
