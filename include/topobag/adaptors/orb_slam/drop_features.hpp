// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/assert.hpp>

namespace topobag {
inline namespace v0 {

/// Takes features out of a frame of ORB-SLAM that was only just constructed: it is then as if they
/// had never been extracted. Later is too late: words, matches and key frames go by their indices.
///
/// @tparam Frame  ORB-SLAM's, of one camera: with N, mvKeys, mvKeysUn, mvuRight, mvDepth,
///                mDescriptors, mvpMapPoints, mvbOutlier, mGrid
/// @param drop    a value a feature, as `DynamicFeatureMask::masked` gives them
/// @return how many are gone. Those that stay keep their order. O(N + cells of the grid).
template <typename Frame>
std::size_t drop_features(Frame& frame, const std::vector<bool>& drop) {
  TOPOBAG_ASSERT(drop.size() == static_cast<std::size_t>(frame.N));
  std::vector<std::size_t> kept;
  std::vector<std::size_t> new_index(drop.size());
  for (std::size_t i = 0; i < drop.size(); ++i) {
    new_index[i] = kept.size();
    if (!drop[i]) kept.push_back(i);
  }
  if (kept.size() == drop.size()) return 0;

  const auto compact = [&kept](auto& values) {
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];
    values.resize(kept.size());
  };
  compact(frame.mvKeys);
  compact(frame.mvKeysUn);
  compact(frame.mvuRight);
  compact(frame.mvDepth);
  compact(frame.mvpMapPoints);
  compact(frame.mvbOutlier);
  decltype(frame.mDescriptors) descriptors;
  for (const std::size_t i : kept) {
    descriptors.push_back(frame.mDescriptors.row(static_cast<int>(i)));
  }
  frame.mDescriptors = descriptors;
  for (auto& column : frame.mGrid) {
    for (auto& cell : column) {
      std::size_t count = 0;
      for (const std::size_t i : cell) {
        if (!drop[i]) cell[count++] = new_index[i];
      }
      cell.resize(count);
    }
  }
  frame.N = static_cast<int>(kept.size());
  return drop.size() - kept.size();
}

}  // namespace v0
}  // namespace topobag
