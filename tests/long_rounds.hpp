// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>

/// So many of the rounds of a [long] test as TOPOBAG_LONG, in (0, 1], asks for, at least one; all
/// without it.
inline unsigned long_rounds(unsigned rounds) {
  const char* const share = std::getenv("TOPOBAG_LONG");
  if (share == nullptr) return rounds;
  return std::max(1U, static_cast<unsigned>(std::atof(share) * rounds));
}
