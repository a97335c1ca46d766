// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <topobag/recognition/relocalizer.hpp>
#include <topobag/recognition/why.hpp>

#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

TEST_CASE("25 objects of a detector that knows no classes are recognised, and it is told that the "
          "search was cut short",
          "[recognition]") {
  std::mt19937 random(12);
  Relocalizer<> relocalizer;
  std::vector<Eigen::Isometry3d> cameras;
  for (unsigned i = 0; i < 8; ++i) {
    cameras.push_back(random_camera(random));
    relocalizer.map().add(
        KeyframeId{i}, SyntheticRoom(i, 25, 1).seen_from(cameras.back()),
        standing_at(Eigen::Translation3d(100.0 * i, 0.0, 0.0) * cameras.back()));
  }
  for (unsigned i = 0; i < 8; ++i) {
    const Eigen::Isometry3d camera = random_camera(random);
    const Recognition found = relocalizer.localize(SyntheticRoom(i, 25, 1).seen_from(camera));
    CAPTURE(i, why(found));
    REQUIRE(found);
    CHECK(found.accepted->id == KeyframeId{i});
    CHECK_FALSE(found.accepted->complete);
    CHECK(found.accepted->pose->T_candidate_query.isApprox(cameras[i].inverse() * camera, 0.01));
    CHECK(why(found).find("; the search was cut short") != std::string::npos);
  }
}

TEST_CASE("a search that was not cut short is not said to be", "[recognition]") {
  std::mt19937 random(13);
  Relocalizer<> relocalizer;
  const SyntheticRoom room(1, 8, 8);
  relocalizer.map().add(KeyframeId{1}, room.seen_from(random_camera(random)));
  const Recognition found = relocalizer.localize(room.seen_from(random_camera(random)));
  REQUIRE(found);
  CHECK(why(found).find("cut short") == std::string::npos);
}
