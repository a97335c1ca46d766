// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace program {

/// Holds a table that is being made, until it goes or its process ends: another run for the same
/// table is refused rather than kept waiting, since this takes long. SET.partial.lock is what is
/// locked; a run that was killed leaves it behind, held by nobody.
class TableLock {
 public:
  /// Throws InputError where another run holds the table, or the file cannot be made.
  explicit TableLock(const std::string& set);
  TableLock(const TableLock&) = delete;
  TableLock& operator=(const TableLock&) = delete;
  ~TableLock();

 private:
  std::string path_;
  int file_ = -1;
};

}  // namespace program
