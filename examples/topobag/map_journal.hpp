// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace program {

/// The file that a path means: behind its links, whether it is there yet or not.
std::string file_behind(const std::string& path);

/// Whether a path is that of a journal of an SQLite map, by the map beside it (MAP-wal, MAP-shm,
/// MAP-journal) or by its first bytes: what is written there is lost to the map.
bool is_map_journal(const std::string& path);

/// Throws InputError where the journal of a map that is gone lies beside a name: a new map of this
/// name would be read with what the old one's journal holds.
void require_no_journal(const std::string& path);

}  // namespace program
