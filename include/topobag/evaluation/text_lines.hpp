// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/evaluation/number_text.hpp>

namespace topobag {
inline namespace v0 {

/// Whether a file that begins so is one of gzip, ZIP, bzip2, xz or Zstandard, by the marks that
/// their formats begin with.
inline bool is_compressed(std::string_view beginning) {
  constexpr std::array<std::string_view, 5> marks{"\x1F\x8B", "PK\x03\x04", "BZh", "\xFD\x37zXZ",
                                                  "\x28\xB5\x2F\xFD"};
  return std::any_of(marks.begin(), marks.end(), [&](std::string_view mark) {
    return beginning.substr(0, mark.size()) == mark;
  });
}

/// The lines of a text file: how every reader of text reads, and complains.
///
/// Lines end as on Unix or Windows, and no others; a byte-order mark, the blanks around a line,
/// blank lines and
/// `#` comment lines are left out. What is no text in UTF-8 or ASCII is refused. Every complaint
/// names the file and the line.
class TextLines {
 public:
  /// @param stream  read as the lines are asked for; it must live as long
  /// @param name    of the file, for complaints
  TextLines(std::istream& stream, std::string name) : stream_(stream), name_(std::move(name)) {}

  /// The next line; false at the end. The view lives until the next call. Throws Error for bytes
  /// that are no text, and when the stream fails.
  bool next(std::string_view& line) {
    while (std::getline(stream_, buffer_)) {
      ++number_;
      line = buffer_;
      if (number_ == 1) {
        require_plain(line);
        line = without_mark(line);
      }
      line = trimmed(line);
      if (line.empty()) continue;
      require_line_ends(line);
      if (line.front() == '#') {
        heading_ = line;
        continue;
      }
      require_text(line);
      return true;
    }
    if (stream_.bad()) throw Error(name_ + " could not be read to its end.", number_);
    return false;
  }

  /// Of the line that `next` gave, from 1.
  std::size_t number() const noexcept { return number_; }
  /// Of the file.
  const std::string& name() const noexcept { return name_; }
  /// The last comment line above, its `#` included; empty without one.
  const std::string& heading() const noexcept { return heading_; }

  /// To be thrown: file, line and the sentence; `index()` is the line's number.
  Error error(const std::string& sentence) const {
    return Error(name_ + ":" + std::to_string(number_) + ": " + sentence, number_);
  }

  /// What `call()` returns; an Error of it gets file and line.
  template <typename Call>
  auto located(const Call& call) const {
    try {
      return call();
    } catch (const Error& why) {
      throw error(why.what());
    }
  }

  /// The fields of a line into `fields`: between commas where it has one, else between blanks.
  static void split(std::string_view line, std::vector<std::string_view>& fields) {
    fields.clear();
    const bool commas = line.find(',') != std::string_view::npos;
    const std::string_view separators = commas ? "," : " \t";
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
      const std::string_view field = trimmed(line.substr(begin, end - begin));
      if (commas || !field.empty()) fields.push_back(field);
      begin = end + 1;
    }
  }

  /// The numbers of a line, separated as `split` does, into `values`; anything else is refused.
  void numbers(std::string_view line, std::vector<double>& values) {
    values.clear();
    split(line, fields_);
    for (const std::string_view field : fields_) values.push_back(number(field));
  }

  /// The number that a field of the current line is. Throws Error when it is none.
  double number(std::string_view field) const {
    if (const auto value = parse_number(field)) return *value;
    if (field.empty()) throw error("a number is missing between two commas, or at an end.");
    throw error("'" + std::string(field.substr(0, 40)) + "' is not a number" + advice(field) + '.');
  }

 private:
  /// What to do about a field that holds a separator, though it was separated.
  static const char* advice(std::string_view field) {
    if (field.find(';') != std::string_view::npos) {
      return ": separate numbers by commas or blanks, not semicolons, and write 0.5, not 0,5";
    }
    const bool digits = field.find_first_of("0123456789") != std::string_view::npos;
    if (digits && field.find_first_of(" \t") != std::string_view::npos) {
      return ": separate numbers by commas or by blanks, not by both, and write 0.5, not 0,5";
    }
    return "";
  }

  void require_plain(std::string_view line) const {
    if (is_compressed(line)) throw error("this is compressed: unpack it first");
  }

  std::string_view without_mark(std::string_view line) const {
    const std::string_view start = line.substr(0, 2);
    if (start == "\xFF\xFE" || start == "\xFE\xFF") throw error("this is UTF-16: save it as UTF-8");
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return line.substr(0, mark.size()) == mark ? line.substr(mark.size()) : line;
  }

  void require_line_ends(std::string_view line) const {
    if (line.find('\r') == std::string_view::npos) return;
    throw error("the lines end as on an old Mac, by CR alone: save the file with LF or CR LF");
  }

  void require_text(std::string_view line) const {
    const auto is_control = [](char c) { return (c >= '\0' && c < ' ' && c != '\t') || c == 0x7F; };
    if (std::any_of(line.begin(), line.end(), is_control)) {
      throw error("this is no text; is it the right file?");
    }
  }

  std::istream& stream_;
  std::string name_;
  std::string buffer_;
  std::string heading_;
  std::vector<std::string_view> fields_;
  std::size_t number_ = 0;
};

/// Opens a file for a reader; throws Error with the system's reason when that fails, or when it is
/// a folder.
inline std::ifstream open_file(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file || (file.peek(), file.bad())) {
    throw Error(path + " cannot be opened for reading" +
                (errno == 0 ? "" : ": " + std::generic_category().message(errno)) + '.');
  }
  file.clear();
  return file;
}

}  // namespace v0
}  // namespace topobag
