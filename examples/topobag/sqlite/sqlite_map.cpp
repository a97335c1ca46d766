// SPDX-License-Identifier: MIT
#include "sqlite_map.hpp"

#include <topobag/adaptors/sqlite.hpp>

namespace program {
namespace {

topobag::SqliteOptions sqlite_options(bool read_only) {
  topobag::SqliteOptions options;
  options.read_only = read_only;
  options.catalog = topobag::ClassCatalog::coco80();
  return options;
}

}  // namespace

SavedMap read_sqlite_map(const std::string& path) {
  const topobag::SqliteBag<> map(path, sqlite_options(true));
  SavedMap saved{
      "SQLite map, schema " + std::to_string(topobag::sqlite_schema_version), {}, map.bag()};
  for (const topobag::MapSession& session : map.sessions()) {
    saved.sessions.push_back({session.id, session.name});
  }
  return saved;
}

void extend_sqlite_map(const std::string& path, const std::string& session,
                       const std::vector<Keyframe>& keyframes) {
  topobag::SqliteBag<> map(path, sqlite_options(false));
  const std::uint32_t number = map.begin_session(session);
  for (const MapEntry& entry : new_entries(map.bag(), number, keyframes)) {
    map.add(entry.id, *entry.graph, entry.info);
  }
}

}  // namespace program
