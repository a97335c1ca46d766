// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <topobag/bag/detail/codec/node_scan.hpp>
#include <topobag/bag/detail/index/head_block.hpp>
#include <topobag/bag/graph_codec.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The graph's bytes as an indexed bag keeps them, and `scan_margin` more.
inline std::vector<std::uint8_t> stored_bytes(const TopologyGraph<double>& graph,
                                              ViewSection views) {
  std::vector<std::uint8_t> bytes = encode(graph, views);
  bytes.insert(bytes.end(), scan_margin, 0);
  return bytes;
}

/// An entry as an indexed bag keeps it. Throws as `EntryInfo::validate` and `encode`.
template <typename Similarity>
HeadBlock::Entry encoded_entry(KeyframeId id, const TopologyGraph<double>& graph, EntryInfo info,
                               ViewSection views, const Similarity& similarity, NodeScan& scan) {
  info.validate();
  HeadBlock::Entry entry{id, std::move(info), stored_bytes(graph, views), 0.0F};
  double total = 0.0;
  similarity.for_each_vote(scan(entry.graph.data()),
                           [&](std::uint64_t, double weight) { total += weight; });
  entry.total = static_cast<float>(total);
  return entry;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
