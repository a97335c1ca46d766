// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

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
