// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include <topobag/adaptors/sqlite_options.hpp>

#include "map.hpp"

namespace python {

/// The entries of a bag at one moment, apart from it: what another bag merges without a lock on
/// both, so that two that merge each other do not wait for one another, and a bag may merge itself.
class MapEntries {
 public:
  explicit MapEntries(const Map& map) : sessions_(map.sessions()) {
    map.view()->for_each([&](KeyframeId id, const EntryInfo& info, const Graph& graph) {
      entries_.push_back({id, info, graph});
    });
  }

  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (const Entry& entry : entries_) visit(entry.id, entry.info, entry.graph);
  }
  /// The runs that the bag names.
  const std::vector<topobag::MapSession>& sessions() const noexcept { return sessions_; }

 private:
  struct Entry {
    KeyframeId id;
    EntryInfo info;
    Graph graph;
  };

  std::vector<topobag::MapSession> sessions_;
  std::vector<Entry> entries_;
};

}  // namespace python
