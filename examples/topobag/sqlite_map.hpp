// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/described_catalog.hpp>

#include "saved_map.hpp"

namespace program {

/// What an SQLite map keeps of its classes. Throws as below.
std::optional<topobag::DescribedCatalog> sqlite_map_classes(const std::string& path);

/// Reads an SQLite map and leaves it untouched. Throws topobag::Error, and InputError where the
/// program was built without SQLite; so does the next.
SavedMap read_sqlite_map(const std::string& path, const topobag::DescribedCatalog& classes);

/// Adds a session to an SQLite map, which is made where there is none: whole, or not at all.
void extend_sqlite_map(const std::string& path, const std::string& session,
                       const topobag::BagOfTopologyGraphs<>& entries,
                       const topobag::DescribedCatalog& classes);

/// Makes an SQLite map of a map in memory, with the names of its sessions: whole, or not at all.
void write_sqlite_map(const std::string& path, const SavedMap& map,
                      const topobag::DescribedCatalog& classes);

}  // namespace program
