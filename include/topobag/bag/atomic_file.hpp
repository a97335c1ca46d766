// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/platform.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// An output stream's way into an open file. Remembers why a write failed.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(int file) : file_(file), buffer_(65536) { reset(); }

  /// `errno` of the first write that failed; 0 = none did.
  int error() const noexcept { return error_; }

 protected:
  int_type overflow(int_type byte) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(byte, traits_type::eof())) {
      *pptr() = traits_type::to_char_type(byte);
      pbump(1);
    }
    return traits_type::not_eof(byte);
  }

  int sync() override {
    for (const char* at = pbase(); error_ == 0 && at != pptr();) {
      const std::ptrdiff_t written = write_some(file_, at, static_cast<std::size_t>(pptr() - at));
      if (written >= 0) {
        at += written;
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
    reset();
    return error_ == 0 ? 0 : -1;
  }

 private:
  void reset() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

  int file_;
  int error_ = 0;
  std::vector<char> buffer_;
};

inline std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find_last_of(folder_separators);
  return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

}  // namespace detail

/// A file that appears under its name complete and on the disk, or not at all: what stood there
/// before stays until then. A link is followed: the file behind it is written.
///
/// Written beside its place under a name of its own; `commit` syncs and renames. Without it the
/// destructor takes the unfinished file away; a process that is killed leaves it behind, and it may
/// be deleted.
class AtomicFile {
 public:
  /// Throws Error when the file cannot be made, or what stands there is no regular file.
  explicit AtomicFile(const std::string& path) : path_(detail::real_path(path)) {
    using Kind = detail::FileStatus::Kind;
    const detail::FileStatus before = detail::status_of(path_);
    if (before.kind == Kind::folder) fail(EISDIR);
    if (before.kind == Kind::other) fail(EINVAL);
    for (int attempt = 0; file_ < 0; ++attempt) {
      temporary_ = path_ + ".part-" + std::to_string(detail::process_number()) + '-' + std::to_string(attempt);
      file_ = detail::create_file(temporary_);
      if (file_ < 0 && errno != EEXIST) fail(errno);
    }
    if (before.kind == Kind::regular) detail::set_mode(file_, before.mode);
    buffer_ = std::make_unique<detail::FileBuffer>(file_);
  }

  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  ~AtomicFile() {
    if (file_ >= 0) detail::close_file(file_);
    if (!temporary_.empty()) std::remove(temporary_.c_str());
  }

  /// Where the content goes.
  std::streambuf* buffer() noexcept { return buffer_.get(); }

  /// Throws Error with the system's reason; then the old file is as it was.
  void commit() {
    if (buffer_->pubsync() != 0) fail(buffer_->error());
    if (detail::sync_file(file_) != 0) fail(errno);
    if (detail::close_file(std::exchange(file_, -1)) != 0) fail(errno);
    if (detail::replace_file(temporary_, path_) != 0) fail(errno);
    temporary_.clear();
    detail::sync_folder(detail::folder_of(path_));
  }

  /// Throws Error with the reason for which a write failed.
  [[noreturn]] void fail() const { fail(buffer_->error()); }

 private:
  [[noreturn]] void fail(int reason) const {
    throw Error(path_ + " cannot be written: " + std::generic_category().message(reason));
  }

  std::string path_;
  std::string temporary_;
  int file_ = -1;
  std::unique_ptr<detail::FileBuffer> buffer_;
};

}  // namespace v0
}  // namespace topobag
