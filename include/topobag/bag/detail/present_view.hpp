// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// To be dereferenced: the bag's view where it has one, else the bag itself.
template <typename Bag>
auto present_view(const Bag& bag, int) -> decltype(bag.view()) {
  return bag.view();
}
template <typename Bag>
const Bag* present_view(const Bag& bag, long) {
  return &bag;
}

template <typename Bag>
using PresentView = std::decay_t<decltype(*present_view(std::declval<const Bag&>(), 0))>;

}  // namespace detail
}  // namespace v0
}  // namespace topobag
