// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <topobag/evaluation/openloris_trajectory.hpp>

namespace program {

/// What a file of poses turned out to be.
enum class PoseFormat { tum, kitti, openloris, frames };

/// Trajectories by sequence number; a format without sequences has one, number 1.
struct PoseFile {
  PoseFormat format = PoseFormat::tum;
  bool stamped = true;  ///< whether the stamps are times; else they are 0, 1, 2, …
  topobag::LifelongTrajectories content;
};

/// Reads poses in TUM, KITTI or OpenLORIS format, or a node table's SET.frames.csv; the format is
/// told from the first line of data. Never without a pose. Throws topobag::Error.
/// @param name   of the file, or of a table, SET
/// @param times  times.txt for a KITTI trajectory, else not read; empty = stamps 0, 1, 2, …
PoseFile read_pose_file(const std::string& name, const std::string& times = "",
                        topobag::RepeatedPoses repeated = topobag::RepeatedPoses::drop);

/// The one trajectory of a file. Throws InputError when it has several, or times
/// that its format does not need.
topobag::Trajectory read_trajectory(const std::string& path, const std::string& times = "");

/// "12 poses from 1.5 to 3.2 s"
std::string span_text(const topobag::Trajectory& trajectory);

}  // namespace program
