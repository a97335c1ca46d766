// SPDX-License-Identifier: MIT
#include "output_files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "input_error.hpp"
#include "map_journal.hpp"
#include "node_table.hpp"
#include "path_kind.hpp"

namespace program {
namespace {

namespace fs = std::filesystem;

/// By which the options are known again, and listed by --help.
constexpr const char* output_group = "Files to write";

/// The one name of a file, which need not exist yet; empty where there is none.
fs::path resolved(const fs::path& path) {
  std::error_code unknown;
  return fs::weakly_canonical(fs::absolute(path, unknown), unknown);
}

/// Whether both paths mean one file.
bool are_same(const fs::path& a, const fs::path& b) {
  return !resolved(a).empty() && resolved(a) == resolved(b);
}

/// Whether an option that says `value` speaks of the file, which may be half of a table.
bool means(const std::string& value, const fs::path& file) {
  const std::string set = set_name(value);
  return are_same(value, file) || are_same(set + ".frames.csv", file) ||
         are_same(set + ".nodes.csv", file) || are_same(set + ".clusters.csv", file);
}

}  // namespace

CLI::Option* add_output_option(CLI::App& command, const std::string& name, std::string& file,
                               const std::string& description) {
  return command.add_option(name, file, description)->group(output_group);
}

void require_folder(const std::string& option, const std::string& file) {
  std::error_code none;
  if (fs::path(file).filename().empty()) {
    throw InputError(option + ' ' + file, "it is a folder; name a file in it");
  }
  const fs::path parent = fs::path(file).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder, none)) {
    throw InputError(option + ' ' + file,
                     "the folder does not exist; make it first" + home_hint(file));
  }
  if (fs::exists(file, none) && !fs::is_regular_file(file, none)) return;  // such as a device
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    const int reason = errno;
    throw InputError(option + ' ' + file, "it cannot be written into its folder: " +
                                              std::generic_category().message(reason));
  }
}

void require_file(const std::string& option, const std::string& file) {
  require_folder(option, file);
  std::error_code none;
  if (fs::is_directory(file, none)) {
    throw InputError(option + ' ' + file, "it is a folder; name a file in it");
  }
  if (set_name(file) == file && fs::exists(file + ".frames.csv", none)) {
    throw InputError(option + ' ' + file,
                     "it is the name of a table, which the file would hide; give another name");
  }
  if (is_map_journal(file)) {
    throw InputError(option + ' ' + file, "it is a map's journal; give another name");
  }
}

void require_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (std::find(values.begin(), values.end(), "") == values.end()) continue;
    throw InputError(option->get_name() + " is empty; give it a value, or leave it out");
  }
  for (const CLI::App* part : command.get_subcommands()) require_values(*part);
}

void require_outputs(const CLI::App& command) {
  const std::vector<const CLI::Option*> options = command.get_options();
  for (const CLI::Option* output : options) {
    if (output->get_group() != output_group || output->empty()) continue;
    const fs::path file = output->results().front();
    require_file(output->get_name(), file.string());
    if (fs::exists(file) && !fs::is_regular_file(file)) continue;
    const PathKind kind = path_kind(file.string());
    for (const CLI::Option* other : options) {
      if (other == output || other->empty() || other->get_type_name() != "TEXT") continue;
      const std::vector<std::string>& named = other->results();
      if (std::any_of(named.begin(), named.end(),
                      [&](const std::string& value) { return means(value, file); })) {
        throw InputError(output->get_name() + ' ' + file.string(),
                         "the file is also that of " + other->get_name() + "; give another name");
      }
    }
    if (kind == PathKind::sqlite_map || kind == PathKind::snapshot) {
      throw InputError(output->get_name() + ' ' + file.string(), "it is a map; give another name");
    }
  }
}

bool are_same_file(const std::string& a, const std::string& b) {
  std::error_code none;
  return fs::equivalent(a, b, none) && !none;
}

}  // namespace program
