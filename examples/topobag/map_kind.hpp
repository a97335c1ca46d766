// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace program {

enum class MapKind { sqlite, snapshot };

/// Which kind of map a file is, by its first bytes, whatever its name. Throws InputError for what
/// is no map, and says what it is.
MapKind kind_of(const std::string& path);

/// The same in words: "SQLite map" or "snapshot"; "fleet's map" of an address.
std::string map_kind_text(const std::string& path);

}  // namespace program
