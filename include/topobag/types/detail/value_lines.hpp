// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The shortest text that reads back as the same number, whatever the locale.
template <typename Number>
std::string exact_text(Number number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

/// A text of values, a line each, as this library keeps what it has learnt: `topobag <what>
/// <version>` first, `end` last.
class ValueLines {
 public:
  /// @param what  the text is, a word or two
  ValueLines(std::string what, std::string_view text) : what_(std::move(what)), text_(text) {}

  /// Throws FormatError: the line and the sentence; `index()` is the line's number, from 1.
  [[noreturn]] void fail(const std::string& sentence) const {
    throw FormatError(what_ + ", line " + std::to_string(number_) + ": " + sentence, number_);
  }

  /// Reads the first line. Throws FormatError for another text's, and a version beyond `latest`.
  std::size_t version(std::size_t latest) {
    const std::string title = "topobag " + what_ + ' ';
    if (text_.substr(0, title.size()) != title) {
      throw FormatError(what_ + ", line 1: this is no " + what_ + '.', 1);
    }
    const auto version = number<std::size_t>(next().substr(title.size()));
    if (version > latest) {
      fail("it is of version " + std::to_string(version) + ", later than this library's, " +
           std::to_string(latest) + '.');
    }
    if (version == 0) fail("there is no such version.");
    return version;
  }

  /// The next line, which must be whole.
  std::string_view next() {
    ++number_;
    const std::size_t end = text_.find('\n');
    if (end == std::string_view::npos) fail("the text is cut off.");
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  /// Whether the next line begins so.
  bool next_begins(std::string_view with) const { return text_.substr(0, with.size()) == with; }

  /// What stands behind `key` and a blank on the next line.
  std::string_view behind(std::string_view key) {
    const std::string_view line = next();
    if (line.substr(0, key.size()) != key || line.substr(key.size(), 1) != " ") {
      fail("'" + std::string(key) + "' and its value are missing.");
    }
    return line.substr(key.size() + 1);
  }

  /// The whole of `text` as a number.
  template <typename Number>
  Number number(std::string_view text) const {
    Number number{};
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (status != std::errc{} || end != text.data() + text.size()) {
      fail("'" + std::string(text) + "' is not a number that fits here.");
    }
    return number;
  }

  /// Takes the number off the front of `text`, with the blank behind it.
  template <typename Number>
  Number take(std::string_view& text) const {
    const std::size_t blank = text.find(' ');
    const auto first = number<Number>(text.substr(0, blank));
    text = blank == std::string_view::npos ? std::string_view() : text.substr(blank + 1);
    return first;
  }

  /// Throws unless all was read.
  void require_end() {
    if (text_.empty()) return;
    ++number_;
    fail("something stands behind the end.");
  }

 private:
  std::string what_;
  std::string_view text_;
  std::size_t number_ = 0;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
