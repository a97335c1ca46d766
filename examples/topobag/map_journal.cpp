// SPDX-License-Identifier: MIT
#include "map_journal.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "input_error.hpp"
#include "path_kind.hpp"

namespace program {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> journal_endings = {"-wal", "-shm", "-journal"};

/// By the magic numbers of SQLite's two kinds of journals.
bool begins_as_journal(const std::string& path) {
  std::string beginning(8, '\0');
  std::ifstream(path, std::ios::binary).read(beginning.data(), 8);
  return beginning == "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7" ||
         beginning.compare(0, 4, "\x37\x7f\x06\x82") == 0 ||
         beginning.compare(0, 4, "\x37\x7f\x06\x83") == 0;
}

}  // namespace

std::string file_behind(const std::string& path) {
  std::error_code none;
  fs::path file = path;
  for (int links = 0; links < 40 && fs::is_symlink(file, none); ++links) {
    file = file.parent_path() / fs::read_symlink(file, none);
  }
  return file.string();
}

bool is_map_journal(const std::string& path) {
  for (const std::string ending : journal_endings) {
    if (path.size() <= ending.size()) continue;
    const std::size_t length = path.size() - ending.size();
    if (path.compare(length, ending.size(), ending) != 0) continue;
    if (path_kind(path.substr(0, length)) == PathKind::sqlite_map) return true;
  }
  std::error_code none;
  return fs::is_regular_file(path, none) && begins_as_journal(path);
}

void require_no_journal(const std::string& path) {
  std::error_code none;
  for (const std::string ending : journal_endings) {
    const std::string journal = file_behind(path) + ending;
    if (!fs::exists(journal, none) || fs::exists(path, none)) continue;
    throw InputError(path, "a new map cannot be made beside " + journal +
                               ", the journal of a map of this name; put that map back, delete "
                               "the journal, or give another name");
  }
}

}  // namespace program
