// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/bag/detail/codec/appearance_code.hpp>
#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/bag/detail/codec/depth_code.hpp>
#include <topobag/bag/detail/codec/edge_code.hpp>
#include <topobag/bag/detail/codec/graph_header.hpp>
#include <topobag/bag/detail/codec/gravity_code.hpp>
#include <topobag/bag/detail/codec/label_code.hpp>
#include <topobag/bag/detail/codec/node_columns.hpp>
#include <topobag/bag/detail/codec/view_columns.hpp>
#include <topobag/bag/savable_graph.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>

namespace topobag {
inline namespace v0 {

/// The latest version of the format; `decode` reads it and all earlier ones.
inline constexpr unsigned graph_codec_version = 2;

/// What `encode` writes the graph in: the least version that can hold it, so that nothing grows and
/// an older topobag reads what it can. 1, and 2 with gravity, appearance, label weights or views
/// that know depth.
template <typename Scalar>
unsigned codec_version_for(const TopologyGraph<Scalar>& graph,
                           ViewSection views = ViewSection::kept) noexcept {
  const bool depth = views == ViewSection::kept && detail::any_depth(graph.views());
  const bool described = graph.appearance_kind().length() > 0 || detail::any_weights(graph.nodes());
  return graph.gravity() || described || depth ? 2 : 1;
}

/// A graph in few bytes: some 180 for 12 objects, the views not counted. The same bytes on every
/// machine; for memory, file, data base and radio alike.
///
/// Kept exactly: order, classes and their weights, edges, appearance, the depth of views, what is
/// absent. Rounded, by at most: positions and depths 2 mm along each axis (3.4 mm in all), at any
/// distance; sizes 4 mm; pixels a half; confidence and existence 0.004; standard deviations 4.5 %
/// along the viewing ray and across it, which is the shape that `NodeNoise` gives a covariance and
/// to which any other is rounded off. Of views: translation 2 mm, rotation 0.2 mrad an axis (within
/// 1 mrad of half a turn 1.2 mrad in all), intrinsics 1/32 px, boxes half a pixel. Of gravity:
/// direction 0.3 mrad, deviation 4.5 %. Saturated: pixels and boxes at ±2^20 px, negative sizes at
/// 0, confidence to [0, 1], existence to [1/127, 1], standard deviations to [1 mm, 64 m], gravity's
/// to [0.24 mrad, 14.7 rad].
///
/// `encode(decode(encode(graph)))` gives the same bytes. Throws as `require_savable`. O(n² + m).
template <typename Scalar>
std::vector<std::uint8_t> encode(const TopologyGraph<Scalar>& graph,
                                 ViewSection views = ViewSection::kept) {
  require_savable(graph, views);
  const bool with_views = views == ViewSection::kept && !graph.views().empty();
  detail::BitWriter writer;
  detail::GraphHeader header;
  header.version = codec_version_for(graph, views);
  header.views = with_views;
  header.gravity = graph.gravity().has_value();
  header.appearance = graph.appearance_kind().length() > 0;
  header.depth = with_views && detail::any_depth(graph.views());
  detail::put_header(writer, header);
  detail::NodeColumns(graph.nodes()).put(writer);
  detail::put_edges(writer, graph.edges(), graph.size());
  if (with_views) detail::ViewColumns(graph.views()).put(writer);
  if (graph.gravity()) detail::put_gravity(writer, *graph.gravity());
  if (header.appearance) detail::put_appearances(writer, graph.nodes(), graph.appearance_kind());
  if (header.depth) detail::put_depths(writer, graph.views());
  detail::put_label_weights(writer, graph.nodes());
  return writer.take();
}

/// The graph of `size` bytes that `encode` wrote. Throws FormatError, and never trusts a length:
/// memory is at most some 500 bytes for each byte that is there.
template <typename Scalar = double>
TopologyGraph<Scalar> decode(const std::uint8_t* data, std::size_t size) {
  detail::BitReader reader(data, size);
  const detail::GraphHeader header = detail::get_header(reader);
  if (header.version == 0 || header.version > graph_codec_version) {
    throw FormatError("a graph of format " + std::to_string(header.version) +
                      "; this version of topobag reads up to " +
                      std::to_string(graph_codec_version) + ": update topobag, or it is no graph");
  }
  const detail::NodeColumns columns(reader, header.version);
  auto nodes = columns.nodes<Scalar>();
  EdgeList edges = detail::get_edges(reader, nodes.size());
  std::vector<View<Scalar>> views;
  if (header.views) views = detail::ViewColumns(reader).template views<Scalar>();
  std::optional<Gravity<Scalar>> gravity;
  if (header.gravity) gravity = detail::get_gravity<Scalar>(reader);
  if (header.appearance) detail::get_appearances(reader, nodes);
  if (header.depth) detail::get_depths(reader, views);
  detail::get_label_weights(reader, nodes, [&](std::size_t i) { return columns.has_weights(i); });
  reader.finish();
  return TopologyGraph<Scalar>(std::move(nodes), std::move(edges), std::move(views), gravity);
}

/// The same of all bytes.
template <typename Scalar = double>
TopologyGraph<Scalar> decode(const std::vector<std::uint8_t>& bytes) {
  return decode<Scalar>(bytes.data(), bytes.size());
}

}  // namespace v0
}  // namespace topobag
