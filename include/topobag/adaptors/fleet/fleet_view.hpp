// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/adaptors/fleet/uuid.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// A session as a `FleetBag` numbers it: its number is the upper half of its key frames' ids and
/// their `EntryInfo::session`.
struct FleetSession {
  std::string site;              ///< where it was mapped
  Uuid robot{};                  ///< whose it is
  Uuid session{};                ///< of that robot
  std::uint32_t upper_half = 0;  ///< of the robot's own numbers, which a robot may use up to 2^64
  std::string run;               ///< the robot's name for it
};

/// The key frames of a fleet as a `FleetBag` knew them at one moment. Never changes, and may be
/// read from any number of threads. Its ids are the bag's own; `key` says whose they are.
///
/// A bag that is asked alone (`is_searchable_bag_v`): its ids mean nothing outside of it, so that
/// `for_each` tells keys, and neither `save` nor a `merge` takes it (`is_stored_bag_v` is false).
class FleetView {
 public:
  using Graph = BagView::Graph;
  using Sessions = std::vector<FleetSession>;

  /// For `FleetBag`, which makes views.
  FleetView(std::shared_ptr<const BagView> bag, std::shared_ptr<const Sessions> sessions)
      : bag_(std::move(bag)), sessions_(std::move(sessions)) {}

  std::size_t size() const noexcept { return bag_->size(); }
  bool empty() const noexcept { return bag_->empty(); }
  bool contains(KeyframeId id) const { return bag_->contains(id); }
  std::optional<Graph> find(KeyframeId id) const { return bag_->find(id); }
  std::optional<EntryInfo> info(KeyframeId id) const { return bag_->info(id); }
  std::optional<KeyframeId> after(KeyframeId id) const { return bag_->after(id); }
  std::optional<KeyframeId> before(KeyframeId id) const { return bag_->before(id); }
  /// As `BagView::within`; sites that share coordinates are not told apart.
  std::vector<KeyframeId> within(const MapRegion& region) const { return bag_->within(region); }
  /// As `BagView` counts them; frames of sites that share coordinates count as one place.
  std::size_t places() const noexcept { return bag_->places(); }
  /// As `BagView::places_holding`.
  std::size_t places_holding(const ClassCounts& objects, const ClassGroups& groups = {}) const {
    return bag_->places_holding(objects, groups);
  }
  /// As `BagView::appearance_kind`.
  AppearanceKind appearance_kind() const noexcept { return bag_->appearance_kind(); }
  /// As `BagView::image_kind`.
  ImageKind image_kind() const noexcept { return bag_->image_kind(); }
  MemoryUsage memory_usage() const { return bag_->memory_usage(); }

  /// By number.
  const Sessions& sessions() const noexcept { return *sessions_; }

  /// Where, who, on which run, and the robot's own number. Throws InvalidId for an id that the bag
  /// has never given.
  FleetKey key(KeyframeId id) const {
    const std::uint64_t number = value(id) >> 32;
    if (number >= sessions_->size()) {
      throw InvalidId("key frame " + std::to_string(value(id)) + " is none of this fleet's bag");
    }
    const FleetSession& session = (*sessions_)[number];
    const std::uint64_t lower_half = value(id) & 0xFFFFFFFF;
    return {session.site, session.robot, session.session,
            KeyframeId{std::uint64_t{session.upper_half} << 32 | lower_half}};
  }

  /// The entries most similar to `graph`, best first, ties by key: what one bag over all key frames
  /// numbered by their keys would answer, to the last bit, whatever order they came in.
  std::vector<Candidate> query(const Graph& graph, const QueryOptions& options = {}) const {
    if (options.max_results == 0) return {};
    // The bag breaks ties by its own ids: all that tie with the last one have to be seen.
    QueryOptions wider = options;
    std::vector<Candidate> found;
    for (wider.max_results = beyond(options.max_results);;
         wider.max_results = beyond(found.size())) {
      found = bag_->query(graph, wider);
      if (found.size() < wider.max_results) break;
      if (found.back().similarity < found[options.max_results - 1].similarity) break;
    }
    std::sort(found.begin(), found.end(), [&](const Candidate& l, const Candidate& r) {
      return l.similarity != r.similarity ? l.similarity > r.similarity
                                          : key_order(l.id) < key_order(r.id);
    });
    if (found.size() > options.max_results) found.resize(options.max_results);
    return found;
  }

  /// Calls `visit(const FleetKey&, const EntryInfo&, const Graph&)` for every entry, by key.
  /// O(n log n).
  template <typename Visit, std::enable_if_t<std::is_invocable_v<const Visit&, const FleetKey&,
                                                                 const EntryInfo&, const Graph&>,
                                             int> = 0>
  void for_each(const Visit& visit) const {
    std::vector<KeyframeId> ids;
    bag_->for_each([&](KeyframeId id, const auto&, const auto&) { ids.push_back(id); });
    std::sort(ids.begin(), ids.end(),
              [&](KeyframeId l, KeyframeId r) { return key_order(l) < key_order(r); });
    for (const KeyframeId id : ids) visit(key(id), *bag_->info(id), *bag_->find(id));
  }

 private:
  static std::size_t beyond(std::size_t results) {
    return results > SIZE_MAX / 2 ? SIZE_MAX : 2 * results;
  }

  std::tuple<const std::string&, const Uuid&, const Uuid&, std::uint32_t, std::uint64_t> key_order(
      KeyframeId id) const {
    const FleetSession& session = (*sessions_)[value(id) >> 32];
    return {session.site, session.robot, session.session, session.upper_half,
            value(id) & 0xFFFFFFFF};
  }

  std::shared_ptr<const BagView> bag_;
  std::shared_ptr<const Sessions> sessions_;
};

}  // namespace v0
}  // namespace topobag
