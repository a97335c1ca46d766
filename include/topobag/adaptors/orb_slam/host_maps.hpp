// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

template <typename KeyFrame, typename = void>
struct has_maps : std::false_type {};
template <typename KeyFrame>
struct has_maps<KeyFrame, std::void_t<decltype(std::declval<KeyFrame&>().GetMap()->IsBad())>>
    : std::true_type {};

}  // namespace detail

/// Whether the host keeps several maps, as ORB-SLAM3 does: `KeyFrame::GetMap()`, `Map::IsBad()`.
template <typename KeyFrame>
inline constexpr bool has_maps_v = detail::has_maps<KeyFrame>::value;

/// Whether a key frame is of no more use: bad itself or, with several maps, in a bad one.
template <typename KeyFrame>
bool is_bad(KeyFrame& key_frame) {
  if (key_frame.isBad()) return true;
  if constexpr (has_maps_v<KeyFrame>) return key_frame.GetMap()->IsBad();
  return false;
}

/// The map a key frame is in; null for hosts with one alone.
template <typename KeyFrame>
const void* map_of(KeyFrame& key_frame) {
  if constexpr (has_maps_v<KeyFrame>) return key_frame.GetMap();
  return nullptr;
}

}  // namespace v0
}  // namespace topobag
