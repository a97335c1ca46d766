// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <topobag/bag/detail/codec/graph_header.hpp>
#include <topobag/bag/detail/codec/node_layout.hpp>
#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Bytes that may be read beyond the end of a graph's, whatever they hold.
inline constexpr std::size_t scan_margin = 8;

/// Reads what a `BitWriter` packed, at most 57 bits at a time, and checks nothing: for bytes that
/// this process has encoded or decoded before.
class TrustedBits {
 public:
  explicit TrustedBits(const std::uint8_t* data) noexcept : data_(data) {}

  void skip(std::size_t bits) noexcept { at_ += bits; }
  std::uint64_t get(unsigned width) noexcept {
    const std::uint8_t* p = data_ + (at_ >> 3U);
    // Spelt out, as compilers then read the eight at once.
    const auto byte = [p](unsigned i) { return static_cast<std::uint64_t>(p[i]) << (8 * i); };
    std::uint64_t window =
        byte(0) | byte(1) | byte(2) | byte(3) | byte(4) | byte(5) | byte(6) | byte(7);
    window >>= at_ & 7U;
    at_ += width;
    return window & ((std::uint64_t{1} << width) - 1);
  }
  std::uint64_t get_number() noexcept {
    for (std::uint64_t number = 0, shift = 0;; shift += 4) {
      const std::uint64_t group = get(5);
      number |= (group & 15U) << shift;
      if (group < 16) return number;
    }
  }
  std::int64_t get_signed() noexcept {
    const std::uint64_t folded = get_number();
    const auto magnitude = static_cast<std::int64_t>(folded >> 1U);
    return (folded & 1U) != 0 ? -1 - magnitude : magnitude;
  }

 private:
  const std::uint8_t* data_;
  std::size_t at_ = 0;  ///< bit
};

/// How many nodes an encoded graph has. @param bytes  as those of `NodeScan`. O(1).
inline std::size_t node_count(const std::uint8_t* bytes) noexcept {
  TrustedBits bits(bytes);
  get_header(bits);
  return static_cast<std::size_t>(bits.get_number());
}

/// What the retrieval needs of a node.
struct ScannedNode {
  ClassId label{};
  Eigen::Vector2d size;                     ///< m
  std::optional<Eigen::Vector3d> position;  ///< m
};

/// Reads the nodes of an encoded graph as far as the retrieval needs them, some ten times faster
/// than `decode` and to the same numbers.
class NodeScan {
 public:
  /// @param bytes  from `encode`, with `scan_margin` bytes behind them; they are trusted
  /// Valid until the next call.
  const std::vector<ScannedNode>& operator()(const std::uint8_t* bytes) {
    TrustedBits bits(bytes);
    get_header(bits);
    const auto n = static_cast<std::size_t>(bits.get_number());
    nodes_.resize(n);
    placed_.clear();
    std::size_t pixels = 0;
    for (const NodeColumn& column : node_columns) {
      const std::size_t count = column.part == 0           ? n
                                : column.part == has_pixel ? pixels
                                                           : placed_.size();
      switch (column.property) {
        case NodeProperty::label:
          read_column(bits, count, [&](std::size_t i, std::int64_t label) {
            nodes_[i].label = static_cast<ClassId>(label);
          });
          break;
        case NodeProperty::parts:
          read_column(bits, count, [&](std::size_t i, std::int64_t parts) {
            pixels += (parts & has_pixel) != 0 ? 1U : 0U;
            nodes_[i].position.reset();
            if ((parts & has_position) == 0) return;
            nodes_[i].position.emplace();
            placed_.push_back(i);
          });
          break;
        case NodeProperty::width:
        case NodeProperty::height:
          read_column(bits, count, [&](std::size_t i, std::int64_t steps) {
            nodes_[i].size[column.property == NodeProperty::height] =
                static_cast<double>(steps) / steps_per_size_metre;
          });
          break;
        case NodeProperty::x:
        case NodeProperty::y:
        case NodeProperty::z: {
          const int axis = static_cast<int>(column.property) - static_cast<int>(NodeProperty::x);
          read_column(bits, count, [&](std::size_t i, std::int64_t steps) {
            (*nodes_[placed_[i]].position)[axis] = static_cast<double>(steps) / steps_per_metre;
          });
          break;
        }
        case NodeProperty::depth:
          return nodes_;  // nothing beyond is needed
        default:
          skip_column(bits, count);
      }
    }
    return nodes_;
  }

 private:
  static void skip_column(TrustedBits& bits, std::size_t count) {
    if (count == 0) return;
    const std::uint64_t width = bits.get(6);
    bits.get_signed();
    bits.skip(count * static_cast<std::size_t>(width));
  }

  template <typename Visit>
  static void read_column(TrustedBits& bits, std::size_t count, const Visit& visit) {
    if (count == 0) return;
    const auto width = static_cast<unsigned>(bits.get(6));
    const std::int64_t low = bits.get_signed();
    for (std::size_t i = 0; i < count; ++i) {
      visit(i, low + static_cast<std::int64_t>(bits.get(width)));
    }
  }

  std::vector<ScannedNode> nodes_;
  std::vector<std::size_t> placed_;  ///< the nodes that have a position
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
