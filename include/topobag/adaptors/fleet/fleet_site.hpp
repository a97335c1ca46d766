// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// What a server knows of a site.
struct FleetSite {
  std::string name;           ///< by which it is asked for
  std::uint64_t catalog = 0;  ///< fingerprint of its classes
  std::size_t versions = 0;   ///< that a reader sees
  std::size_t robots = 0;     ///< that they come from
};

}  // namespace v0
}  // namespace topobag
