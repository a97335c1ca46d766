// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// What an encoded graph says of itself before its nodes, and in which version that can be said.
struct GraphHeader {
  unsigned version = 1;
  bool views = false;       ///< whether they follow the edges
  bool gravity = false;     ///< whether it follows these; from version 2 on
  bool appearance = false;  ///< whether it follows these; from version 2 on
  bool depth = false;       ///< whether it follows these, of the views; from version 2 on
};

/// Writes the header's bits.
inline void put_header(BitWriter& writer, const GraphHeader& header) {
  writer.put(header.version, 4);
  writer.put(header.views ? 1 : 0, 1);
  if (header.version < 2) return;
  writer.put(header.gravity ? 1 : 0, 1);
  writer.put(header.appearance ? 1 : 0, 1);
  writer.put(header.depth ? 1 : 0, 1);
}

/// Reads the header's bits, all of the first byte at most, from a `BitReader` or `TrustedBits`.
/// What a version says that is none or a later one means nothing.
template <typename Bits>
GraphHeader get_header(Bits& bits) {
  GraphHeader header;
  header.version = static_cast<unsigned>(bits.get(4));
  header.views = bits.get(1) != 0;
  if (header.version < 2) return header;
  header.gravity = bits.get(1) != 0;
  header.appearance = bits.get(1) != 0;
  header.depth = bits.get(1) != 0;
  return header;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
