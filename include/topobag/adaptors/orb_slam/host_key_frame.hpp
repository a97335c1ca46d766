// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>

#include <topobag/adaptors/orb_slam/host_pose.hpp>
#include <topobag/adaptors/orb_slam/host_traits.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

template <typename KeyFrame>
using host_neighbor_t =
    decltype(*std::begin(std::declval<const std::decay_t<decltype(host_traits<KeyFrame>::neighbors(
                             std::declval<KeyFrame&>()))>&>()));

template <typename KeyFrame, typename Traits = host_traits<KeyFrame>, typename = void>
struct is_host_key_frame : std::false_type {};
template <typename KeyFrame, typename Traits>
struct is_host_key_frame<
    KeyFrame, Traits,
    std::enable_if_t<
        std::is_convertible_v<decltype(Traits::id(std::declval<KeyFrame&>())), std::uint64_t> &&
        std::is_convertible_v<decltype(Traits::stamp(std::declval<KeyFrame&>())), double> &&
        std::is_convertible_v<decltype(Traits::is_bad(std::declval<KeyFrame&>())), bool> &&
        is_host_pose_v<decltype(Traits::T_world_camera(std::declval<KeyFrame&>()))> &&
        std::is_convertible_v<decltype(&*std::declval<host_neighbor_t<KeyFrame>>()),
                              const KeyFrame*>>> : std::true_type {};

}  // namespace detail

/// Whether `host_traits<KeyFrame>` has what `OrbSlamDatabase` asks for, by ORB-SLAM's names or by a
/// specialisation (C++20: `concept HostKeyFrame`). It has to be a complete type.
template <typename KeyFrame>
inline constexpr bool is_host_key_frame_v = detail::is_host_key_frame<KeyFrame>::value;

}  // namespace v0
}  // namespace topobag
