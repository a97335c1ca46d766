// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/detail/sqlite_catalog.hpp>
#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_row.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/adaptors/detail/sqlite_session.hpp>
#include <topobag/adaptors/detail/sqlite_statement.hpp>
#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/error.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// How a map is opened.
struct SqliteOptions {
  bool read_only = false;                 ///< to localize: the file is not touched
  ViewSection views = ViewSection::kept;  ///< whether views are written
  std::optional<ClassCatalog> catalog;    ///< has to be the one that the map was made with
};

/// One run of the robot.
struct MapSession {
  std::uint32_t id = 0;  ///< as in `EntryInfo::session`
  std::string name;      ///< the user's own
};

/// A bag whose every change is in an SQLite file before the call returns: the map of a robot that
/// may lose power at any moment. Opened again, it is as it was; what was being written is there
/// whole or not at all.
///
///     SqliteBag<> map("flat.db");
///     const std::uint32_t today = map.begin_session("Monday");
///     map.add(id, graph, info);                  // info.session = today
///     map.bag().query(graph);
///
/// The bag holds graphs as the file does, that is, after `encode` and `decode`. One process writes,
/// others may read at the same time, each what there was when it opened the file. Every error
/// begins with the file's name. (Tables: `examples/docs/format.md`.)
template <typename Bag_ = BagOfTopologyGraphs<>>
class SqliteBag {
  static_assert(is_durable_bag_v<Bag_>,
                "topobag: a bag over SQLite has Graph = TopologyGraph<Scalar>, "
                "contains(KeyframeId) const, add(KeyframeId, "
                "Graph, EntryInfo), the same update, and erase(KeyframeId) -> bool.");

 public:
  using Bag = Bag_;
  using Graph = typename Bag::Graph;

  /// Opens a map, or makes one where there is none and `read_only` is not asked for.
  /// @param empty  what to fill: a bag with a similarity of yours
  /// Throws Error when the file cannot be opened, FormatError when it is damaged, no map, of a
  /// later version, or made with other classes. O(n · add).
  explicit SqliteBag(const std::string& path, SqliteOptions options = {}, Bag empty = Bag{})
      : options_(std::move(options)),
        connection_(path, options_.read_only),
        bag_(std::move(empty)) {
    detail::prepare_schema(connection_, options_.read_only);
    if (!options_.read_only)
      connection_.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
    if (options_.catalog) {
      detail::agree_on_catalog(connection_, *options_.catalog, options_.read_only);
    }
    read_entries();
  }

  /// What to query.
  const Bag& bag() const noexcept { return bag_; }
  /// The file's.
  const std::string& path() const noexcept { return connection_.path(); }

  /// Adds a key frame. Throws InvalidId if `id` is there already, InvalidValue as `encode` and the
  /// bag do, Error when the file cannot take it; then nothing has changed. Some milliseconds.
  void add(KeyframeId id, const Graph& graph, const EntryInfo& info = {}) {
    require_new(id);
    Row row = row_of(id, graph, info);
    const AppearanceKind kind = kind_with(appearance_kind_, graph);
    change(
        [&] {
          put(detail::sqlite_insert, row);
          bag_.add(id, std::move(row.graph), as_read(row.entry.info));
        },
        {id});
    appearance_kind_ = kind;
  }

  /// Adds a new run of the robot and all of its key frames: all are there afterwards, or nothing
  /// has changed. Returns the number of the run, which becomes that of its key frames.
  /// @param run  anything with `for_each(f)` that calls f(KeyframeId, const EntryInfo&, const
  ///             Graph&): a bag
  /// Throws as `begin_session` and `add`.
  template <typename Run>
  std::uint32_t add_session(const std::string& name, const Run& run) {
    std::vector<Row> rows;
    std::vector<KeyframeId> ids;
    AppearanceKind kind = appearance_kind_;
    run.for_each([&](KeyframeId id, const EntryInfo& info, const Graph& graph) {
      require_new(id);
      kind = kind_with(kind, graph);
      rows.push_back(row_of(id, graph, info));
      ids.push_back(id);
    });
    std::uint32_t session = 0;
    change(
        [&] {
          session = detail::note_session(connection_, name);
          for (Row& row : rows) {
            row.entry.info.session = session;
            put(detail::sqlite_insert, row);
            bag_.add(row.entry.id, std::move(row.graph), as_read(row.entry.info));
          }
        },
        ids);
    appearance_kind_ = kind;
    return session;
  }

  /// Replaces a key frame's graph and info, as SLAM moves poses and fuses nodes. As `add`.
  void update(KeyframeId id, const Graph& graph, const EntryInfo& info = {}) {
    if (!bag_.contains(id)) {
      throw InvalidId(path() + ": key frame " + std::to_string(value(id)) +
                      " is not in the map: use add");
    }
    Row row = row_of(id, graph, info);
    const AppearanceKind kind = kind_with(appearance_kind_, graph);
    change(
        [&] {
          put(detail::sqlite_update, row);
          bag_.update(id, std::move(row.graph), as_read(row.entry.info));
        },
        {id});
    appearance_kind_ = kind;
  }

  /// Takes a key frame out; false if it was not there.
  bool erase(KeyframeId id) {
    if (!bag_.contains(id)) return false;
    change(
        [&] {
          detail::SqliteStatement(connection_, "DELETE FROM keyframe WHERE id = ?")
              .bind(detail::sqlite_id(id))
              .step();
          bag_.erase(id);
        },
        {id});
    return true;
  }

  /// Notes a new run of the robot, numbered on from the last one, from 0. Throws InvalidValue for a
  /// name that is not UTF-8, InvalidId when the numbers are used up.
  std::uint32_t begin_session(const std::string& name) {
    std::uint32_t session = 0;
    change([&] { session = detail::note_session(connection_, name); });
    return session;
  }

  /// By rising id.
  std::vector<MapSession> sessions() const {
    std::vector<MapSession> sessions;
    detail::SqliteStatement rows(connection_, "SELECT id, name FROM session ORDER BY id");
    while (rows.step()) {
      sessions.push_back({static_cast<std::uint32_t>(rows.integer(0)), rows.text(1)});
    }
    return sessions;
  }

 private:
  /// A transaction that is refused when the file is no longer what the bag holds.
  /// @param ids  key frames that `work` changes in the bag; should it, or the file, fail, they are
  ///             again what the file holds
  template <typename Work>
  void change(const Work& work, const std::vector<KeyframeId>& ids = {}) {
    if (options_.read_only) throw Error(path() + ": the map was opened for reading only");
    bool begun = false;
    try {
      detail::SqliteTransaction transaction(connection_);
      if (detail::sqlite_number(connection_, "PRAGMA data_version") != data_version_) {
        throw Error(path() + ": another process has changed the map; open it again");
      }
      begun = true;
      work();
      transaction.commit();
    } catch (...) {
      if (begun) restore(ids);
      throw;
    }
  }

  /// Makes key frames of the bag what the file holds.
  void restore(const std::vector<KeyframeId>& ids) {
    for (const KeyframeId id : ids) {
      bag_.erase(id);
      detail::SqliteStatement row(connection_, detail::sqlite_select_one);
      row.bind(detail::sqlite_id(id));
      read_rows(row);
    }
  }

  /// What is written of a key frame, and its graph as it will be read.
  struct Row {
    detail::EntryRecord entry;
    Graph graph;
  };

  Row row_of(KeyframeId id, const Graph& graph, const EntryInfo& info) const {
    info.validate();
    Row row{{id, info, encode(graph, options_.views)}, {}};
    row.graph = decode<typename Graph::Scalar>(row.entry.graph);
    return row;
  }

  /// Asked before a row is written: the file is not to hold what the bag refuses.
  static AppearanceKind kind_with(AppearanceKind known, const Graph& graph) {
    return common_kind(known, graph.appearance_kind(), "the key frame");
  }

  /// With the pose as its columns keep it.
  static EntryInfo as_read(EntryInfo info) {
    if (auto& T = info.T_world_camera) T = detail::pose_of(detail::pose_columns(T));
    return info;
  }

  void put(const char* sql, const Row& row) {
    detail::write_row(prepared(sql), row.entry, row.graph, options_.catalog);
  }

  void require_new(KeyframeId id) const {
    if (!bag_.contains(id)) return;
    throw InvalidId(path() + ": key frame " + std::to_string(value(id)) +
                    " is in the map already: use update");
  }

  /// The two statements that a mapping run repeats are prepared once.
  detail::SqliteStatement& prepared(const char* sql) {
    std::optional<detail::SqliteStatement>& statement =
        sql == detail::sqlite_insert ? insert_ : update_;
    if (!statement) statement.emplace(connection_, sql);
    return *statement;
  }

  void read_entries() {
    data_version_ = detail::sqlite_number(connection_, "PRAGMA data_version");
    detail::SqliteStatement rows(connection_, detail::sqlite_select);
    read_rows(rows);
  }

  void read_rows(detail::SqliteStatement& rows) {
    while (rows.step()) {
      try {
        detail::EntryRecord entry = detail::read_row(rows);
        Graph graph = decode<typename Graph::Scalar>(entry.graph);
        appearance_kind_ = kind_with(appearance_kind_, graph);
        bag_.add(entry.id, std::move(graph), std::move(entry.info));
      } catch (const Error& error) {
        throw FormatError(path() + ": key frame " +
                          std::to_string(static_cast<std::uint64_t>(rows.integer(0))) +
                          " cannot be read: " + error.what());
      }
    }
  }

  SqliteOptions options_;
  detail::SqliteConnection connection_;
  std::optional<detail::SqliteStatement> insert_, update_;
  std::int64_t data_version_ = 0;
  AppearanceKind appearance_kind_;  ///< of all descriptors in the file
  Bag bag_;
};

}  // namespace v0
}  // namespace topobag
