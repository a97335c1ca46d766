// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/bag/detail/present_view.hpp>
#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/place_contents.hpp>
#include <topobag/bag/query.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The reading side of a bag that is kept elsewhere as well: every call is answered by a bag in
/// memory that holds the same. Where calls are not every bag's, it has those of that one.
template <typename Bag_>
class ReadsFromMemory {
 public:
  using Bag = Bag_;
  using Graph = typename Bag::Graph;

  /// The bag in memory.
  const Bag& bag() const noexcept { return bag_; }

  /// To be dereferenced: a view of the bag in memory where it has one, which never changes, else
  /// that bag itself.
  auto view() const { return present_view(bag_, 0); }

  std::size_t size() const { return bag_.size(); }
  bool empty() const { return bag_.size() == 0; }
  bool contains(KeyframeId id) const { return bag_.contains(id); }
  /// The key frame's graph as it is stored, or nothing.
  std::optional<Graph> find(KeyframeId id) const { return bag_.find(id); }
  /// What is known of the key frame beside its graph, or nothing.
  std::optional<EntryInfo> info(KeyframeId id) const { return bag_.info(id); }
  /// The entries most similar to `graph`, best first, ties by id.
  std::vector<Candidate> query(const Graph& graph, const QueryOptions& options = {}) const {
    return bag_.query(graph, options);
  }
  /// Calls f(KeyframeId, const EntryInfo&, const Graph&) for every entry, as the bag does.
  template <typename F>
  void for_each(F&& f) const {
    bag_.for_each(std::forward<F>(f));
  }

  /// The key frame's graph where it is, or null.
  template <typename B = Bag>
  auto peek(KeyframeId id) const -> decltype(std::declval<const B&>().peek(id)) {
    return bag_.peek(id);
  }
  /// The id next to this one; nothing at the end.
  template <typename B = Bag>
  auto after(KeyframeId id) const -> decltype(std::declval<const B&>().after(id)) {
    return bag_.after(id);
  }
  template <typename B = Bag>
  auto before(KeyframeId id) const -> decltype(std::declval<const B&>().before(id)) {
    return bag_.before(id);
  }
  /// The key frames whose cameras stand in the region, by rising id.
  template <typename B = Bag>
  auto within(const MapRegion& region) const -> decltype(std::declval<const B&>().within(region)) {
    return bag_.within(region);
  }
  /// Different places among the entries.
  template <typename B = Bag>
  auto places() const -> decltype(std::declval<const B&>().places()) {
    return bag_.places();
  }
  /// The most of them that can hold all of `objects`.
  template <typename B = Bag>
  auto places_holding(const ClassCounts& objects, const ClassGroups& groups = {}) const
      -> decltype(std::declval<const B&>().places_holding(objects, groups)) {
    return bag_.places_holding(objects, groups);
  }
  /// The one kind of the descriptors that were added; of length 0 where none was.
  template <typename B = Bag>
  auto appearance_kind() const -> decltype(std::declval<const B&>().appearance_kind()) {
    return bag_.appearance_kind();
  }
  /// The same of the whole images' descriptors.
  template <typename B = Bag>
  auto image_kind() const -> decltype(std::declval<const B&>().image_kind()) {
    return bag_.image_kind();
  }

 protected:
  explicit ReadsFromMemory(Bag bag) : bag_(std::move(bag)) {}
  ~ReadsFromMemory() = default;
  ReadsFromMemory(ReadsFromMemory&&) = default;
  ReadsFromMemory& operator=(ReadsFromMemory&&) = default;

  Bag bag_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
