// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <mutex>
#include <string>
#include <utility>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// Calls it with each; throws the first error when all were called.
template <typename Range, typename Call>
void call_for_all(const Range& range, Call call) {
  std::exception_ptr first_error;
  for (const auto& each : range) {
    try {
      call(each);
    } catch (...) {
      if (!first_error) first_error = std::current_exception();
    }
  }
  if (first_error) std::rethrow_exception(first_error);
}

}  // namespace detail

/// Keeps exceptions from a host that does not expect any: they are counted. May be used from any
/// thread.
class CallGuard {
 public:
  /// What `call` returns, or a value of its type that says nothing when it throws.
  template <typename Call>
  auto operator()(Call call) -> decltype(call()) {
    try {
      return call();
    } catch (const std::exception& error) {
      note(error.what());
    } catch (...) {
      note("the call threw something that is not a std::exception");
    }
    return {};
  }

  /// Calls that ended in an exception, and what the last one said.
  std::pair<std::size_t, std::string> failures() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return failures_;
  }

 private:
  void note(const char* why) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++failures_.first;
    failures_.second = why;
  }

  mutable std::mutex mutex_;
  std::pair<std::size_t, std::string> failures_;
};

}  // namespace v0
}  // namespace topobag
