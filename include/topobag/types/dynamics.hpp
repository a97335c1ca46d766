// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// How readily objects of a class move: the paper's Table 2.
enum class Dynamics { low, medium, high };

/// A set of dynamics levels.
class DynamicsSet {
 public:
  /// Exactly these levels.
  constexpr DynamicsSet(std::initializer_list<Dynamics> levels) noexcept {
    for (const Dynamics level : levels) bits_ |= bit(level);
  }

  constexpr bool contains(Dynamics level) const noexcept { return (bits_ & bit(level)) != 0; }

 private:
  static constexpr unsigned bit(Dynamics level) noexcept {
    return 1U << static_cast<unsigned>(level);
  }

  unsigned bits_ = 0;
};

}  // namespace v0
}  // namespace topobag
