// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// The number of the run that is `offset` after `session`. Throws InvalidId where there is none: a
/// number that began again would make one run of two.
inline std::uint32_t session_after(std::uint32_t session, std::uint32_t offset) {
  if (offset > std::numeric_limits<std::uint32_t>::max() - session) {
    throw InvalidId("the numbers of sessions are used up: there are 2^32");
  }
  return session + offset;
}

/// The number of a new run beside those up to `last`; 0 beside none. Throws as `session_after`.
inline std::uint32_t next_session(std::optional<std::uint32_t> last) {
  return last ? session_after(*last, 1) : 0;
}

}  // namespace v0
}  // namespace topobag
