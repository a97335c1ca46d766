// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/matching/correspondence.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Which nodes of two graphs are in a pair already.
class OneToOne {
 public:
  /// @param candidates, queries  numbers of nodes
  OneToOne(std::size_t candidates, std::size_t queries)
      : candidate_taken_(candidates, false), query_taken_(queries, false) {}

  /// Takes both nodes of `pair`; false, and neither, when one of them is taken.
  bool take(const Correspondence& pair) {
    if (candidate_taken_[value(pair.candidate)] || query_taken_[value(pair.query)]) return false;
    candidate_taken_[value(pair.candidate)] = query_taken_[value(pair.query)] = true;
    return true;
  }

 private:
  std::vector<bool> candidate_taken_, query_taken_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
