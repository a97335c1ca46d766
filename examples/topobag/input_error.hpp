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

}  // namespace program
