// SPDX-License-Identifier: MIT
#include "sqlite_map.hpp"

#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>

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

/// A new map until it takes its name.
struct UnfinishedFile {
  std::string path;

  ~UnfinishedFile() {
    std::error_code ignored;
    for (const char* part : {"", "-wal", "-shm", "-journal"}) fs::remove(path + part, ignored);
  }
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
  const UnfinishedFile unfinished{path + ".part-" + std::to_string(::getpid())};
  topobag::SqliteBag<>(unfinished.path, sqlite_options(false, classes)).merge(WithSessions{map});
  fs::rename(unfinished.path, path);  // closed, it is one file
}

void extend_sqlite_map(const std::string& path, const std::string& session,
                       const topobag::BagOfTopologyGraphs<>& entries,
                       const topobag::DescribedCatalog& classes) {
  const bool exists = fs::exists(path);
  const UnfinishedFile unfinished{path + ".part-" + std::to_string(::getpid())};
  {
    topobag::SqliteBag<> map(exists ? path : unfinished.path, sqlite_options(false, classes));
    map.add_session(session, entries);
  }
  if (!exists) fs::rename(unfinished.path, path);  // closed, it is one file
}

}  // namespace program
