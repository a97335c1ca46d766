// SPDX-License-Identifier: MIT
#pragma once

#include <Frame.h>
#include <KeyFrame.h>
#include <KeyFrameDatabase.h>
#include <Map.h>
#include <SemanticHooks.h>
#include <System.h>

/// ORB-SLAM2, as the program calls it.
namespace host {

using KeyFrame = ORB_SLAM2::KeyFrame;
using Frame = ORB_SLAM2::Frame;
using Map = ORB_SLAM2::Map;
using System = ORB_SLAM2::System;
using Pose = cv::Mat;  ///< world to camera

inline constexpr const char* name = "ORB-SLAM2";

inline bool is_tracking(System& slam) { return slam.GetTrackingState() == ORB_SLAM2::Tracking::OK; }

/// What the host holds while it moves its key frames; its database is told, for they do not lead
/// to their map.
template <typename Database>
void hold_poses(Database& database, System& slam) {
  database.hold_poses_with(slam.GetMap()->mMutexMapUpdate);
}

/// A lost tracker that makes no new map: by the host's localization mode.
inline void stop_mapping(System& slam) { slam.ActivateLocalizationMode(); }

}  // namespace host
