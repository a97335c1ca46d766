// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "catch.hpp"
#include "table_stress.hpp"

using namespace program;

namespace {

/// `count` detections of classes 0 to 3 in turn, 2 m away, each in its own place.
NodeTable table_of(std::size_t count) {
  NodeTable table;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 10 == 0) table.frames.emplace_back();
    topobag::RangedDetection detection;
    detection.box = topobag::box_around({static_cast<double>(i), 0.0}, 10.0, 10.0);
    detection.label = topobag::ClassId{static_cast<std::int32_t>(i % 4)};
    detection.z = 2.0;
    table.frames.back().detections.push_back(detection);
  }
  return table;
}

std::vector<topobag::RangedDetection> stressed(const TableStress& stress,
                                               std::size_t count = 20000) {
  NodeTable table = table_of(count);
  apply(stress, table);
  std::vector<topobag::RangedDetection> all;
  for (const FrameRow& frame : table.frames) {
    all.insert(all.end(), frame.detections.begin(), frame.detections.end());
  }
  return all;
}

std::size_t number_of(const topobag::RangedDetection& detection) {
  return static_cast<std::size_t>(std::lround(detection.box.center().x()));
}

TableStress stress_of(double depth_noise, double drop, double flip, std::uint32_t seed = 1) {
  TableStress stress;
  stress.depth_noise = depth_noise;
  stress.drop = drop;
  stress.flip = flip;
  stress.seed = seed;
  return stress;
}

}  // namespace

TEST_CASE("without stress a table stays as it is", "[examples]") {
  const auto detections = stressed({}, 40);
  REQUIRE(detections.size() == 40);
  for (const auto& detection : detections) CHECK(detection.z == 2.0);
}

TEST_CASE("depth noise is normal and grows with the depth", "[examples]") {
  double sum = 0.0, squares = 0.0;
  std::size_t within = 0;
  const auto detections = stressed(stress_of(0.05, 0.0, 0.0));
  REQUIRE(detections.size() == 20000);
  for (const auto& detection : detections) {
    const double noise = (detection.z / 2.0 - 1.0) / 0.05;
    sum += noise;
    squares += noise * noise;
    if (std::abs(noise) < 1.0) ++within;
  }
  CHECK(std::abs(sum / 20000.0) < 0.03);
  CHECK(std::abs(squares / 20000.0 - 1.0) < 0.04);
  CHECK(std::abs(static_cast<double>(within) / 20000.0 - 0.6827) < 0.015);
}

TEST_CASE("an unknown depth stays unknown, and none becomes negative", "[examples]") {
  NodeTable table = table_of(1000);
  for (auto& frame : table.frames) frame.detections[0].z = 0.0;
  apply(stress_of(2.0, 0.0, 0.0), table);
  for (const auto& frame : table.frames) {
    CHECK(frame.detections[0].z == 0.0);
    for (const auto& detection : frame.detections) CHECK(detection.z >= 0.0);
  }
}

TEST_CASE("detections are dropped with the probability asked for", "[examples]") {
  CHECK(std::abs(static_cast<double>(stressed(stress_of(0.0, 0.2, 0.0)).size()) / 20000.0 - 0.8) <
        0.01);
  CHECK(stressed(stress_of(0.0, 1.0, 0.0)).empty());
}

TEST_CASE("a flipped class is any other of the table's, each as often", "[examples]") {
  std::map<std::int32_t, std::size_t> turned;  // by how many classes on
  for (const auto& detection : stressed(stress_of(0.0, 0.0, 0.3))) {
    const auto before = static_cast<std::int32_t>(number_of(detection) % 4);
    ++turned[(topobag::value(detection.label) - before + 4) % 4];
  }
  for (const std::int32_t on : {1, 2, 3}) {
    CHECK(std::abs(static_cast<double>(turned[on]) / 20000.0 - 0.1) < 0.01);
  }
  NodeTable alone = table_of(1);
  apply(stress_of(0.0, 0.0, 1.0), alone);
  CHECK(alone.frames[0].detections[0].label == topobag::ClassId{0});
}

TEST_CASE("one seed gives one stress, and one setting leaves the others' numbers alone",
          "[examples]") {
  const auto all = stressed(stress_of(0.02, 0.0, 0.1));
  std::size_t differ = 0;
  for (const auto& kept : stressed(stress_of(0.02, 0.2, 0.1))) {
    const auto& same = all[number_of(kept)];
    if (kept.z != same.z || kept.label != same.label) ++differ;
  }
  CHECK(differ == 0);
  CHECK(stressed(stress_of(0.02, 0.0, 0.0, 1))[0].z != stressed(stress_of(0.02, 0.0, 0.0, 2))[0].z);
  TableStress other = stress_of(0.02, 0.0, 0.0, 1);
  other.stream = 1;
  CHECK(stressed(other)[0].z != stressed(stress_of(0.02, 0.0, 0.0, 1))[0].z);
}

TEST_CASE("the first numbers of a seed, which no platform may change", "[examples]") {
  const auto detections = stressed(stress_of(0.1, 0.0, 0.0), 3);
  CHECK(detections[0].z == Approx(1.74672013586334).epsilon(1e-12));
  CHECK(detections[1].z == Approx(2.50514394646651).epsilon(1e-12));
  CHECK(detections[2].z == Approx(1.92283500229587).epsilon(1e-12));
}
