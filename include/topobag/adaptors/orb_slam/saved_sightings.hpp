// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/bag/detail/storage/crc32.hpp>
#include <topobag/bag/detail/storage/entry_record.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/keyframe_sighting.hpp>

namespace topobag {
inline namespace v0 {

/// What was seen in a key frame of the host, to be kept beside the host's own map.
struct SavedSighting {
  std::uint64_t id = 0;       ///< the host's, in the map that it belongs to
  std::uint32_t session = 0;  ///< which run saw it: stamps are compared within one alone
  KeyframeSighting sighting;  ///< what was seen
};

namespace detail {

inline constexpr std::uint64_t sightings_magic = 0x7374686769734254;  // "TBsights"
inline constexpr unsigned sightings_version = 1;

inline std::vector<std::uint8_t> to_bytes(const KeyframeSighting& sighting) {
  return encode(TopologyGraph<>(sighting.nodes, {}, {sighting.view}, sighting.gravity));
}

inline KeyframeSighting sighting_of(const std::vector<std::uint8_t>& bytes, double stamp) {
  const TopologyGraph<> graph = decode(bytes);
  if (graph.views().size() != 1) {
    throw FormatError("a sighting has one view; these are the bytes of something else");
  }
  if (!std::isfinite(stamp)) throw FormatError("a sighting's stamp is not finite: it is damaged");
  return {stamp, graph.nodes(), graph.views().front(), graph.gravity()};
}

}  // namespace detail

/// The sightings as bytes, the same on every machine: stamp, id and session to the last bit, nodes,
/// view and gravity rounded as `encode` does it with a graph. What is read back and written again
/// gives the same bytes. Throws as `require_savable`. O(nodes).
///
/// Format 1, little-endian: "TBsights", version (32 bits), count (64); of each: id (64), session
/// (32), stamp (IEEE double), length (32) and bytes of the graph with its view; CRC-32 of all that.
inline std::vector<std::uint8_t> encode(const std::vector<SavedSighting>& sightings) {
  detail::BitWriter writer;
  writer.put(detail::sightings_magic, 64);
  writer.put(detail::sightings_version, 32);
  writer.put(sightings.size(), 64);
  for (const SavedSighting& saved : sightings) {
    const std::vector<std::uint8_t> graph = detail::to_bytes(saved.sighting);
    writer.put(saved.id, 64);
    writer.put(saved.session, 32);
    detail::put_double(writer, saved.sighting.stamp);
    writer.put(graph.size(), 32);
    for (const std::uint8_t byte : graph) writer.put(byte, 8);
  }
  std::vector<std::uint8_t> bytes = writer.take();
  const std::uint32_t sum = detail::crc32(bytes.data(), bytes.size());
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(sum >> shift));
  }
  return bytes;
}

/// The sightings that `encode` wrote. Throws FormatError for bytes that are something else,
/// damaged, cut off or of a later version; memory is at most some 500 bytes for each byte that is
/// there.
inline std::vector<SavedSighting> decode_sightings(const std::vector<std::uint8_t>& bytes) {
  detail::BitReader reader(bytes.data(), bytes.size());
  if (bytes.size() < 24 || reader.get(64) != detail::sightings_magic) {
    throw FormatError("these are no sightings of topobag, or they are cut off");
  }
  const std::uint64_t version = reader.get(32);
  if (version != detail::sightings_version) {
    throw FormatError("sightings of format " + std::to_string(version) +
                      "; this version of topobag reads 1: update topobag");
  }
  const std::size_t content = bytes.size() - 4;
  detail::BitReader end(bytes.data() + content, 4);
  if (end.get(32) != detail::crc32(bytes.data(), content)) {
    throw FormatError("the sightings are damaged or cut off; take a complete copy");
  }
  std::vector<SavedSighting> sightings;
  std::set<std::uint64_t> ids;
  for (std::uint64_t left = reader.get(64); left > 0; --left) {
    SavedSighting saved;
    saved.id = reader.get(64);
    saved.session = static_cast<std::uint32_t>(reader.get(32));
    const double stamp = detail::get_double(reader);
    const std::uint64_t length = reader.get(32);
    if (length > reader.bits_left() / 8) throw FormatError("a sighting is cut off: it is damaged");
    std::vector<std::uint8_t> graph;
    for (std::uint64_t i = 0; i < length; ++i) {
      graph.push_back(static_cast<std::uint8_t>(reader.get(8)));
    }
    saved.sighting = detail::sighting_of(graph, stamp);
    if (!ids.insert(saved.id).second) {
      throw FormatError("the sightings hold key frame " + std::to_string(saved.id) + " twice");
    }
    sightings.push_back(std::move(saved));
  }
  if (reader.bits_left() != 32) throw FormatError("the sightings go on after their end");
  return sightings;
}

}  // namespace v0
}  // namespace topobag
