// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <type_traits>
#include <utility>

#include <topobag/adaptors/orb_slam/host_traits.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

template <typename KeyFrame>
using host_map_t =
    std::remove_pointer_t<decltype(host_traits<KeyFrame>::map(std::declval<KeyFrame&>()))>;

template <typename KeyFrame, typename = void>
struct has_maps : std::false_type {};
template <typename KeyFrame>
struct has_maps<KeyFrame, std::void_t<host_map_t<KeyFrame>>> : std::true_type {};

template <typename Map, typename = void>
struct has_bad_maps : std::false_type {};
template <typename Map>
struct has_bad_maps<Map, std::void_t<decltype(host_map_traits<Map>::is_bad(std::declval<Map&>()))>>
    : std::true_type {};

template <typename Map, typename = void>
struct has_pose_mutex : std::false_type {};
template <typename Map>
struct has_pose_mutex<
    Map, std::void_t<decltype(host_map_traits<Map>::pose_mutex(std::declval<Map&>()).try_lock())>>
    : std::true_type {};

}  // namespace detail

/// Whether the host keeps several maps, as ORB-SLAM3 does: `KeyFrame::GetMap()`, `Map::IsBad()`, or
/// traits of its own.
template <typename KeyFrame>
inline constexpr bool has_maps_v = detail::has_maps<KeyFrame>::value;

/// Whether a key frame is of no more use: bad itself or, with several maps, in a bad one.
template <typename KeyFrame>
bool is_bad(KeyFrame& key_frame) {
  if (host_traits<KeyFrame>::is_bad(key_frame)) return true;
  if constexpr (has_maps_v<KeyFrame>) {
    using Map = detail::host_map_t<KeyFrame>;
    if constexpr (detail::has_bad_maps<Map>::value) {
      return host_map_traits<Map>::is_bad(*host_traits<KeyFrame>::map(key_frame));
    }
  }
  return false;
}

/// The map a key frame is in; null for hosts with one alone.
template <typename KeyFrame>
const void* map_of(KeyFrame& key_frame) {
  if constexpr (has_maps_v<KeyFrame>) return host_traits<KeyFrame>::map(key_frame);
  return nullptr;
}

namespace detail {

/// Calls `read` while the host does not move the key frames of this one's map: under the map's own
/// mutex where the host's type has one, else under `of_the_host`, when there is that. False, at
/// once, while somebody else holds it.
template <typename KeyFrame, typename Read>
bool try_with_poses_held(KeyFrame& key_frame, std::mutex* of_the_host, Read read) {
  const auto under = [&read](auto& mutex) {
    const std::unique_lock<std::remove_reference_t<decltype(mutex)>> held(mutex, std::try_to_lock);
    if (held.owns_lock()) read();
    return held.owns_lock();
  };
  if constexpr (has_maps_v<KeyFrame>) {
    using Map = host_map_t<KeyFrame>;
    if constexpr (has_pose_mutex<Map>::value) {
      return under(host_map_traits<Map>::pose_mutex(*host_traits<KeyFrame>::map(key_frame)));
    }
  }
  if (of_the_host != nullptr) return under(*of_the_host);
  read();
  return true;
}

}  // namespace detail

}  // namespace v0
}  // namespace topobag
