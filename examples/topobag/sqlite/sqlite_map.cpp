// SPDX-License-Identifier: MIT
#include "sqlite_map.hpp"

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>

#include "input_error.hpp"
#include "map_journal.hpp"

namespace program {
namespace {

namespace fs = std::filesystem;

topobag::SqliteOptions sqlite_options(bool read_only, const topobag::DescribedCatalog& classes) {
  topobag::SqliteOptions options;
  options.read_only = read_only;
  options.catalog = classes;
  return options;
}

/// A map in memory as SqliteBag takes in a bag with names of sessions.
struct WithSessions {
  const SavedMap& map;

  template <typename F>
  void for_each(const F& f) const {
    map.bag.for_each(f);
  }
  std::vector<topobag::MapSession> sessions() const {
    std::vector<topobag::MapSession> sessions;
    for (const SavedSession& session : map.sessions) sessions.push_back({session.id, session.name});
    return sessions;
  }
};

/// A new map until it takes its name. A link is followed: the file behind it is made.
class UnfinishedMap {
 public:
  explicit UnfinishedMap(const std::string& name)
      : name_(name),
        file_(file_behind(name)),
        part_(file_ + ".part-" + std::to_string(::getpid())) {
    require_no_journal(name_);
  }
  UnfinishedMap(const UnfinishedMap&) = delete;
  UnfinishedMap& operator=(const UnfinishedMap&) = delete;
  ~UnfinishedMap() {
    std::error_code ignored;
    for (const char* ending : {"", "-wal", "-shm", "-journal"}) fs::remove(part_ + ending, ignored);
  }

  /// Calls `fill(map)`; then the map has its name. What fails is told of this name.
  template <typename Fill>
  void finish(const topobag::DescribedCatalog& classes, const Fill& fill) {
    try {
      topobag::SqliteBag<> map(part_, sqlite_options(false, classes));
      fill(map);
    } catch (const topobag::Error& error) {
      std::string text = error.what();
      if (text.compare(0, part_.size(), part_) == 0) text = name_ + text.substr(part_.size());
      throw topobag::Error(text);
    }
    std::error_code failed;
    fs::rename(part_, file_, failed);  // closed, it is one file
    if (failed) throw InputError(name_, "it cannot be written: " + failed.message());
  }

 private:
  std::string name_, file_, part_;
};

}  // namespace

std::optional<topobag::DescribedCatalog> sqlite_map_classes(const std::string& path) {
  return topobag::sqlite_catalog(path);
}

SavedMap read_sqlite_map(const std::string& path, const topobag::DescribedCatalog& classes) {
  const topobag::SqliteBag<> map(path, sqlite_options(true, classes));
  SavedMap saved{
      "SQLite map, schema " + std::to_string(topobag::sqlite_schema_version), {}, map.bag()};
  for (const topobag::MapSession& session : map.sessions()) {
    saved.sessions.push_back({session.id, session.name});
  }
  return saved;
}

void write_sqlite_map(const std::string& path, const SavedMap& map,
                      const topobag::DescribedCatalog& classes) {
  UnfinishedMap(path).finish(classes,
                             [&](topobag::SqliteBag<>& made) { made.merge(WithSessions{map}); });
}

void extend_sqlite_map(const std::string& path, const std::string& session,
                       const topobag::BagOfTopologyGraphs<>& entries,
                       const topobag::DescribedCatalog& classes) {
  const auto add = [&](topobag::SqliteBag<>& map) { map.add_session(session, entries); };
  if (!fs::exists(path)) {
    UnfinishedMap(path).finish(classes, add);
  } else {
    topobag::SqliteBag<> map(path, sqlite_options(false, classes));
    add(map);
  }
}

}  // namespace program
