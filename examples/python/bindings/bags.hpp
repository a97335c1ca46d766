// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/bag/memory_usage.hpp>
#include <topobag/bag/snapshot_file.hpp>

#include "locked_map.hpp"
#include "map_entries.hpp"

namespace python {

/// Saves the bag behind a view.
inline void save_view(const MapView& view, const std::string& path, const Classes& classes) {
  topobag::SaveOptions options;
  options.catalog = classes;
  topobag::save(view, path, options);
}

/// `BagOfTopologyGraphs` by some similarity.
class MemoryMap : public Map {};

/// The same, of which the similarity is known.
template <typename S>
class MemoryMapBy : public MemoryMap {
 public:
  using Bag = topobag::BagOfTopologyGraphs<Graph, S>;

  explicit MemoryMapBy(Bag bag) : bag_(std::move(bag)) {}

  std::shared_ptr<const MapView> view() const override {
    return std::make_shared<LockedView<Bag>>(bag_, mutex_);
  }
  void add(KeyframeId id, const Graph& graph, const EntryInfo& info) override {
    const WriteLock lock(mutex_);
    bag_.add(id, graph, info);
  }
  void update(KeyframeId id, const Graph& graph, const EntryInfo& info) override {
    const WriteLock lock(mutex_);
    bag_.update(id, graph, info);
  }
  bool erase(KeyframeId id) override {
    const WriteLock lock(mutex_);
    return bag_.erase(id);
  }
  void set_poses(const topobag::CameraPoses& T_world_camera) override {
    const WriteLock lock(mutex_);
    bag_.set_poses(T_world_camera);
  }
  NewIds merge(const Map& other, const topobag::MergeOptions& options) override {
    const MapEntries theirs(other);
    const WriteLock lock(mutex_);
    return bag_.merge(theirs, options);
  }
  void save(const std::string& path, const Classes& classes) const override {
    save_view(*view(), path, classes);
  }

 private:
  Bag bag_;
  mutable std::shared_mutex mutex_;
};

/// `IndexedBag`, whose readers never wait.
class IndexedMap : public Map {
 public:
  explicit IndexedMap(topobag::IndexedBag bag = topobag::IndexedBag{}) : bag_(std::move(bag)) {}

  std::shared_ptr<const MapView> view() const override;
  void add(KeyframeId id, const Graph& graph, const EntryInfo& info) override;
  void update(KeyframeId id, const Graph& graph, const EntryInfo& info) override;
  bool erase(KeyframeId id) override;
  void set_poses(const topobag::CameraPoses& T_world_camera) override;
  NewIds merge(const Map& other, const topobag::MergeOptions& options) override;
  void save(const std::string& path, const Classes& classes) const override;

  /// As the bag's own.
  void compact();
  topobag::MemoryUsage memory_usage() const { return bag_.memory_usage(); }
  topobag::SearchResult search(const Graph& graph, const topobag::QueryOptions& options,
                               std::size_t max_visited) const {
    return bag_.view()->search(graph, options, max_visited);
  }

 private:
  topobag::IndexedBag bag_;
  std::mutex writing_;
};

/// `SqliteBag`.
class SqliteMap : public Map {
 public:
  SqliteMap(const std::string& path, topobag::SqliteOptions options)
      : bag_(path, std::move(options)) {}

  std::shared_ptr<const MapView> view() const override;
  void add(KeyframeId id, const Graph& graph, const EntryInfo& info) override;
  void update(KeyframeId id, const Graph& graph, const EntryInfo& info) override;
  bool erase(KeyframeId id) override;
  void set_poses(const topobag::CameraPoses& T_world_camera) override;
  NewIds merge(const Map& other, const topobag::MergeOptions& options) override;
  std::vector<topobag::MapSession> sessions() const override;
  void save(const std::string& path, const Classes& classes) const override;

  /// As the bag's own.
  std::uint32_t begin_session(const std::string& name);
  const std::string& path() const noexcept { return bag_.path(); }

 private:
  topobag::SqliteBag<> bag_;
  mutable std::shared_mutex mutex_;
};

}  // namespace python
