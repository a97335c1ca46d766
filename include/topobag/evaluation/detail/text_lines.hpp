// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cstddef>
#include <fstream>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

inline std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The lines of a text file, counted, so that every complaint names the file and the line.
class TextLines {
 public:
  TextLines(std::istream& stream, std::string name) : stream_(stream), name_(std::move(name)) {}

  /// The next line that is neither blank nor a `#` comment, without its outer blanks; false at the
  /// end. The view lives until the next call.
  bool next(std::string_view& line) {
    while (std::getline(stream_, buffer_)) {
      ++number_;
      line = trimmed(buffer_);
      if (!line.empty() && line.front() != '#') return true;
    }
    if (stream_.bad()) throw Error(name_ + " could not be read to its end.", number_);
    return false;
  }

  /// Throws Error: name, line and the sentence; `index()` is the line number, from 1.
  [[noreturn]] void fail(const std::string& sentence) const {
    throw Error(name_ + ", line " + std::to_string(number_) + ": " + sentence, number_);
  }

  std::size_t number() const noexcept { return number_; }
  const std::string& name() const noexcept { return name_; }

  /// The numbers of a line, separated by blanks or, with `separator` a comma, by single commas;
  /// replaces the content of `values`. Locale-independent; anything else is refused.
  void numbers(std::string_view line, char separator, std::vector<double>& values) const {
    values.clear();
    const char* at = line.data();
    const char* const end = at + line.size();
    const auto skip_blanks = [&] {
      while (at != end && (*at == ' ' || *at == '\t')) ++at;
    };
    while (at != end) {
      double value = 0.0;
      const auto [stop, status] = std::from_chars(at, end, value);
      const bool ends = stop == end || *stop == ' ' || *stop == '\t' || *stop == separator;
      if (status != std::errc{} || !ends) {
        const std::string_view rest(at, static_cast<std::size_t>(end - at));
        fail("'" + std::string(rest.substr(0, rest.find_first_of(" \t,"))) + "' is not a number.");
      }
      values.push_back(value);
      at = stop;
      skip_blanks();
      if (at == end || separator == ' ') continue;
      if (*at != separator) fail("two numbers without a separator between them.");
      ++at;
      skip_blanks();
      if (at == end) fail("the line ends after a separator; a number is missing.");
    }
  }

 private:
  std::istream& stream_;
  std::string name_;
  std::string buffer_;
  std::size_t number_ = 0;
};

/// Opens a file for a reader; throws Error when that fails.
inline std::ifstream open_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path + " cannot be opened for reading.");
  return file;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
