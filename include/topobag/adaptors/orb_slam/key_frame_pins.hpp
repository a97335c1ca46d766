// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// Who is reading key frames of the host right now. Whoever forgets a pointer waits for those who
/// may have read it before; nobody calls the host with a lock held.
///
/// Every function needs the lock of the mutex that guards the pointers.
class KeyFramePins {
 public:
  /// Of the mutex that guards the pointers.
  using Lock = std::unique_lock<std::mutex>;

  /// Keeps the pointers that were read under `lock` usable until it goes out of scope. Comes with
  /// the lock held and releases it.
  class Scope {
   public:
    /// Pins what was read under `lock`, and releases it.
    Scope(KeyFramePins& pins, Lock& lock) : pins_(pins), mutex_(*lock.mutex()) {
      ticket_ = pins_.next_++;
      pins_.held_.insert(ticket_);
      lock.unlock();
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() {
      const std::lock_guard<std::mutex> lock(mutex_);
      pins_.held_.erase(ticket_);
      pins_.released_.notify_all();
    }

   private:
    KeyFramePins& pins_;
    std::mutex& mutex_;
    std::uint64_t ticket_ = 0;
  };

  /// Returns when no scope older than this call is open. Later ones cannot hold what the caller has
  /// already taken out.
  void wait_for_older(Lock& lock) {
    const std::uint64_t now = next_++;
    released_.wait(lock, [&] { return held_.empty() || *held_.begin() > now; });
  }

 private:
  std::set<std::uint64_t> held_;
  std::uint64_t next_ = 0;
  std::condition_variable released_;
};

}  // namespace v0
}  // namespace topobag
