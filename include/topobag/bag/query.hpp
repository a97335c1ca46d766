// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <tuple>

#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/image_comparison.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// s; key frames of one session that are nearer in time are usually of one visit, and make no loop.
inline constexpr double usual_loop_gap = 20.0;

/// Key frames too near to the query to count as another visit.
struct ExcludedNeighbors {
  /// The query's; with it, ids less than `min_id_gap` away are left out.
  std::optional<KeyframeId> id;
  std::uint64_t min_id_gap = 1;  ///< ids nearer to `id` than this are left out
  /// The query's, s; with it, entries without a stamp are left out, and those whose stamp is less
  /// than `min_time_gap` away.
  std::optional<double> stamp;
  double min_time_gap = 0.0;  ///< s; entries nearer to `stamp` than this are left out
  /// The query's; with it, entries of other sessions are never near in time.
  std::optional<std::uint32_t> session;

  /// Whether the entry is too near to the query.
  bool contains(KeyframeId entry, const EntryInfo& info) const {
    if (id) {
      const std::uint64_t a = value(*id), b = value(entry);
      if ((a > b ? a - b : b - a) < min_id_gap) return true;
    }
    if (session && info.session != *session) return false;
    return stamp && (!info.stamp || std::abs(*info.stamp - *stamp) < min_time_gap);
  }
};

/// Which entries are asked, and how many come back.
struct QueryOptions {
  std::size_t max_results = 10;  ///< the best so many
  double min_similarity = 0.0;   ///< similarity below which an entry is no candidate
  ExcludedNeighbors exclude{};   ///< key frames of the present visit
  EntryFilter among{};           ///< by id, time, session, label and region
  ImageComparison image{};       ///< how like the whole images are, as a gate or in the similarity
  std::function<bool(KeyframeId, const EntryInfo&)>
      filter{};  ///< when set, only entries it returns true for

  /// Whether there is an entry that might not be asked.
  bool restricts() const {
    return among.restricts() || exclude.id || exclude.stamp || image.restricts() ||
           static_cast<bool>(filter);
  }

  /// Whether an entry is asked at all.
  bool admits(KeyframeId id, const EntryInfo& info) const {
    return among.contains(id, info) && !exclude.contains(id, info) && image.admits(info) &&
           (!filter || filter(id, info));
  }
};

/// An entry of the bag that resembles the query.
struct Candidate {
  KeyframeId id{};          ///< of the entry
  double similarity = 0.0;  ///< to the query, in [0, 1]; with the image's share, if it has one

  /// Best first: by falling similarity, ties by id.
  friend bool operator<(const Candidate& l, const Candidate& r) noexcept {
    return std::tie(r.similarity, l.id) < std::tie(l.similarity, r.id);
  }
  friend bool operator==(const Candidate& l, const Candidate& r) noexcept {
    return l.id == r.id && l.similarity == r.similarity;
  }
};

}  // namespace v0
}  // namespace topobag
