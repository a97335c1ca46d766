// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <type_traits>
#include <utility>

#include <topobag/adaptors/orb_slam/host_pose.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

template <typename KeyFrame, typename = void>
struct is_host_key_frame : std::false_type {};
template <typename KeyFrame>
struct is_host_key_frame<
    KeyFrame, std::enable_if_t<
                  std::is_convertible_v<decltype(std::declval<KeyFrame&>().mnId), std::uint64_t> &&
                  std::is_convertible_v<decltype(std::declval<KeyFrame&>().mTimeStamp), double> &&
                  std::is_convertible_v<decltype(std::declval<KeyFrame&>().isBad()), bool> &&
                  is_host_pose_v<decltype(std::declval<KeyFrame&>().GetPoseInverse())> &&
                  std::is_convertible_v<decltype(std::declval<KeyFrame&>().GetConnectedKeyFrames()),
                                        std::set<KeyFrame*>>>> : std::true_type {};

}  // namespace detail

/// Whether `KeyFrame` has the names of ORB-SLAM's that `OrbSlamDatabase` asks for (C++20:
/// `concept HostKeyFrame`). It has to be a complete type.
template <typename KeyFrame>
inline constexpr bool is_host_key_frame_v = detail::is_host_key_frame<KeyFrame>::value;

}  // namespace v0
}  // namespace topobag
