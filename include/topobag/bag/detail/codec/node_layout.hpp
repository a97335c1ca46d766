// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <topobag/bag/detail/codec/packed_column.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

// The units of the format: a change of one of them is a new version of it.
inline constexpr double steps_per_metre = 256.0;
inline constexpr double steps_per_size_metre = 128.0;
inline constexpr double steps_per_pixel = 1.0;
inline constexpr double steps_of_share = 127.0;  // of a share in [0, 1]
inline constexpr double steps_per_octave = 8.0;  // of a standard deviation, from 1 m
inline constexpr double max_metres = 1048576.0;
inline constexpr std::size_t max_nodes = 4096;  // a histogram's words are n²: some 10^7

inline constexpr ColumnRange metre_range{-(std::int64_t{1} << 28), std::int64_t{1} << 28};
inline constexpr ColumnRange size_range{0, std::int64_t{1} << 27};
inline constexpr ColumnRange pixel_range{-(std::int64_t{1} << 20), std::int64_t{1} << 20};
inline constexpr ColumnRange share_range{0, 127};
inline constexpr ColumnRange existence_range{1, 127};
inline constexpr ColumnRange deviation_range{-80, 48};  // 1 mm to 64 m
inline constexpr std::int64_t max_elongation = 48;      // a factor of 64 between the axes
inline constexpr ColumnRange label_range{std::numeric_limits<std::int32_t>::min(),
                                         std::numeric_limits<std::int32_t>::max()};

// What a node may lack.
inline constexpr std::int64_t has_pixel = 1;
inline constexpr std::int64_t has_position = 2;
inline constexpr std::int64_t has_depth = 4;  ///< other than the position's
inline constexpr std::int64_t has_covariance = 8;
inline constexpr std::int64_t has_label_weights = 16;  ///< from version 2 on
inline constexpr std::int64_t all_parts =
    has_pixel | has_position | has_depth | has_covariance | has_label_weights;

/// One number of a node, in the order in which their columns are written.
enum class NodeProperty {
  confidence,
  label,
  existence,
  parts,  ///< which of the above it has
  width,
  height,
  u,
  v,
  x,
  y,
  z,
  depth,
  along,  ///< the viewing ray: the standard deviation
  across
};

/// A column of an encoded graph's nodes.
struct NodeColumn {
  NodeProperty property;
  std::int64_t part;  ///< it holds the nodes that have this, or all where it is 0
  ColumnRange range;
  unsigned min_width = 0;  ///< bits a value takes at least
};

/// All of them, as they are written: whoever writes, reads or scans them goes by this.
inline constexpr std::array<NodeColumn, 14> node_columns{{
    {NodeProperty::confidence, 0, share_range, vouching_width},
    {NodeProperty::label, 0, label_range},
    {NodeProperty::existence, 0, existence_range},
    {NodeProperty::parts, 0, {0, all_parts}},
    {NodeProperty::width, 0, size_range},
    {NodeProperty::height, 0, size_range},
    {NodeProperty::u, has_pixel, pixel_range},
    {NodeProperty::v, has_pixel, pixel_range},
    {NodeProperty::x, has_position, metre_range},
    {NodeProperty::y, has_position, metre_range},
    {NodeProperty::z, has_position, metre_range},
    {NodeProperty::depth, has_depth, metre_range},
    {NodeProperty::along, has_covariance, deviation_range},
    {NodeProperty::across, has_covariance, deviation_range},
}};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
