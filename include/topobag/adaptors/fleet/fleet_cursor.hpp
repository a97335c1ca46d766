// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <topobag/adaptors/fleet/uuid.hpp>

namespace topobag {
inline namespace v0 {

/// How far a site's versions have been read from one server.
struct FleetCursor {
  std::string history;        ///< of the server; with another one, reading starts anew
  std::uint64_t arrival = 0;  ///< transaction of the last version read
  Uuid robot{};               ///< the last version's
  Uuid session{};             ///< the last version's
  std::int64_t seq = -1;      ///< the last version's
};

}  // namespace v0
}  // namespace topobag
