// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/detail/map_rows.hpp>
#include <topobag/adaptors/detail/sqlite_file.hpp>
#include <topobag/adaptors/sqlite_catalog.hpp>
#include <topobag/adaptors/sqlite_options.hpp>
#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/camera_poses.hpp>
#include <topobag/bag/detail/index/free_ids.hpp>
#include <topobag/bag/detail/reads_from_memory.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/merge_options.hpp>
#include <topobag/error.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// A bag whose every change is in an SQLite file before the call returns: the map of a robot that
/// may lose power at any moment. Opened again, it is as it was; what was being written is there
/// whole or not at all.
///
///     SqliteBag<> map("flat.db");
///     const std::uint32_t today = map.begin_session("Monday");
///     map.add(id, graph, info);                  // info.session = today
///     LoopDetector loops(map);                   // or a Relocalizer: neither copies the map
///
/// It is a bag as every other is, and holds graphs as the file does, that is, after `encode` and
/// `decode`. Reading asks a bag in memory: with `SqliteBag<IndexedBag>`, one thread may add while
/// others localize. One process writes, others may read at the same time, each what there was when
/// it opened the file. Every error begins with the file's name. (Tables:
/// `examples/docs/format.md`.)
template <typename Bag_ = BagOfTopologyGraphs<>>
class SqliteBag : public detail::ReadsFromMemory<Bag_> {
  using Memory = detail::ReadsFromMemory<Bag_>;
  using Memory::bag_;
  static_assert(is_durable_bag_v<Bag_>,
                "topobag: a bag over SQLite has Graph = TopologyGraph<Scalar>, "
                "contains(KeyframeId) const, add(KeyframeId, Graph, EntryInfo), the same "
                "update, and erase(KeyframeId) -> bool.");

 public:
  using Bag = Bag_;
  using Graph = typename Bag::Graph;

  /// Opens a map, or makes one where there is none and `read_only` is not asked for.
  /// @param empty  what to fill: a bag with a similarity of yours
  /// Throws Error when the file cannot be opened, FormatError when it is damaged, no map, of a
  /// later version, or made with other classes. O(n · add).
  explicit SqliteBag(const std::string& path, SqliteOptions options = {}, Bag empty = Bag{})
      : Memory(std::move(empty)), file_(path, std::move(options)) {
    file_.for_each([this](detail::EntryRecord entry) { hold(std::move(entry)); });
  }

  /// The file's.
  const std::string& path() const noexcept { return file_.path(); }

  /// Adds a key frame. Throws InvalidId if `id` is there already, InvalidValue as `encode` and the
  /// bag do, Error when the file cannot take it; then nothing has changed. Some milliseconds.
  void add(KeyframeId id, const Graph& graph, const EntryInfo& info = {}) {
    require_new(id);
    Row row(id, graph, info, file_.options().views);
    const AppearanceKind kind = detail::kind_with(appearance_kind_, graph);
    change({id}, [&] {
      file_.insert(row.entry, row.graph);
      bag_.add(id, std::move(row.graph), as_read(row.entry.info));
    });
    appearance_kind_ = kind;
  }

  /// Adds a new run of the robot and all of its key frames: all are there afterwards, or nothing
  /// has changed. Returns the number of the run, which becomes that of its key frames.
  /// @param run  anything with `for_each(f)` that calls f(KeyframeId, const EntryInfo&, const
  ///             Graph&): a bag
  /// Throws as `begin_session` and `add`.
  template <typename Run>
  std::uint32_t add_session(const std::string& name, const Run& run) {
    Rows rows(run, appearance_kind_, file_.options().views);
    for (const Row& row : rows.all) require_new(row.entry.id);
    std::uint32_t session = 0;
    change(rows.ids(), [&] {
      session = detail::note_session(file_.connection(), name);
      for (Row& row : rows.all) row.entry.info.session = session;
      take_in(rows);
    });
    appearance_kind_ = rows.kind;
    return session;
  }

  /// Replaces a key frame's graph and info, as SLAM moves poses and fuses nodes. As `add`.
  void update(KeyframeId id, const Graph& graph, const EntryInfo& info = {}) {
    if (!bag_.contains(id)) {
      throw InvalidId(path() + ": key frame " + std::to_string(value(id)) +
                      " is not in the map: use add");
    }
    Row row(id, graph, info, file_.options().views);
    const AppearanceKind kind = detail::kind_with(appearance_kind_, graph);
    change({id}, [&] {
      file_.update(row.entry, row.graph);
      bag_.update(id, std::move(row.graph), as_read(row.entry.info));
    });
    appearance_kind_ = kind;
  }

  /// Moves key frames, as a back end does when it has closed a loop: all of them, or nothing has
  /// changed. Throws as `require_poses_of` and `add`. No graph is encoded: 500 in milliseconds.
  void set_poses(const CameraPoses& T_world_camera) {
    require_poses_of(bag_, T_world_camera, path() + ": ");
    std::vector<KeyframeId> ids;
    CameraPoses moved;
    for (const auto& [id, T] : T_world_camera) {
      ids.push_back(id);
      moved.emplace(id, as_read(T));
    }
    change(ids, [&] {
      for (const auto& [id, T] : T_world_camera) file_.move(id, T);
      bag_.set_poses(moved);
    });
  }

  /// Adds all entries of another bag, and the names of its runs where it has them: all, or nothing
  /// has changed. Ids that are free are kept; the others become the numbers after the greatest of
  /// both, in their order. Returns where each id went. Throws as `MergeOptions` and `add`.
  /// @param other  with `for_each` as this one's
  template <typename Other>
  std::map<KeyframeId, KeyframeId> merge(const Other& other, const MergeOptions& options = {}) {
    static_assert(detail::require_entries<Other, Graph>());
    options.validate();
    Rows rows(other, appearance_kind_, file_.options().views, options);
    std::set<KeyframeId> theirs;
    for (const Row& row : rows.all) theirs.insert(row.entry.id);
    const auto new_ids = detail::free_ids(theirs, file_.ids());
    for (Row& row : rows.all) row.entry.id = new_ids.at(row.entry.id);
    const auto sessions = detail::named_sessions(other, 0);
    change(rows.ids(), [&] {
      detail::note_sessions(file_.connection(), sessions, options.session_offset);
      take_in(rows);
    });
    appearance_kind_ = rows.kind;
    return new_ids;
  }

  /// Takes a key frame out; false if it was not there.
  bool erase(KeyframeId id) {
    if (!bag_.contains(id)) return false;
    change({id}, [&] {
      file_.erase(id);
      bag_.erase(id);
    });
    return true;
  }

  /// Notes a new run of the robot, numbered on from the last one, from 0. Throws InvalidValue for a
  /// name that is not UTF-8, InvalidId when the numbers are used up.
  std::uint32_t begin_session(const std::string& name) {
    std::uint32_t session = 0;
    file_.change([&] { session = detail::note_session(file_.connection(), name); });
    return session;
  }

  /// By rising id.
  std::vector<MapSession> sessions() const { return detail::noted_sessions(file_.connection()); }

 private:
  using Row = detail::MapRow<Graph>;
  using Rows = detail::MapRows<Graph>;

  /// Into the file and into memory.
  void take_in(Rows& rows) {
    for (Row& row : rows.all) {
      file_.insert(row.entry, row.graph);
      bag_.add(row.entry.id, std::move(row.graph), as_read(row.entry.info));
    }
  }

  /// A change of the file and of the bag; should either fail, neither has changed.
  /// @param ids  of the key frames that `work` changes in the bag
  template <typename Work>
  void change(const std::vector<KeyframeId>& ids, const Work& work) {
    bool begun = false;
    try {
      file_.change([&] {
        begun = true;
        work();
      });
    } catch (...) {
      if (begun) {
        for (const KeyframeId id : ids) {
          bag_.erase(id);
          file_.for_one(id, [this](detail::EntryRecord entry) { hold(std::move(entry)); });
        }
      }
      throw;
    }
  }

  /// Into memory, what the file holds.
  void hold(detail::EntryRecord entry) {
    Graph graph = decode<typename Graph::Scalar>(entry.graph);
    appearance_kind_ = detail::kind_with(appearance_kind_, graph);
    bag_.add(entry.id, std::move(graph), std::move(entry.info));
  }

  /// As its columns keep it.
  static Eigen::Isometry3d as_read(const Eigen::Isometry3d& T) {
    return detail::pose_of(detail::pose_columns(T));
  }
  static EntryInfo as_read(EntryInfo info) {
    if (info.T_world_camera) info.T_world_camera = as_read(*info.T_world_camera);
    return info;
  }

  void require_new(KeyframeId id) const {
    if (!bag_.contains(id)) return;
    throw InvalidId(path() + ": key frame " + std::to_string(value(id)) +
                    " is in the map already: use update");
  }

  detail::SqliteFile file_;
  AppearanceKind appearance_kind_;  ///< of all descriptors in the file
};

}  // namespace v0
}  // namespace topobag
