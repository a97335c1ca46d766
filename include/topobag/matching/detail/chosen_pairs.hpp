// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/matching/point_pair.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Some of all pairs, where they are.
/// @tparam seen_alike  as if both sides had seen each object from one side (`PointPair`)
template <bool seen_alike = false>
class ChosenPairs {
 public:
  /// @param all     referred to and has to stay, as has `chosen`
  /// @param chosen  positions in `all`
  ChosenPairs(const std::vector<PointPair>& all, const std::vector<std::size_t>& chosen)
      : all_(all), chosen_(chosen) {}

  std::size_t size() const noexcept { return chosen_.size(); }
  decltype(auto) operator[](std::size_t i) const {
    if constexpr (seen_alike) {
      return all_[chosen_[i]].seen_alike();
    } else {
      return (all_[chosen_[i]]);
    }
  }

  class Iterator {
   public:
    Iterator(const ChosenPairs& pairs, std::size_t i) : pairs_(pairs), i_(i) {}
    decltype(auto) operator*() const { return pairs_[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    bool operator!=(const Iterator& other) const noexcept { return i_ != other.i_; }

   private:
    const ChosenPairs& pairs_;
    std::size_t i_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  const std::vector<PointPair>& all_;
  const std::vector<std::size_t>& chosen_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
