// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include <topobag/types/detection.hpp>

namespace topobag {
inline namespace v0 {

/// Drops every detection that overlaps a more confident one of its class by more than `max_iou`.
/// Most confident first, ties in the order given. O(n · kept).
/// @param detections  a vector of `Detection`
template <typename Detections = std::vector<Detection>>
Detections suppress_non_maxima(Detections detections, double max_iou) {
  std::stable_sort(detections.begin(), detections.end(), detail::IsSurer{});
  Detections kept;
  for (const Detection& detection : detections) {
    const bool suppressed = std::any_of(kept.begin(), kept.end(), [&](const Detection& better) {
      return better.label == detection.label &&
             intersection_over_union(better.box, detection.box) > max_iou;
    });
    if (!suppressed) kept.push_back(detection);
  }
  return kept;
}

}  // namespace v0
}  // namespace topobag
