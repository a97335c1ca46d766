// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include <topobag/adaptors/orb_slam/host_maps.hpp>
#include <topobag/adaptors/orb_slam/host_traits.hpp>
#include <topobag/bag/entry_filter.hpp>
#include <topobag/recognition/recognition_options.hpp>

namespace topobag {
inline namespace v0 {

/// Which of a host's maps are asked.
enum class AskedMaps {
  all,       ///< whatever map
  this_one,  ///< `AskedKeyFrames::map` alone: loops, re-localization
  others,    ///< all but that one: merges
};

/// Which key frames may be found: asked before anything is ranked, so that no other takes a place
/// among the candidates.
template <typename KeyFrame>
struct AskedKeyFrames {
  std::set<const KeyFrame*> excluded{};  ///< these are not
  std::optional<PresentVisit> not_of{};  ///< nor are those of the present visit
  AskedMaps maps = AskedMaps::all;       ///< with several maps: those of which
  const void* map = nullptr;             ///< "this one"; places in another one are marked

  /// That key frame and its covisible ones may not be found. Calls the host.
  void leave_out(KeyFrame& key_frame) {
    excluded.insert(&key_frame);
    for (const auto& other : host_traits<KeyFrame>::neighbors(key_frame)) {
      if (other != nullptr) excluded.insert(&*other);
    }
  }

  /// Whether the key frame may be found, its stamp aside. Calls the host.
  bool contains(KeyFrame& key_frame) const {
    if (excluded.count(&key_frame) != 0 || is_bad(key_frame)) return false;
    return maps == AskedMaps::all || (map_of(key_frame) == map) == (maps == AskedMaps::this_one);
  }
};

namespace detail {

/// The options with which those ids alone are found, rising, which have to stay, besides what the
/// options ask for themselves.
template <typename KeyFrame>
RecognitionOptions options_among(const RecognitionOptions& options,
                                 const std::vector<std::uint64_t>& ids,
                                 const AskedKeyFrames<KeyFrame>& asked) {
  RecognitionOptions among = options;
  if (asked.not_of) among.retrieval.among.not_of = asked.not_of;
  const auto& wanted = options.retrieval.filter;
  among.retrieval.filter = [&ids, &wanted](KeyframeId id, const EntryInfo& info) {
    return std::binary_search(ids.begin(), ids.end(), value(id)) && (!wanted || wanted(id, info));
  };
  return among;
}

}  // namespace detail

}  // namespace v0
}  // namespace topobag
