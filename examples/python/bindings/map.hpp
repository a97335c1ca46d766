// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/sqlite_options.hpp>
#include <topobag/bag/camera_poses.hpp>
#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/merge_options.hpp>
#include <topobag/bag/place_contents.hpp>
#include <topobag/bag/query.hpp>
#include <topobag/graph/topology_graph.hpp>

namespace python {

using topobag::EntryInfo;
using topobag::KeyframeId;
using Classes = std::optional<topobag::DescribedCatalog>;
using Graph = topobag::TopologyGraph<>;
using NewIds = std::map<KeyframeId, KeyframeId>;  ///< where each key frame went

/// A bag as it stands, whichever it is: one way to query is compiled for all of them. Whoever holds
/// one keeps writers waiting, or reads a bag that does not change.
class MapView {
 public:
  using Graph = python::Graph;
  using Visit = std::function<void(KeyframeId, const EntryInfo&, const Graph&)>;

  virtual ~MapView() = default;
  virtual std::vector<topobag::Candidate> query(const Graph& graph,
                                                const topobag::QueryOptions& options) const = 0;
  virtual std::shared_ptr<const Graph> peek(KeyframeId id) const = 0;
  virtual std::optional<EntryInfo> info(KeyframeId id) const = 0;
  virtual std::optional<KeyframeId> after(KeyframeId id) const = 0;
  virtual std::optional<KeyframeId> before(KeyframeId id) const = 0;
  virtual topobag::AppearanceKind appearance_kind() const = 0;
  virtual topobag::ImageKind image_kind() const = 0;
  virtual std::vector<KeyframeId> within(const topobag::MapRegion& region) const = 0;
  virtual std::size_t size() const = 0;
  virtual std::size_t places() const = 0;
  virtual std::size_t places_holding(const topobag::ClassCounts& objects,
                                     const topobag::ClassGroups& groups) const = 0;
  virtual void for_each(const Visit& visit) const = 0;

  std::optional<Graph> find(KeyframeId id) const {
    const auto graph = peek(id);
    return graph ? std::make_optional(*graph) : std::nullopt;
  }
};

/// Of all its key frames, ascending.
inline std::vector<KeyframeId> ids_of(const MapView& view) {
  std::vector<KeyframeId> ids;
  view.for_each([&](KeyframeId id, const EntryInfo&, const Graph&) { ids.push_back(id); });
  return ids;
}

/// A bag that Python holds, for any number of threads.
class Map {
 public:
  virtual ~Map() = default;
  virtual std::shared_ptr<const MapView> view() const = 0;
  virtual void add(KeyframeId id, const Graph& graph, const EntryInfo& info) = 0;
  virtual void update(KeyframeId id, const Graph& graph, const EntryInfo& info) = 0;
  virtual bool erase(KeyframeId id) = 0;
  virtual void set_poses(const topobag::CameraPoses& T_world_camera) = 0;
  virtual NewIds merge(const Map& other, const topobag::MergeOptions& options) = 0;
  /// The runs that it names.
  virtual std::vector<topobag::MapSession> sessions() const { return {}; }
  /// With the classes that the file keeps, or none.
  virtual void save(const std::string& path, const Classes& classes) const = 0;
};

/// A bag in the library's sense that refers to Python's: a recogniser's own changes with it.
class SharedMap {
 public:
  using Graph = python::Graph;

  explicit SharedMap(std::shared_ptr<Map> map) : map_(std::move(map)) {}

  const std::shared_ptr<Map>& map() const noexcept { return map_; }
  std::shared_ptr<const MapView> view() const { return map_->view(); }
  std::vector<topobag::Candidate> query(const Graph& graph,
                                        const topobag::QueryOptions& options = {}) const {
    return view()->query(graph, options);
  }
  std::optional<Graph> find(KeyframeId id) const { return view()->find(id); }
  std::optional<EntryInfo> info(KeyframeId id) const { return view()->info(id); }
  topobag::AppearanceKind appearance_kind() const { return view()->appearance_kind(); }
  void add(KeyframeId id, const Graph& graph, const EntryInfo& info) { map_->add(id, graph, info); }

 private:
  std::shared_ptr<Map> map_;
};

}  // namespace python
