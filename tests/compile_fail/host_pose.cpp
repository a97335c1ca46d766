// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: a host's pose has matrix(), or at<float>(row, column) as a cv::Mat.
#include <topobag/adaptors/orb_slam/host_pose.hpp>

struct Pose {
#if MISFIT
  float at(int row, int column) const { return row == column ? 1.0F : 0.0F; }
#else
  template <typename T>
  T at(int row, int column) const {
    return row == column ? T(1) : T(0);
  }
#endif
};

int main() { return topobag::host_pose(Pose()).translation().norm() > 0.0 ? 1 : 0; }
