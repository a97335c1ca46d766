// SPDX-License-Identifier: MIT
#include "saved_map.hpp"

#include <filesystem>
#include <fstream>
#include <set>

#include <topobag/bag/snapshot_file.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

#include "input_error.hpp"
#include "sqlite_map.hpp"

namespace program {
namespace {

using Bag = topobag::BagOfTopologyGraphs<>;

std::uint64_t class_fingerprint() { return topobag::fingerprint(topobag::ClassCatalog::coco80()); }

/// The numbers of the runs in a bag, ascending.
std::set<std::uint32_t> sessions_in(const Bag& bag) {
  std::set<std::uint32_t> sessions;
  bag.for_each([&](topobag::KeyframeId, const topobag::EntryInfo& info, const auto&) {
    sessions.insert(info.session);
  });
  return sessions;
}

SavedMap read_snapshot(const std::string& path) {
  const topobag::SnapshotHeader header = topobag::inspect(path);
  SavedMap saved{"snapshot, format " + std::to_string(header.format_version),
                 {},
                 topobag::load<Bag>(path, class_fingerprint())};
  for (const std::uint32_t session : sessions_in(saved.bag))
    saved.sessions.push_back({session, ""});
  return saved;
}

void extend_snapshot(const std::string& path, const std::vector<Keyframe>& keyframes) {
  Bag bag = std::filesystem::exists(path) ? read_snapshot(path).bag : Bag();
  const std::set<std::uint32_t> sessions = sessions_in(bag);
  const std::uint32_t session = sessions.empty() ? 0 : *sessions.rbegin() + 1;
  for (const MapEntry& entry : new_entries(bag, session, keyframes)) {
    bag.add(entry.id, *entry.graph, entry.info);
  }
  topobag::SaveOptions options;
  options.catalog_fingerprint = class_fingerprint();
  topobag::save(bag, path, options);
}

std::string beginning_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path, "the file cannot be opened; check the path");
  std::string bytes(16, '\0');
  file.read(bytes.data(), 16);
  return bytes;
}

}  // namespace

std::vector<MapEntry> new_entries(const Bag& bag, std::uint32_t session,
                                  const std::vector<Keyframe>& keyframes) {
  std::uint64_t first = 0;
  bag.for_each(
      [&](topobag::KeyframeId id, const auto&, const auto&) { first = topobag::value(id) + 1; });
  std::vector<MapEntry> entries;
  for (const Keyframe& keyframe : keyframes) {
    if (keyframe.idx < 0) {
      throw InputError("frame idx " + std::to_string(keyframe.idx) +
                       " is negative, which no key frame of a map can be");
    }
    topobag::EntryInfo info;
    info.stamp = keyframe.timestamp;
    info.session = session;
    info.T_world_camera = keyframe.T_world_camera;
    entries.push_back({topobag::KeyframeId{first + static_cast<std::uint64_t>(keyframe.idx)},
                       std::move(info), &keyframe.graph});
  }
  return entries;
}

SavedMap read_saved_map(const std::string& path) {
  const std::string beginning = beginning_of(path);
  if (beginning.compare(0, 15, "SQLite format 3") == 0) return read_sqlite_map(path);
  if (beginning.compare(0, 8, "\x89TBG\r\n\x1a\n") == 0) return read_snapshot(path);
  throw InputError(path, "it is no map: neither an SQLite map nor a snapshot of topobag");
}

void write_saved_map(const std::string& path, const std::string& session,
                     const std::vector<Keyframe>& keyframes, bool append) {
  if (std::filesystem::exists(path) && !append) {
    throw InputError(path, "it exists; give --append to go on mapping, or another name");
  }
  if (std::filesystem::path(path).extension() == ".db") {
    extend_sqlite_map(path, session, keyframes);
  } else {
    extend_snapshot(path, keyframes);
  }
}

std::vector<Keyframe> read_map(const std::string& map, const KeyframeOptions& options) {
  if (!std::filesystem::is_regular_file(map)) return read_keyframes(map, options);
  std::vector<Keyframe> keyframes;
  read_saved_map(map).bag.for_each([&](topobag::KeyframeId id, const topobag::EntryInfo& info,
                                       const topobag::TopologyGraph<>& graph) {
    keyframes.push_back({static_cast<std::int64_t>(topobag::value(id)), info.stamp.value_or(0.0),
                         info.T_world_camera, graph});
  });
  if (keyframes.empty()) throw InputError(map, "the map holds no key frame");
  return keyframes;
}

}  // namespace program
