// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/bag/detail/storage/descriptor_kinds.hpp>
#include <topobag/bag/detail/storage/entry_record.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/merge_options.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// What is written of a key frame, and its graph as it will be read.
template <typename Graph>
struct MapRow {
  /// Throws as `EntryInfo::validate` and `encode`.
  MapRow(KeyframeId id, const Graph& written, const EntryInfo& info, ViewSection views) {
    info.validate();
    entry = {id, info, encode(written, views)};
    graph = decode<typename Graph::Scalar>(entry.graph);
  }

  EntryRecord entry;
  Graph graph;
};

/// Those of many key frames, with the kind of descriptors that the map then has.
template <typename Graph>
struct MapRows {
  /// Throws as `MapRow`, and InvalidValue for descriptors of another kind than the map's.
  /// @param other  with `for_each` as a bag's
  /// @param known  kind of the map's descriptors
  template <typename Other>
  MapRows(const Other& other, const AppearanceKind& known, ViewSection views,
          const MergeOptions& options = {})
      : kind(known) {
    other.for_each([&](KeyframeId id, const EntryInfo& info, const Graph& graph) {
      kind = kind_with(kind, graph);
      all.emplace_back(id, *options.in_this_unit(graph), options.moved(info), views);
    });
  }

  std::vector<KeyframeId> ids() const {
    std::vector<KeyframeId> ids;
    for (const MapRow<Graph>& row : all) ids.push_back(row.entry.id);
    return ids;
  }

  std::vector<MapRow<Graph>> all;
  AppearanceKind kind;
};

}  // namespace detail

}  // namespace v0
}  // namespace topobag
