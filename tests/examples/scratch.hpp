// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "csv_reader.hpp"

/// A folder of a test's own that goes with it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "topobag_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// The path of a file in the folder.
  std::string path(const std::string& file) const { return (path_ / file).string(); }

  /// Writes a file and returns its path.
  std::string write(const std::string& file, const std::string& text) const {
    program::write_file(path(file), text);
    return path(file);
  }

 private:
  std::filesystem::path path_;
};

/// What `call` throws as a topobag::Error, without the folder that its text begins with.
template <typename Call>
std::string error_in(const ScratchFolder& folder, const Call& call) {
  try {
    call();
  } catch (const topobag::Error& error) {
    const std::string text = error.what();
    const std::string prefix = folder.path("");
    return text.compare(0, prefix.size(), prefix) == 0 ? text.substr(prefix.size()) : text;
  }
  return "nothing was thrown";
}
