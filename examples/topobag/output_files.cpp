// SPDX-License-Identifier: MIT
#include "output_files.hpp"

#include <filesystem>
#include <system_error>
#include <vector>

#include "input_error.hpp"

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
  return are_same(value, file) || are_same(value + ".frames.csv", file) ||
         are_same(value + ".nodes.csv", file);
}

}  // namespace

CLI::Option* add_output_option(CLI::App& command, const std::string& name, std::string& file,
                               const std::string& description) {
  return command.add_option(name, file, description)->group(output_group);
}

void require_folder(const std::string& option, const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  if (folder.empty() || fs::is_directory(folder)) return;
  throw InputError(option + ' ' + file, "the folder does not exist; make it first");
}

void require_outputs(const CLI::App& command) {
  const std::vector<const CLI::Option*> options = command.get_options();
  for (const CLI::Option* output : options) {
    if (output->get_group() != output_group || output->empty()) continue;
    const fs::path file = output->results().front();
    require_folder(output->get_name(), file.string());
    if (fs::exists(file) && !fs::is_regular_file(file)) continue;
    for (const CLI::Option* other : options) {
      if (other == output || other->empty() || other->get_type_name() != "TEXT") continue;
      if (means(other->results().front(), file)) {
        throw InputError(output->get_name() + ' ' + file.string(),
                         "the file is also that of " + other->get_name() + "; give another name");
      }
    }
  }
}

}  // namespace program
