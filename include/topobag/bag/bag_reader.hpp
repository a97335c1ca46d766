// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/place_contents.hpp>
#include <topobag/bag/query.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// The reading calls that bags have in common, for one that answers by a view: `IndexedBag`,
/// `SqliteBag`, `FleetBag`. Each asks the bag as it is now; who wants several answers about one
/// moment takes the `view()`. Where a call is not every view's, a bag has it as its view does.
///
/// @tparam Bag   derives from this, and has a `view()`, to be dereferenced
/// @tparam View  what that gives: with `size`, `contains`, `find`, `info` and `query`
template <typename Bag, typename View>
class BagReader {
 public:
  using Graph = typename View::Graph;

  std::size_t size() const { return read()->size(); }
  bool empty() const { return size() == 0; }
  bool contains(KeyframeId id) const { return read()->contains(id); }
  /// The key frame's graph as it is stored, or nothing.
  std::optional<Graph> find(KeyframeId id) const { return read()->find(id); }
  /// What is known of the key frame beside its graph, or nothing.
  std::optional<EntryInfo> info(KeyframeId id) const { return read()->info(id); }
  /// The entries most similar to `graph`, best first, ties by id. Throws as the view.
  std::vector<Candidate> query(const Graph& graph, const QueryOptions& options = {}) const {
    return read()->query(graph, options);
  }

  /// Calls `visit(KeyframeId, const EntryInfo&, const Graph&)` for every entry, as the view does.
  template <typename Visit, typename V = View>
  auto for_each(Visit&& visit) const -> decltype(std::declval<const V&>().for_each(visit)) {
    return read()->for_each(visit);
  }
  /// The key frame's graph where it is, or null; of a bag that keeps graphs as they are.
  template <typename V = View>
  auto peek(KeyframeId id) const -> decltype(std::declval<const V&>().peek(id)) {
    return read()->peek(id);
  }
  /// The least id above this one, which need not be there itself; nothing at the end.
  template <typename V = View>
  auto after(KeyframeId id) const -> decltype(std::declval<const V&>().after(id)) {
    return read()->after(id);
  }
  /// The greatest id below this one, which need not be there itself; nothing at the end.
  template <typename V = View>
  auto before(KeyframeId id) const -> decltype(std::declval<const V&>().before(id)) {
    return read()->before(id);
  }
  /// The key frames whose cameras stand in the region, by rising id; without a pose they are
  /// nowhere.
  template <typename V = View>
  auto within(const MapRegion& region) const -> decltype(std::declval<const V&>().within(region)) {
    return read()->within(region);
  }
  /// Different places among the entries. O(1).
  template <typename V = View>
  auto places() const -> decltype(std::declval<const V&>().places()) {
    return read()->places();
  }
  /// The most of them that can hold all of `objects`. O(classes²).
  template <typename V = View>
  auto places_holding(const ClassCounts& objects, const ClassGroups& groups = {}) const
      -> decltype(std::declval<const V&>().places_holding(objects, groups)) {
    return read()->places_holding(objects, groups);
  }
  /// The one kind of the descriptors that were added; of length 0 where none was.
  template <typename V = View>
  auto appearance_kind() const -> decltype(std::declval<const V&>().appearance_kind()) {
    return read()->appearance_kind();
  }
  /// The same of the whole images' descriptors.
  template <typename V = View>
  auto image_kind() const -> decltype(std::declval<const V&>().image_kind()) {
    return read()->image_kind();
  }
  /// Bytes of what the view holds. O(n).
  template <typename V = View>
  auto memory_usage() const -> decltype(std::declval<const V&>().memory_usage()) {
    return read()->memory_usage();
  }

 protected:
  /// Goes with the bag.
  ~BagReader() = default;

 private:
  auto read() const { return static_cast<const Bag&>(*this).view(); }
};

}  // namespace v0
}  // namespace topobag
