// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <topobag/error.hpp>

namespace program {

/// Something the program was given is wrong: an argument or a file, said in one line.
class InputError : public topobag::Error {
 public:
  using Error::Error;

  /// "file: sentence"
  InputError(const std::string& file, const std::string& sentence)
      : Error(file + ": " + sentence) {}
};

/// What to do about a path that begins with a ~, to be put behind a complaint; empty for others.
inline std::string home_hint(const std::string& path) {
  return path.rfind('~', 0) == 0
             ? "; the shell leaves ~ as it is in quotes and behind =, so write $HOME"
             : "";
}

}  // namespace program
