// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "scratch_folder.hpp"

/// The names of the pages' files stand for themselves: they lie in a folder of the test's own.
class WorkingFolder {
 public:
  WorkingFolder() { std::filesystem::current_path(folder_.path("")); }
  ~WorkingFolder() { std::filesystem::current_path(before_); }

 private:
  ScratchFolder folder_;
  std::filesystem::path before_ = std::filesystem::current_path();
};
