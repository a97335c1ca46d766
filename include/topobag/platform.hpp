// SPDX-License-Identifier: MIT
#pragma once

/// All that the library asks of the operating system and of the compiler beyond C++17. POSIX is
/// tested; the Windows branch compiles against the declarations that it uses, and has never run.
#if defined(_WIN32) && !defined(TOPOBAG_WINDOWS)
#define TOPOBAG_WINDOWS
#endif

#ifdef TOPOBAG_WINDOWS
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <sys/stat.h>
#include <windows.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <bitset>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// How many bits are set.
inline int popcount(std::uint64_t word) noexcept {
#ifdef __POPCNT__
  return static_cast<int>(std::bitset<64>(word).count());
#else  // no instruction: compilers would call a function; sums of 2, 4 and 8 bits side by side
  word -= (word >> 1) & 0x5555555555555555;
  word = (word & 0x3333333333333333) + ((word >> 2) & 0x3333333333333333);
  word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0F;
  return static_cast<int>((word * 0x0101010101010101) >> 56);
#endif
}

/// Number of the lowest bit that is set. Precondition: there is one.
inline std::size_t lowest_bit(std::uint64_t word) noexcept {
#ifdef __GNUC__
  return static_cast<std::size_t>(__builtin_ctzll(word));
#else
  return std::bitset<64>((word & (~word + 1)) - 1).count();
#endif
}

// ---- Files. What fails gives -1 and says why in `errno`. -----------------------------------------

/// What stands under a name.
struct FileStatus {
  enum class Kind { none, regular, folder, other };

  Kind kind = Kind::none;
  unsigned mode = 0;  ///< permissions
};

#ifdef TOPOBAG_WINDOWS

inline constexpr const char* folder_separators = "/\\";

inline int process_number() noexcept { return ::_getpid(); }

inline FileStatus status_of(const std::string& path) noexcept {
  const unsigned long found = ::GetFileAttributesA(path.c_str());
  if (found == INVALID_FILE_ATTRIBUTES) return {};
  const bool folder = (found & FILE_ATTRIBUTE_DIRECTORY) != 0;
  return {folder ? FileStatus::Kind::folder : FileStatus::Kind::regular, 0};
}

/// For writing; fails with EEXIST where there is one.
inline int create_file(const std::string& path) noexcept {
  return ::_open(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT,
                 _S_IREAD | _S_IWRITE);
}

/// Permissions are inherited from the folder.
inline void set_mode(int, unsigned) noexcept {}

inline std::ptrdiff_t write_some(int file, const char* bytes, std::size_t count) noexcept {
  return ::_write(file, bytes, static_cast<unsigned>(std::min<std::size_t>(count, 1U << 30)));
}

inline int sync_file(int file) noexcept { return ::_commit(file); }
inline int close_file(int file) noexcept { return ::_close(file); }

inline int replace_file(const std::string& from, const std::string& to) noexcept {
  if (::MoveFileExA(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH)) {
    return 0;
  }
  errno = EACCES;
  return -1;
}

/// The move was written through.
inline void sync_folder(const std::string&) noexcept {}

/// The file behind a link, or the path itself where there is none.
inline std::string real_path(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> target(::_fullpath(nullptr, path.c_str(), 0),
                                                      std::free);
  return target ? std::string(target.get()) : path;
}

/// Waits until no other process or thread holds the folder; `valid` unless that cannot be asked.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder) {
    const std::string name = "topobag-" + std::to_string(std::hash<std::string>{}(folder));
    mutex_ = ::CreateMutexA(nullptr, 0, name.c_str());
    if (mutex_ != nullptr) ::WaitForSingleObject(mutex_, INFINITE);
    if (mutex_ == nullptr) errno = EACCES;
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (mutex_ == nullptr) return;
    ::ReleaseMutex(mutex_);
    ::CloseHandle(mutex_);
  }
  bool valid() const noexcept { return mutex_ != nullptr; }

 private:
  void* mutex_ = nullptr;
};

#else

inline constexpr const char* folder_separators = "/";

inline int process_number() noexcept { return ::getpid(); }

inline FileStatus status_of(const std::string& path) noexcept {
  struct ::stat found {};
  if (::stat(path.c_str(), &found) != 0) {
    return {errno == ELOOP ? FileStatus::Kind::other : FileStatus::Kind::none, 0};
  }
  const auto kind = S_ISREG(found.st_mode)   ? FileStatus::Kind::regular
                    : S_ISDIR(found.st_mode) ? FileStatus::Kind::folder
                                             : FileStatus::Kind::other;
  return {kind, static_cast<unsigned>(found.st_mode)};
}

/// For writing; fails with EEXIST where there is one.
inline int create_file(const std::string& path) noexcept {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

inline void set_mode(int file, unsigned mode) noexcept {
  static_cast<void>(::fchmod(file, static_cast<::mode_t>(mode)));
}

inline std::ptrdiff_t write_some(int file, const char* bytes, std::size_t count) noexcept {
  return ::write(file, bytes, count);
}

inline int sync_file(int file) noexcept { return ::fsync(file); }
inline int close_file(int file) noexcept { return ::close(file); }

inline int replace_file(const std::string& from, const std::string& to) noexcept {
  return std::rename(from.c_str(), to.c_str());
}

/// So that a new name, too, survives a loss of power. Not every file system can.
inline void sync_folder(const std::string& folder) noexcept {
  const int opened = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (opened < 0) return;
  static_cast<void>(::fsync(opened));
  ::close(opened);
}

/// What a link itself says, from its folder on; empty of what is no link.
inline std::string link_target(const std::string& path) {
  std::string target(4096, '\0');
  const auto length = ::readlink(path.c_str(), &target[0], target.size());
  if (length <= 0 || static_cast<std::size_t>(length) == target.size()) return {};
  target.resize(static_cast<std::size_t>(length));
  const std::size_t slash = path.find_last_of(folder_separators);
  if (target[0] == '/' || slash == std::string::npos) return target;
  return path.substr(0, slash + 1) + target;
}

/// The file behind a link, which need not be there yet, or the path itself where there is no link.
inline std::string real_path(const std::string& path) {
  std::string name = path;
  for (int links = 0; links < 40; ++links) {
    const std::unique_ptr<char, void (*)(void*)> found(::realpath(name.c_str(), nullptr),
                                                       std::free);
    if (found) return found.get();
    const std::string target = link_target(name);
    if (target.empty()) return name;
    name = target;
  }
  return path;
}

/// Waits until no other process or thread holds the folder; `valid` unless that cannot be asked.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder) {
    folder_ = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
    while (folder_ >= 0 && ::flock(folder_, LOCK_EX) != 0) {
      if (errno == EINTR) continue;
      const int reason = errno;
      ::close(folder_);
      folder_ = -1;
      errno = reason;
    }
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (folder_ >= 0) ::close(folder_);
  }
  bool valid() const noexcept { return folder_ >= 0; }

 private:
  int folder_ = -1;
};

#endif

}  // namespace detail
}  // namespace v0
}  // namespace topobag
