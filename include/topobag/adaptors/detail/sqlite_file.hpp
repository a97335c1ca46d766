// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include <topobag/adaptors/detail/sqlite_catalog.hpp>
#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_images.hpp>
#include <topobag/adaptors/detail/sqlite_row.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/adaptors/detail/sqlite_session.hpp>
#include <topobag/adaptors/detail/sqlite_statement.hpp>
#include <topobag/adaptors/sqlite_options.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A map in an SQLite file: its rows are written within `change` and read one by one.
class SqliteFile {
 public:
  /// Throws as `SqliteBag`.
  SqliteFile(const std::string& path, SqliteOptions options)
      : options_(std::move(options)),
        goes_on_(is_write_ahead_log(real_path(path) + "-wal")),
        connection_(path, options_.read_only) {
    prepare_schema(connection_, options_.read_only);
    if (!options_.read_only) {
      note_opening();
      connection_.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
    }
    if (options_.catalog) agree_on_catalog(connection_, *options_.catalog, options_.read_only);
    data_version_ = sqlite_number(connection_, "PRAGMA data_version");
  }

  const std::string& path() const noexcept { return connection_.path(); }
  const SqliteOptions& options() const noexcept { return options_; }
  SqliteConnection& connection() noexcept { return connection_; }
  const SqliteConnection& connection() const noexcept { return connection_; }

  /// A transaction that is refused when the file is no longer what was read of it.
  template <typename Work>
  void change(const Work& work) {
    if (options_.read_only) throw Error(path() + ": the map was opened for reading only");
    SqliteTransaction transaction(connection_);
    if (sqlite_number(connection_, "PRAGMA data_version") != data_version_) {
      throw Error(path() + ": another process has changed the map; open it again");
    }
    work();
    if (!noted_) connection_.run(unclosed_1);
    transaction.commit();
    // The change is made, whatever becomes of the note.
    noted_ = noted_ ||
             (connection_.checkpoint() &&
              sqlite3_exec(connection_.get(), unclosed_2, nullptr, nullptr, nullptr) == SQLITE_OK);
  }

  /// @param graph  that of the entry, decoded
  template <typename Graph>
  void insert(const EntryRecord& entry, const Graph& graph) {
    write_row(prepared(insert_, sqlite_insert), entry, graph, options_.catalog);
    write_image(connection_, entry.id, entry.info.image);
  }
  /// The same.
  template <typename Graph>
  void update(const EntryRecord& entry, const Graph& graph) {
    write_row(prepared(update_, sqlite_update), entry, graph, options_.catalog);
    write_image(connection_, entry.id, entry.info.image);
  }
  void move(KeyframeId id, const Eigen::Isometry3d& T_world_camera) {
    const auto pose = pose_columns(T_world_camera);
    prepared(move_, sqlite_move)
        .bind(pose[0], pose[1], pose[2], pose[3], pose[4], pose[5], pose[6], sqlite_id(id))
        .step();
  }
  void erase(KeyframeId id) {
    SqliteStatement(connection_, "DELETE FROM keyframe WHERE id = ?").bind(sqlite_id(id)).step();
  }

  /// Calls f(EntryRecord) for every key frame. Throws FormatError when one cannot be read.
  template <typename F>
  void for_each(const F& f) const {
    SqliteStatement rows(connection_, sqlite_select);
    read(rows, f);
  }
  /// The same for the key frame `id`, if it is there.
  template <typename F>
  void for_one(KeyframeId id, const F& f) const {
    SqliteStatement row(connection_, sqlite_select_one);
    read(row.bind(sqlite_id(id)), f);
  }

  std::set<KeyframeId> ids() const {
    std::set<KeyframeId> ids;
    SqliteStatement rows(connection_, "SELECT id FROM keyframe");
    while (rows.step()) ids.insert(KeyframeId{static_cast<std::uint64_t>(rows.integer(0))});
    return ids;
  }

 private:
  /// So that a journal that was lost is told from one that nothing was written to: 'unclosed' is 0
  /// from the opening on; 1 in the first change, which goes to the file itself at once; and 2 in
  /// the journal from then on, and in the file when more of the journal has come there.
  void note_opening() {
    const std::int64_t value = sqlite_number(
        connection_, "SELECT coalesce((SELECT value FROM meta WHERE key = 'unclosed'), -1)");
    noted_ = goes_on_ && value == 2;
    if (value == 0 || (goes_on_ && value > 0)) return;
    connection_.run("INSERT OR REPLACE INTO meta(key, value) VALUES('unclosed', 0)");
  }

  template <typename F>
  void read(SqliteStatement& rows, const F& f) const {
    const SqliteImages images(connection_);
    while (rows.step()) {
      try {
        EntryRecord entry = read_row(rows);
        entry.info.image = images.of(entry.id);
        f(std::move(entry));
      } catch (const Error& error) {
        throw FormatError(path() + ": key frame " +
                          std::to_string(static_cast<std::uint64_t>(rows.integer(0))) +
                          " cannot be read: " + error.what());
      }
    }
  }

  /// What a mapping run repeats is prepared once.
  SqliteStatement& prepared(std::optional<SqliteStatement>& statement, const char* sql) {
    if (!statement) statement.emplace(connection_, sql);
    return *statement;
  }

  static constexpr const char* unclosed_1 = "UPDATE meta SET value = 1 WHERE key = 'unclosed'";
  static constexpr const char* unclosed_2 = "UPDATE meta SET value = 2 WHERE key = 'unclosed'";

  SqliteOptions options_;
  bool goes_on_;  ///< with a journal that was left beside the file
  SqliteConnection connection_;
  std::optional<SqliteStatement> insert_, update_, move_;
  std::int64_t data_version_ = 0;
  bool noted_ = false;  ///< that there were changes
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
