// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include <topobag/fast_math.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// The root of everything the library throws: bad data at its boundary, said in a sentence.
/// A call that throws has changed nothing.
class Error : public std::runtime_error {
 public:
  /// @param index  of the offending element in the input of the caller
  explicit Error(const std::string& what, std::optional<std::size_t> index = std::nullopt)
      : std::runtime_error(what), index_(index) {}

  /// Position of the offending element in the caller's input, when there is one.
  std::optional<std::size_t> index() const noexcept { return index_; }

 private:
  std::optional<std::size_t> index_;
};

/// A number that is not finite, or outside the range the docstring allows.
class InvalidValue : public Error {
 public:
  using Error::Error;
};

/// A class name or id that the catalog does not hold.
class UnknownClass : public Error {
 public:
  using Error::Error;
};

/// An id that is added twice, or asked for and not there.
class InvalidId : public Error {
 public:
  using Error::Error;
};

/// Bytes that are truncated, damaged, not ours, or written by a later version.
class FormatError : public Error {
 public:
  using Error::Error;
};

}  // namespace v0
}  // namespace topobag
