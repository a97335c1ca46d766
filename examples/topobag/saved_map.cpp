// SPDX-License-Identifier: MIT
#include "saved_map.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <topobag/bag/session_number.hpp>
#include <topobag/bag/snapshot_file.hpp>
#include <topobag/bag/writer_lock.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

#include "fleet_address.hpp"
#include "fleet_map.hpp"
#include "input_error.hpp"
#include "map_journal.hpp"
#include "map_kind.hpp"
#include "path_kind.hpp"
#include "same_images.hpp"
#include "sqlite_map.hpp"

namespace program {
namespace {

namespace fs = std::filesystem;
using Bag = topobag::BagOfTopologyGraphs<>;

/// The numbers of the runs in a bag, ascending.
std::set<std::uint32_t> sessions_in(const Bag& bag) {
  std::set<std::uint32_t> sessions;
  bag.for_each([&](topobag::KeyframeId, const topobag::EntryInfo& info, const auto&) {
    sessions.insert(info.session);
  });
  return sessions;
}

SavedMap read_snapshot(const std::string& path, const topobag::DescribedCatalog& classes) {
  const topobag::SnapshotHeader header = topobag::inspect(path);
  SavedMap saved{"snapshot, format " + std::to_string(header.format_version),
                 {},
                 topobag::load<Bag>(path, classes)};
  for (const std::uint32_t session : sessions_in(saved.bag))
    saved.sessions.push_back({session, ""});
  return saved;
}

/// @param keeps_classes  else their fingerprint alone
void write_snapshot(const std::string& path, const Bag& bag, const ObjectClasses& classes,
                    bool keeps_classes) {
  topobag::SaveOptions options;
  options.catalog_fingerprint = topobag::fingerprint(classes.catalog);
  if (keeps_classes) options.catalog = described(classes);
  topobag::save(bag, path, options);
}

void extend_snapshot(const std::string& path, Bag bag, const Bag& entries,
                     const ObjectClasses& classes) {
  const std::set<std::uint32_t> sessions = sessions_in(bag);
  const std::uint32_t session = topobag::next_session(
      sessions.empty() ? std::nullopt : std::optional<std::uint32_t>(*sessions.rbegin()));
  entries.for_each([&](topobag::KeyframeId id, topobag::EntryInfo info, const auto& graph) {
    info.session = session;
    bag.add(id, graph, std::move(info));
  });
  // What an earlier map does not say of its key frames' classes, nobody says later.
  const bool exists = fs::exists(path);
  write_snapshot(path, bag, classes,
                 exists ? topobag::saved_catalog(path).has_value() : !classes.file.empty());
}

}  // namespace

std::size_t require_new(const std::string& path, const Bag& bag, const Bag& entries) {
  std::multimap<double, topobag::KeyframeId> by_stamp;
  bag.for_each([&](topobag::KeyframeId id, const topobag::EntryInfo& info, const auto&) {
    if (info.stamp) by_stamp.emplace(*info.stamp, id);
  });
  std::set<std::uint32_t> sessions;
  std::size_t known = 0;
  entries.for_each([&](topobag::KeyframeId, const topobag::EntryInfo& info, const auto& graph) {
    const auto same_time = by_stamp.equal_range(info.stamp.value_or(0.0));
    const auto same = std::find_if(same_time.first, same_time.second, [&](const auto& other) {
      return are_of_same_images(*bag.find(other.second), bag.info(other.second)->T_world_camera,
                                graph, info.T_world_camera);
    });
    if (same == same_time.second) return;
    ++known;
    sessions.insert(bag.info(same->second)->session);
  });
  if (known == 0 || known < entries.size()) return known;
  throw InputError(path, "the map holds these key frames already, as session " +
                             std::to_string(*sessions.begin()) +
                             ": mapped twice, a place is found by itself");
}

namespace {

/// Which kind of map a new file is.
bool is_sqlite_name(const std::string& path) { return fs::path(path).extension() == ".db"; }

/// Of the file that is there, else of the one that its name asks for.
bool is_sqlite_map(const std::string& path) {
  return fs::exists(path) ? kind_of(path) == MapKind::sqlite : is_sqlite_name(path);
}

}  // namespace

bool keeps_session_names(const std::string& path) {
  return is_fleet_address(path) || is_sqlite_map(path);
}

Bag new_entries(const Bag& bag, const std::vector<Keyframe>& keyframes) {
  std::uint64_t first = 0;
  bag.for_each(
      [&](topobag::KeyframeId id, const auto&, const auto&) { first = topobag::value(id) + 1; });
  Bag entries;
  for (const Keyframe& keyframe : keyframes) {
    if (keyframe.idx < 0) {
      throw InputError("frame idx " + std::to_string(keyframe.idx) +
                       " is negative, which no key frame of a map can be");
    }
    topobag::EntryInfo info;
    info.stamp = keyframe.timestamp;
    info.T_world_camera = keyframe.T_world_camera;
    entries.add(topobag::KeyframeId{first + static_cast<std::uint64_t>(keyframe.idx)},
                keyframe.graph, std::move(info));
  }
  return entries;
}

bool is_saved_map(const std::string& path) {
  if (is_fleet_address(path)) return true;
  std::error_code unreadable;
  const bool is_file =
      fs::is_regular_file(path, unreadable) || (unreadable && unreadable.value() != ENOENT);
  return set_name(path) == path && is_file && !is_object_map(path);
}

void require_sqlite_map(const std::string& path) {
  if (kind_of(path) == MapKind::sqlite) return;
  throw InputError(path,
                   "it is a snapshot, which no robot goes on with; `topobag map --out FILE.db` "
                   "makes an SQLite map");
}

ObjectClasses classes_of_maps(const std::vector<std::string>& paths, const ObjectClasses& given) {
  if (!may_adopt(given)) return given;
  for (const std::string& path : paths) {
    if (!is_saved_map(path)) continue;
    const auto kept = is_fleet_address(path)             ? fleet_map_classes(path)
                      : kind_of(path) == MapKind::sqlite ? sqlite_map_classes(path)
                                                         : topobag::saved_catalog(path);
    if (kept) return adopted(given, *kept, path);
  }
  return given;
}

SavedMap read_saved_map(const std::string& path, const ObjectClasses& classes) {
  if (is_fleet_address(path)) return read_fleet_map(path, classes);
  return kind_of(path) == MapKind::sqlite ? read_sqlite_map(path, described(classes))
                                          : read_snapshot(path, described(classes));
}

std::size_t write_saved_map(const std::string& path, const std::string& session,
                            const std::vector<Keyframe>& keyframes, const ObjectClasses& classes,
                            bool append) {
  if (is_fleet_address(path)) {
    const Bag entries = new_entries(Bag(), keyframes);
    const std::size_t known = require_new(path, read_fleet_map(path, classes).bag, entries);
    extend_fleet_map(path, session, entries, classes);
    return known;
  }
  if (fs::is_directory(path)) throw InputError(path, "it is a folder; name a file in it");
  const topobag::WriterLock lock(path);
  const bool exists = fs::exists(path);
  if (exists && !append) {
    throw InputError(path, "it exists; give --append to go on mapping, or another name");
  }
  Bag bag = exists ? read_saved_map(path, classes).bag : Bag();
  const Bag entries = new_entries(bag, keyframes);
  const std::size_t known = require_new(path, bag, entries);
  if (is_sqlite_map(path)) {
    extend_sqlite_map(path, session, entries, described(classes));
  } else {
    extend_snapshot(path, std::move(bag), entries, classes);
  }
  return known;
}

void require_new_map(const std::string& path) {
  if (fs::exists(path)) throw InputError(path, "it exists; give another name");
  if (is_sqlite_name(path)) require_no_journal(path);
}

void write_new_map(const std::string& path, const SavedMap& map, const ObjectClasses& classes) {
  const topobag::WriterLock lock(path);
  require_new_map(path);
  if (is_sqlite_name(path)) {
    write_sqlite_map(path, map, described(classes));
  } else {
    write_snapshot(path, map.bag, classes, !classes.file.empty());
  }
}

std::vector<Keyframe> read_map(const std::string& map, const KeyframeOptions& options) {
  if (!is_saved_map(map)) {
    require_map(map);
    return read_keyframes(map, options);
  }
  const SavedMap saved = read_saved_map(map, options.classes);
  std::map<std::uint32_t, SavedSession> sessions;
  for (const SavedSession& session : saved.sessions) sessions[session.id] = session;
  std::map<std::uint32_t, std::uint64_t> first_ids;
  std::vector<Keyframe> keyframes;
  saved.bag.for_each([&](topobag::KeyframeId key, const topobag::EntryInfo& info,
                         const topobag::TopologyGraph<>& graph) {
    const std::uint64_t id = topobag::value(key);
    const std::uint64_t next = keyframes.empty() ? 0 : keyframes.back().saved->id + 1;
    const std::uint64_t first = first_ids.emplace(info.session, next).first->second;
    sessions[info.session].id = info.session;
    keyframes.push_back({static_cast<std::int64_t>(id - first), info.stamp.value_or(0.0),
                         info.T_world_camera, graph, SavedEntry{id, sessions[info.session]}});
  });
  if (keyframes.empty()) throw InputError(map, "the map holds no key frame");
  // A saved map has a name of its own, whatever it was made of.
  if (options.objects.learnt_of.empty()) tell_of_relation(options.objects, map);
  return keyframes;
}

}  // namespace program
