// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <topobag/bag/detail/codec/packed_column.hpp>
#include <topobag/edges/edge_list.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Counts the pairs (a, b), a < b, of n nodes in canonical order.
class PairNumbers {
 public:
  explicit PairNumbers(std::size_t nodes) : nodes_(nodes) {}

  std::uint64_t count() const noexcept {
    const std::uint64_t n = nodes_;
    return n < 2 ? 0 : n * (n - 1) / 2;
  }
  std::uint64_t number(const Edge& edge) const noexcept {
    return first_of(value(edge.a)) + (value(edge.b) - value(edge.a) - 1);
  }

  /// The pair of a number. Precondition: numbers come ascending, below `count()`.
  Edge next(std::uint64_t number) {
    while (number >= first_of(row_ + 1)) ++row_;
    const std::uint64_t b = row_ + 1 + (number - first_of(row_));
    return {node_index(static_cast<std::size_t>(row_)), node_index(static_cast<std::size_t>(b))};
  }

 private:
  /// The number of the pair (a, a + 1).
  std::uint64_t first_of(std::uint64_t a) const noexcept { return a * (2 * nodes_ - a - 1) / 2; }

  std::uint64_t nodes_;
  std::uint64_t row_ = 0;
};

/// Edges as a bit for every pair, or, where that is shorter, as the gaps between their numbers.
inline void put_edges(BitWriter& writer, const EdgeList& edges, std::size_t nodes) {
  const PairNumbers pairs(nodes);
  Column gaps;
  std::uint64_t next = 0;
  std::uint64_t largest = 0;
  for (const Edge& edge : edges) {
    const std::uint64_t number = pairs.number(edge);
    gaps.push_back(static_cast<std::int64_t>(number - next));
    largest = largest < number - next ? number - next : largest;
    next = number + 1;
  }
  const bool as_bits = pairs.count() <= edges.size() * (bit_width(largest) + 1);
  writer.put(as_bits ? 1 : 0, 1);
  if (!as_bits) {
    writer.put_number(gaps.size());
    put_column(writer, gaps, 1);
    return;
  }
  std::uint64_t number = 0;
  for (const std::int64_t gap : gaps) {
    for (std::int64_t i = 0; i < gap; ++i) writer.put(0, 1);
    writer.put(1, 1);
    number += static_cast<std::uint64_t>(gap) + 1;
  }
  for (; number < pairs.count(); ++number) writer.put(0, 1);
}

/// Throws FormatError.
inline EdgeList get_edges(BitReader& reader, std::size_t nodes) {
  PairNumbers pairs(nodes);
  EdgeList edges;
  if (reader.get(1) != 0) {
    if (pairs.count() > reader.bits_left()) {
      throw FormatError("the data end too early: they are cut off");
    }
    for (std::uint64_t number = 0; number < pairs.count(); ++number) {
      if (reader.get(1) != 0) edges.push_back(pairs.next(number));
    }
    return edges;
  }
  const std::size_t count = reader.get_count();
  std::uint64_t next = 0;
  for (const std::int64_t gap : get_column(reader, count, {0, std::int64_t{1} << 32}, 1)) {
    next += static_cast<std::uint64_t>(gap);
    if (next >= pairs.count())
      throw FormatError("an edge's end is not a node: the data are damaged");
    edges.push_back(pairs.next(next++));
  }
  return edges;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
