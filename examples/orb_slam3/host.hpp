// SPDX-License-Identifier: MIT
#pragma once

#include <Frame.h>
#include <KeyFrame.h>
#include <KeyFrameDatabase.h>
#include <Map.h>
#include <SemanticHooks.h>
#include <System.h>

/// ORB-SLAM3, as the program calls it.
namespace host {

using KeyFrame = ORB_SLAM3::KeyFrame;
using Frame = ORB_SLAM3::Frame;
using Map = ORB_SLAM3::Map;
using System = ORB_SLAM3::System;
using Pose = Sophus::SE3f;  ///< world to camera

inline constexpr const char* name = "ORB-SLAM3";

inline bool is_tracking(System& slam) { return slam.GetTrackingState() == ORB_SLAM3::Tracking::OK; }

/// Nothing to tell: key frames lead to their map, and that to its lock.
template <typename Database>
void hold_poses(Database&, System&) {}

/// In its localization mode a lost camera is never looked for. Without, the host begins a new map
/// after 3 s, and finds its way back by merging.
inline void stop_mapping(System&) {}

}  // namespace host
