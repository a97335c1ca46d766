// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>

#include "keyframe_graphs.hpp"

namespace program {

/// A map read from a file, an SQLite map or a snapshot, or from a fleet's server.
struct SavedMap {
  std::string format;  ///< such as "SQLite map, schema 1"
  std::vector<SavedSession> sessions;
  topobag::BagOfTopologyGraphs<> bag;
};

/// The entries that `keyframes` make beside those of `bag`: ids are the frames' numbers, beyond
/// those that are there. Throws InputError for a frame with a negative number, topobag::Error as
/// `add` does.
topobag::BagOfTopologyGraphs<> new_entries(const topobag::BagOfTopologyGraphs<>& bag,
                                           const std::vector<Keyframe>& keyframes);

/// How many of the entries are of images that the map at `path` holds a key frame of. Throws
/// InputError when all are: a sequence mapped twice is found by itself.
std::size_t require_new(const std::string& path, const topobag::BagOfTopologyGraphs<>& bag,
                        const topobag::BagOfTopologyGraphs<>& entries);

/// Whether a path names a saved map, not a table or one of a table's files.
bool is_saved_map(const std::string& path);

/// Throws InputError for a path where there is no SQLite map.
void require_sqlite_map(const std::string& path);

/// The classes of the first of these maps that keeps its own, where none were asked for; else those
/// given. Tables keep none. Throws topobag::Error.
ObjectClasses classes_of_maps(const std::vector<std::string>& paths, const ObjectClasses& given);

/// Throws InputError for a file that is neither kind of map; topobag::Error for one that is
/// damaged, or was made with other classes, or keeps something else of them.
SavedMap read_saved_map(const std::string& path, const ObjectClasses& classes = {});

/// Whether a map, there or to be, keeps what its sessions are called: snapshots do not. Throws
/// InputError for a file that is no map.
bool keeps_session_names(const std::string& path);

/// Writes a session, whole or not at all: FILE.db becomes an SQLite map, any other name a snapshot;
/// a map that is there stays what it is and has to be asked for with `append`. Who writes to the
/// same map meanwhile waits. A fleet's server takes a session at any time. Returns how many of the
/// key frames are of images that the map holds one of.
/// @param classes  of the key frames' objects, which a new map keeps, a snapshot where they are not
///                 COCO's: it is read with no other
/// Throws InputError and topobag::Error.
std::size_t write_saved_map(const std::string& path, const std::string& session,
                            const std::vector<Keyframe>& keyframes, const ObjectClasses& classes,
                            bool append);

/// Throws InputError where a map cannot be made anew: there is a file of this name, or the journal
/// of an SQLite map that is gone.
void require_new_map(const std::string& path);

/// Writes a map where there is none, whole or not at all: FILE.db becomes an SQLite map, any other
/// name a snapshot, which does not keep the sessions' names. Throws InputError and topobag::Error.
void write_new_map(const std::string& path, const SavedMap& map, const ObjectClasses& classes);

/// The key frames of a map: of a file, or, as `read_keyframes` makes them, of a table; never none.
/// Those of a file are numbered within their session, whose ids begin after the last one's before.
/// Throws InputError, and topobag::Error for a file that is damaged or of other classes.
std::vector<Keyframe> read_map(const std::string& map, const KeyframeOptions& options);

}  // namespace program
