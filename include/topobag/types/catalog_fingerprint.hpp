// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detail/class_names.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// A number that two catalogs share when the same class ids mean the same (normalised) names in
/// both, and, but for one chance in 2^64, only then; never 0. Aliases and dynamics do not count.
/// The same on every machine: FNV-1a. O(n).
inline std::uint64_t fingerprint(const ClassCatalog& catalog) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto mix = [&](std::uint8_t byte) { hash = (hash ^ byte) * 0x100000001b3; };
  for (const ClassId id : catalog.ids()) {
    const auto number = static_cast<std::uint32_t>(value(id));
    for (unsigned shift = 0; shift < 32; shift += 8)
      mix(static_cast<std::uint8_t>(number >> shift));
    for (const char letter : detail::normalized_class_name(catalog.name(id))) {
      mix(static_cast<std::uint8_t>(letter));
    }
    mix(0);
  }
  return hash == 0 ? 1 : hash;
}

}  // namespace v0
}  // namespace topobag
