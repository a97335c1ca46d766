// SPDX-License-Identifier: MIT
// What the page closing_a_loop.md shows.
#ifdef TOPOBAG_HAS_SQLITE
#include <cstdint>
#include <random>

#include <topobag/adaptors/sqlite.hpp>
#include <topobag/recognition/align_maps.hpp>
#include <topobag/recognition/loop_detector.hpp>

#include "catch.hpp"
#include "docs/working_folder.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

/// Takes a factor for the truth: the rooms stand in a row.
struct StraightBackEnd {
  std::size_t factors = 0;
  std::map<KeyframeId, Eigen::Isometry3d> truth;

  void add_factor(KeyframeId from, KeyframeId to, const Eigen::Isometry3d& T_from_to,
                  const Eigen::Matrix<double, 6, 6>& covariance) {
    ++factors;
    const Eigen::Isometry3d error = T_from_to.inverse() * truth.at(from).inverse() * truth.at(to);
    CHECK(error.translation().norm() < 0.05);
    CHECK(covariance.diagonal().minCoeff() > 0.0);
  }
  std::map<KeyframeId, Eigen::Isometry3d> optimize() const { return truth; }
};

Eigen::Isometry3d room_in_row(unsigned room) {
  return Eigen::Isometry3d(Eigen::Translation3d(10.0 * room, 0.0, 0.0));
}

}  // namespace

TEST_CASE("the map follows the back end, and takes in another", "[docs]") {
  const WorkingFolder folder;
  std::mt19937 random(1);
  StraightBackEnd back_end;
  SqliteBag<> map("flat.db");
  LoopDetector loops(map);  // refers to the map: there is no second one
  for (unsigned i = 0; i < 8; ++i) {
    const KeyframeId id{i};
    const double stamp = 10.0 * i;
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    const auto graph = SyntheticRoom(i % 4, 10, 8).seen_from(T_room_camera);
    back_end.truth[id] = room_in_row(i % 4) * T_room_camera;
    EntryInfo info;  // the odometry has drifted
    info.T_world_camera = Eigen::Translation3d(0.1 * i, 0.0, 0.0) * back_end.truth[id];
    const Recognition loop = loops.detect_and_add(id, stamp, graph, info);
    if (loop) {
      const auto factor = loop.accepted->pose->with_covariance().as<GtsamPose>();
      back_end.add_factor(loop.accepted->id, id, factor.T, factor.covariance);
      CameraPoses poses;
      for (const auto& [key_frame, T_world_camera] : back_end.optimize()) {
        poses[key_frame] = T_world_camera;
      }
      map.set_poses(poses);
    }
  }
  CHECK(back_end.factors == 4);
  CHECK(map.info(KeyframeId{1})->T_world_camera->isApprox(back_end.truth[KeyframeId{1}], 1e-9));

  const Eigen::Isometry3d T_map_other =
      Eigen::Translation3d(3.0, 2.0, 1.0) * Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY());
  BagOfTopologyGraphs<> other;
  for (unsigned i = 0; i < 5; ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    EntryInfo info;
    info.T_world_camera = T_map_other.inverse() * room_in_row(i) * T_room_camera;
    other.add(KeyframeId{i}, SyntheticRoom(i, 10, 8).seen_from(T_room_camera), info);
  }
  const MapAlignment alignment = align_maps(map, other);
  if (alignment) {
    // the other map's sessions follow ours, from 1
    const auto new_ids = map.merge(other, alignment.merge_options(1));
    CHECK(new_ids.at(KeyframeId{4}) == KeyframeId{12});
  }
  REQUIRE(map.size() == 13);
  const Eigen::Vector3d moved = map.info(KeyframeId{12})->T_world_camera->translation();
  CHECK((moved - room_in_row(4).translation()).norm() < 2.0);  // its camera's own place in the room
}
#endif
