// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>

#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// A node of the candidate graph and a node of the query graph taken for the same object.
struct Correspondence {
  NodeIndex candidate{};  ///< node of the candidate graph
  NodeIndex query{};      ///< node of the query graph

  friend bool operator==(const Correspondence& l, const Correspondence& r) noexcept {
    return l.candidate == r.candidate && l.query == r.query;
  }
  friend bool operator<(const Correspondence& l, const Correspondence& r) noexcept {
    return std::tie(l.query, l.candidate) < std::tie(r.query, r.candidate);
  }
};

}  // namespace v0
}  // namespace topobag
