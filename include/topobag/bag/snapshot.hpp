// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <topobag/assert.hpp>
#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/detail/storage/catalog_record.hpp>
#include <topobag/bag/detail/storage/entry_record.hpp>
#include <topobag/bag/detail/storage/file_bytes.hpp>
#include <topobag/bag/detail/storage/file_record.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/snapshot_header.hpp>
#include <topobag/error.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

namespace topobag {
inline namespace v0 {

/// What is saved beside the entries themselves.
struct SaveOptions {
  std::uint64_t catalog_fingerprint = 0;  ///< of the classes in use; 0 = not stated
  /// Whether views are written, with the depth that they measured. They say what a camera would have
  /// seen: without them, nothing that is missing speaks against a match of the loaded map, so that it
  /// may accept what the saved one refused.
  ViewSection views = ViewSection::kept;
  /// The classes in use, which the file then keeps (format 2); nothing: their fingerprint alone.
  std::optional<DescribedCatalog> catalog{};
};

namespace detail {

/// `encode`, whose refusal names the key frame: in the middle of a bag an index alone says little.
template <typename Graph>
std::vector<std::uint8_t> encoded(KeyframeId id, const Graph& graph, ViewSection views) {
  try {
    return encode(graph, views);
  } catch (const InvalidValue& error) {
    throw InvalidValue("key frame " + std::to_string(value(id)) + ": " + error.what(),
                       error.index());
  }
}

/// The catalog that follows a header which says so. Throws FormatError.
inline std::optional<DescribedCatalog> read_catalog(std::istream& stream,
                                                    const SnapshotHeader& header) {
  if (!header.catalog) return std::nullopt;
  try {
    DescribedCatalog classes = catalog_of(read_record(stream));
    if (fingerprint(classes.catalog) == header.catalog_fingerprint) return classes;
  } catch (const Error& error) {
    throw FormatError(std::string("its classes cannot be read: ") + error.what());
  }
  throw FormatError("its classes are not those that its header means: it is damaged");
}

/// Throws FormatError where both are known and differ.
inline void require_same_names(const SnapshotHeader& header, std::uint64_t catalog_fingerprint) {
  if (catalog_fingerprint == 0 || header.catalog_fingerprint == 0 ||
      catalog_fingerprint == header.catalog_fingerprint) {
    return;
  }
  throw FormatError(
      "its class numbers mean other names than yours; load it with the catalog that it was "
      "saved with");
}

/// Adds the entries that follow header and catalog. Throws FormatError.
template <typename Bag>
Bag load_entries(std::istream& stream, std::uint64_t count, Bag bag) {
  static_assert(is_growing_bag_v<Bag>,
                "topobag: a bag that grows has Graph = TopologyGraph<Scalar> and add(KeyframeId, "
                "Graph, EntryInfo).");
  using Scalar = typename Bag::Graph::Scalar;
  TOPOBAG_ASSERT(bag.empty());
  std::optional<KeyframeId> last;
  for (std::uint64_t i = 0; i < count; ++i) {
    try {
      EntryRecord entry = entry_of(read_record(stream));
      if (last && !(*last < entry.id)) throw FormatError("its id is not above the one before");
      last = entry.id;
      bag.add(entry.id, decode<Scalar>(entry.graph), std::move(entry.info));
    } catch (const Error& error) {
      throw FormatError("entry " + std::to_string(i) + " of " + std::to_string(count) +
                            " cannot be read: " + error.what(),
                        static_cast<std::size_t>(i));
    }
  }
  return bag;
}

}  // namespace detail

/// Writes a bag as it stands, in the order of ids: graphs through `encode`, the rest to the last
/// bit; the catalog where `options` has one; the header says the latest version among the graphs,
/// each of which is in the least one that holds it. The same bag gives the same bytes on every
/// machine. (The format: `examples/docs/format.md`.)
/// @param bag  anything with `size()` and `for_each(f)` that calls f(KeyframeId, const EntryInfo&,
///             const Graph&) by rising id
/// Throws Error when the stream fails, InvalidValue as `encode` does. O(n), in two rounds.
template <typename Bag>
void save(const Bag& bag, std::ostream& stream, const SaveOptions& options = {}) {
  static_assert(is_stored_bag_v<Bag>,
                "topobag: a bag to save has Graph = TopologyGraph<Scalar>, size() const and "
                "for_each(visit) const, which "
                "calls visit(KeyframeId, const EntryInfo&, const Graph&).");
  using Scalar = typename Bag::Graph::Scalar;
  SnapshotHeader header;
  header.scalar_bytes = sizeof(Scalar);
  header.entries = bag.size();
  header.catalog_fingerprint = options.catalog_fingerprint;
  if (options.catalog) {
    header.format_version = 2;
    header.catalog = true;
    header.catalog_fingerprint = fingerprint(options.catalog->catalog);
  }
  bag.for_each([&](KeyframeId, const EntryInfo& info, const typename Bag::Graph& graph) {
    if (info.image.known()) header.format_version = 2;
    header.codec_version =
        std::max<std::uint32_t>(header.codec_version, codec_version_for(graph, options.views));
  });
  detail::write_bytes(stream, to_bytes(header));
  if (options.catalog) detail::write_record(stream, detail::to_bytes(*options.catalog));
  std::uint64_t written = 0;
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const typename Bag::Graph& graph) {
    detail::write_record(stream,
                         detail::to_bytes({id, info, detail::encoded(id, graph, options.views)}));
    ++written;
  });
  TOPOBAG_ASSERT(written == header.entries);
  static_cast<void>(written);
}

/// The bag that `save` wrote. Nothing is taken on trust: whatever is truncated, damaged, foreign or
/// of a later version is refused with a FormatError that carries the entry's place, before room is
/// made for it. Reads to the end of the last entry and no further.
/// @param catalog_fingerprint  of the classes in use; where it and the saved one are known they
///                             have to be the same. 0 = not known
/// @param empty                what to fill by `add`: a bag with a similarity of yours
/// Throws FormatError. O(n · add).
template <typename Bag = BagOfTopologyGraphs<>>
Bag load(std::istream& stream, std::uint64_t catalog_fingerprint = 0, Bag empty = Bag{}) {
  const SnapshotHeader header = inspect(stream);
  detail::require_same_names(header, catalog_fingerprint);
  detail::read_catalog(stream, header);
  return detail::load_entries(stream, header.entries, std::move(empty));
}

/// The same with all that is said of the classes in use: where the file keeps its catalog, the two
/// may have no `difference`.
template <typename Bag = BagOfTopologyGraphs<>>
Bag load(std::istream& stream, const DescribedCatalog& classes, Bag empty = Bag{}) {
  const SnapshotHeader header = inspect(stream);
  detail::require_same_names(header, fingerprint(classes.catalog));
  const std::optional<DescribedCatalog> kept = detail::read_catalog(stream, header);
  if (kept) detail::require_same_classes(*kept, classes);
  return detail::load_entries(stream, header.entries, std::move(empty));
}

/// The classes that a saved bag keeps, if it does. Throws FormatError. O(classes).
inline std::optional<DescribedCatalog> saved_catalog(std::istream& stream) {
  const SnapshotHeader header = inspect(stream);
  return detail::read_catalog(stream, header);
}

}  // namespace v0
}  // namespace topobag
