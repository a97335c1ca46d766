// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <topobag/adaptors/fleet/fleet_outbox.hpp>
#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/adaptors/postgres.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// Sends what the server lacks of a robot's map, in order, in batches of one transaction each.
/// Whatever stops it, and wherever: called again, it goes on with what is missing, which the server
/// itself says. Returns how many versions were added. Throws as `PostgresStore::append`, and
/// InvalidId when the server knows more of the map than the map does: it is an old copy.
inline std::size_t push(const FleetOutbox& outbox, PostgresStore& store, std::size_t batch = 1000) {
  const FleetMember& member = outbox.member();
  std::int64_t sent = store.last_seq(member.site, member.robot, outbox.sessions());
  if (sent > outbox.last_seq()) {
    throw InvalidId(outbox.path() + ": the server holds change " + std::to_string(sent) +
                    " of this map, whose last is " + std::to_string(outbox.last_seq()) +
                    ": it is an old copy; go on with the latest, or a new map");
  }
  // The last one is sent again: the server tells a copy of the map that went another way since.
  sent = std::max<std::int64_t>(0, sent - 1);
  std::size_t added = 0;
  for (;;) {
    const std::vector<FleetVersion> versions = outbox.after(sent, batch);
    if (versions.empty()) return added;
    added += store.append(versions);
    sent = versions.back().seq;
  }
}

}  // namespace v0
}  // namespace topobag
