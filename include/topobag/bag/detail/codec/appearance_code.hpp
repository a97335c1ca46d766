// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/error.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

inline constexpr unsigned kind_number_width = 32;
inline constexpr unsigned kind_length_width = 6;  // of the length less one

/// Writes what the nodes of a graph look like: the kind once, then of each node whether it has a
/// descriptor, and its bytes.
template <typename Scalar>
void put_appearances(BitWriter& writer, const std::vector<SemanticNode<Scalar>>& nodes,
                     AppearanceKind kind) {
  writer.put(kind.number(), kind_number_width);
  writer.put(kind.length() - 1, kind_length_width);
  for (const SemanticNode<Scalar>& node : nodes) {
    writer.put(node.appearance.known() ? 1 : 0, 1);
    if (!node.appearance.known()) continue;
    for (std::size_t i = 0; i < kind.length(); ++i) {
      writer.put(static_cast<std::uint8_t>(node.appearance.bytes()[i]), 8);
    }
  }
}

/// Throws FormatError.
template <typename Scalar>
void get_appearances(BitReader& reader, std::vector<SemanticNode<Scalar>>& nodes) {
  const auto number = static_cast<std::uint32_t>(reader.get(kind_number_width));
  const AppearanceKind kind(number, static_cast<std::size_t>(reader.get(kind_length_width)) + 1);
  bool any = false;
  for (SemanticNode<Scalar>& node : nodes) {
    if (reader.get(1) == 0) continue;
    Appearance::Bytes bytes{};
    for (std::size_t i = 0; i < kind.length(); ++i) {
      bytes[i] = static_cast<std::int8_t>(static_cast<std::uint8_t>(reader.get(8)));
    }
    if (bytes == Appearance::Bytes{}) {
      throw FormatError("the data hold a descriptor of zeros: they are damaged");
    }
    node.appearance = Appearance(kind, bytes);
    any = true;
  }
  if (!any) throw FormatError("the data name a kind of appearance and hold none: they are damaged");
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
