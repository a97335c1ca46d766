// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
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

  /// "file:line: sentence"; `line` counts from 1.
  InputError(const std::string& file, std::size_t line, const std::string& sentence)
      : Error(file + ":" + std::to_string(line) + ": " + sentence) {}
};

}  // namespace program
