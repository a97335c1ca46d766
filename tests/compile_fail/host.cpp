// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: a host's key frame has mnId, mTimeStamp, isBad(), GetPoseInverse()
// MISFIT 2: topobag: clearMap needs a KeyFrame with GetMap().
#include <topobag/adaptors/orb_slam.hpp>

struct Map {
  bool IsBad() { return false; }
};

struct KeyFrame {
  unsigned long mnId = 0;
#if MISFIT != 1
  double mTimeStamp = 0.0;
#endif
  bool isBad() { return false; }
  Eigen::Isometry3f GetPoseInverse() { return Eigen::Isometry3f::Identity(); }
  std::set<KeyFrame*> GetConnectedKeyFrames() { return {}; }
#if MISFIT != 2
  Map* GetMap() { return nullptr; }
#endif
};

struct Frame {};

int main() {
  topobag::OrbSlamDatabase<KeyFrame, Frame, Map> database;
  KeyFrame key_frame;
  database.add(&key_frame);
  database.clearMap(nullptr);
}
