// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// How the adaptor reads a host's key frame. As it stands, by ORB-SLAM's names; specialise it for a
/// host with others, with plain functions of a `KeyFrame&`:
///
///     template <>
///     struct topobag::host_traits<my::KeyFrame> {
///       using Pointer = std::shared_ptr<my::KeyFrame>;  // absent: KeyFrame*
///       static std::uint64_t id(my::KeyFrame&);
///       static double stamp(my::KeyFrame&);             // s
///       static bool is_bad(my::KeyFrame&);              // culled: of no more use
///       static Pose T_world_camera(my::KeyFrame&);      // whatever `host_pose` can read
///       static Pointers neighbors(my::KeyFrame&);       // a range of the covisible ones' pointers
///       static my::Map* map(my::KeyFrame&);             // hosts with several maps alone
///     };
template <typename KeyFrame, typename = void>
struct host_traits {
  /// Not given twice before the database is cleared.
  template <typename K>
  static auto id(K& key_frame) -> decltype(key_frame.mnId) {
    return key_frame.mnId;
  }
  /// When it was taken, s.
  template <typename K>
  static auto stamp(K& key_frame) -> decltype(key_frame.mTimeStamp) {
    return key_frame.mTimeStamp;
  }
  /// Whether it was culled.
  template <typename K>
  static auto is_bad(K& key_frame) -> decltype(key_frame.isBad()) {
    return key_frame.isBad();
  }
  /// Its pose of now, camera to world.
  template <typename K>
  static auto T_world_camera(K& key_frame) -> decltype(key_frame.GetPoseInverse()) {
    return key_frame.GetPoseInverse();
  }
  /// Those that see the same map points.
  template <typename K>
  static auto neighbors(K& key_frame) -> decltype(key_frame.GetConnectedKeyFrames()) {
    return key_frame.GetConnectedKeyFrames();
  }
  /// The one of several maps that it is in now.
  template <typename K>
  static auto map(K& key_frame) -> decltype(key_frame.GetMap()->IsBad(), key_frame.GetMap()) {
    return key_frame.GetMap();
  }
};

/// How the adaptor reads one of a host's several maps; both functions may be absent.
template <typename Map, typename = void>
struct host_map_traits {
  /// Whether it was given up, and its key frames with it.
  template <typename M>
  static auto is_bad(M& map) -> decltype(map.IsBad()) {
    return map.IsBad();
  }
  /// Held by the host while it moves the map's key frames.
  template <typename M>
  static auto pose_mutex(M& map) -> decltype((map.mMutexMapUpdate)) {
    return map.mMutexMapUpdate;
  }
};

namespace detail {

template <typename KeyFrame, typename = void>
struct host_pointer {
  using type = KeyFrame*;
};
template <typename KeyFrame>
struct host_pointer<KeyFrame, std::void_t<typename host_traits<KeyFrame>::Pointer>> {
  using type = typename host_traits<KeyFrame>::Pointer;
};

}  // namespace detail

/// How the host holds a key frame: `KeyFrame*`, unless its traits say otherwise.
template <typename KeyFrame>
using host_pointer_t = typename detail::host_pointer<KeyFrame>::type;

/// The id of a key frame.
template <typename KeyFrame>
std::uint64_t id_of(KeyFrame& key_frame) {
  return static_cast<std::uint64_t>(host_traits<KeyFrame>::id(key_frame));
}

}  // namespace v0
}  // namespace topobag
