// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/types/class_catalog.hpp>

#include "saved_map.hpp"

namespace program {

/// Reads an SQLite map and leaves it untouched. Throws topobag::Error, and InputError where the
/// program was built without SQLite; so does the next.
SavedMap read_sqlite_map(const std::string& path, const topobag::ClassCatalog& catalog);

/// Adds a session to an SQLite map, which is made where there is none: whole, or not at all.
void extend_sqlite_map(const std::string& path, const std::string& session,
                       const topobag::BagOfTopologyGraphs<>& entries,
                       const topobag::ClassCatalog& catalog);

/// Makes an SQLite map of a map in memory, with the names of its sessions: whole, or not at all.
void write_sqlite_map(const std::string& path, const SavedMap& map,
                      const topobag::ClassCatalog& catalog);

}  // namespace program
