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
#include <topobag/bag/detail/storage/entry_record.hpp>
#include <topobag/bag/detail/storage/file_bytes.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/snapshot_header.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// What is saved beside the entries themselves.
struct SaveOptions {
  std::uint64_t catalog_fingerprint = 0;  ///< of the classes in use; 0 = not stated
  ViewSection views = ViewSection::kept;  ///< whether views are written
};

namespace detail {

/// Length, bytes and checksum of both.
inline void write_record(std::ostream& stream, const std::vector<std::uint8_t>& body) {
  BitWriter length;
  length.put(body.size(), 32);
  std::vector<std::uint8_t> record = length.take();
  record.insert(record.end(), body.begin(), body.end());
  BitWriter checksum;
  checksum.put(crc32(record.data(), record.size()), 32);
  for (const std::uint8_t byte : checksum.take()) record.push_back(byte);
  write_bytes(stream, record);
}

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

inline std::vector<std::uint8_t> read_record(std::istream& stream) {
  const std::vector<std::uint8_t> length = read_bytes(stream, 4);
  std::vector<std::uint8_t> body = read_bytes(stream, BitReader(length.data(), 4).get(32));
  const std::vector<std::uint8_t> checksum = read_bytes(stream, 4);
  const std::uint32_t found = crc32(body.data(), body.size(), crc32(length.data(), 4));
  if (BitReader(checksum.data(), 4).get(32) != found) {
    throw FormatError("its checksum does not fit: it is damaged; take another copy");
  }
  return body;
}

}  // namespace detail

/// Writes a bag as it stands, in the order of ids: graphs through `encode`, the rest to the last
/// bit; the header says the latest version among the graphs, each of which is in the least one that
/// holds it. The same bag gives the same bytes on every machine. (The format:
/// `examples/docs/format.md`.)
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
  bag.for_each([&](KeyframeId, const EntryInfo& info, const typename Bag::Graph& graph) {
    if (info.image.known()) header.format_version = 2;
    header.codec_version =
        std::max<std::uint32_t>(header.codec_version, codec_version_for(graph, options.views));
  });
  detail::write_bytes(stream, to_bytes(header));
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
  static_assert(is_growing_bag_v<Bag>,
                "topobag: a bag that grows has Graph = TopologyGraph<Scalar> and add(KeyframeId, "
                "Graph, EntryInfo).");
  using Scalar = typename Bag::Graph::Scalar;
  TOPOBAG_ASSERT(empty.empty());
  const SnapshotHeader header = inspect(stream);
  if (catalog_fingerprint != 0 && header.catalog_fingerprint != 0 &&
      catalog_fingerprint != header.catalog_fingerprint) {
    throw FormatError(
        "its class numbers mean other names than yours; load it with the catalog that it was "
        "saved with");
  }
  std::optional<KeyframeId> last;
  for (std::uint64_t i = 0; i < header.entries; ++i) {
    try {
      detail::EntryRecord entry = detail::entry_of(detail::read_record(stream));
      if (last && !(*last < entry.id)) throw FormatError("its id is not above the one before");
      last = entry.id;
      empty.add(entry.id, decode<Scalar>(entry.graph), std::move(entry.info));
    } catch (const Error& error) {
      throw FormatError("entry " + std::to_string(i) + " of " + std::to_string(header.entries) +
                            " cannot be read: " + error.what(),
                        static_cast<std::size_t>(i));
    }
  }
  return empty;
}

}  // namespace v0
}  // namespace topobag
