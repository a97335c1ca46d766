// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/detail/codec/gravity_code.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// Directions of all kinds: anywhere, along the axes, in the planes between them, and just beside.
std::vector<Eigen::Vector3d> directions_of_all_kinds() {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> directions;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Eigen::Vector3d exact(x, y, z);
        directions.push_back(exact);
        directions.push_back(-exact);  // with zeros of the other sign
        for (const double off : {1e-17, 1e-9, 3e-5, 1e-3}) {
          const Eigen::Vector3d aside(normal(random), normal(random), normal(random));
          directions.push_back(exact + off * aside);
        }
      }
    }
  }
  for (int i = 0; i < 20000; ++i) {
    directions.emplace_back(normal(random), normal(random), normal(random));
  }
  for (int i = 0; i < 2000; ++i) directions.emplace_back(normal(random), 0.0, normal(random));
  for (int i = 0; i < 2000; ++i) directions.emplace_back(normal(random), normal(random), -0.0);
  for (Eigen::Vector3d& direction : directions) direction.normalize();
  return directions;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Gravity<> there_and_back(const Gravity<>& gravity) {
  detail::BitWriter writer;
  detail::put_gravity(writer, gravity);
  const std::vector<std::uint8_t> bytes = writer.take();
  detail::BitReader reader(bytes.data(), bytes.size());
  return detail::get_gravity<double>(reader);
}

}  // namespace

TEST_CASE("a direction comes back within 0.3 mrad", "[bag][gravity]") {
  double worst = 0.0;
  for (const Eigen::Vector3d& direction : directions_of_all_kinds()) {
    const Eigen::Vector3d back = detail::direction_at(detail::octahedron_place(direction));
    CHECK(back.norm() == Approx(1.0));
    worst = std::max(worst, angle_between(direction, back));
  }
  CHECK(worst < 0.3e-3);
  CHECK(worst > 0.15e-3);
}

TEST_CASE("axes come back exactly", "[bag][gravity]") {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      Eigen::Vector3d direction = Eigen::Vector3d::Zero();
      direction[axis] = sign;
      CHECK(detail::direction_at(detail::octahedron_place(direction)) == direction);
    }
  }
}

TEST_CASE("a direction's place stays when it is rounded again", "[bag][gravity]") {
  for (const Eigen::Vector3d& direction : directions_of_all_kinds()) {
    const detail::OctahedronPlace place = detail::octahedron_place(direction);
    const Eigen::Vector3d back = detail::direction_at(place);
    CHECK(detail::octahedron_place(back) == place);
    CHECK(detail::octahedron_place(back.cast<float>().cast<double>()) == place);
  }
}

TEST_CASE("a place of the border is the same on either side of its middle", "[bag][gravity]") {
  const std::int64_t n = detail::octahedron_steps;
  for (const std::int64_t side : {-n, n}) {
    for (const std::int64_t y : {std::int64_t{0}, std::int64_t{1}, std::int64_t{4000}, n}) {
      CHECK(detail::direction_at({side, y}).isApprox(detail::direction_at({side, -y})));
      CHECK(detail::direction_at({y, side}).isApprox(detail::direction_at({-y, side})));
    }
  }
}

TEST_CASE("a direction of the border has one place, whatever the sign of its zero",
          "[bag][gravity]") {
  for (const double other : {-1.0, -0.3, 0.3, 1.0}) {
    for (const double nothing : {0.0, 1e-17}) {
      CHECK(detail::octahedron_place({nothing, other, -1.0}) ==
            detail::octahedron_place({-nothing, other, -1.0}));
      CHECK(detail::octahedron_place({other, nothing, -1.0}) ==
            detail::octahedron_place({other, -nothing, -1.0}));
    }
  }
  CHECK(detail::octahedron_place({-0.0, -0.0, -1.0}) ==
        detail::OctahedronPlace(detail::octahedron_steps, detail::octahedron_steps));
}

TEST_CASE("gravity's deviation comes back within 4.5 %, or at the end of its range",
          "[bag][gravity]") {
  for (double deviation = 0.00025; deviation < 14.0; deviation *= 1.01) {
    CHECK(there_and_back({{0, 1, 0}, deviation}).deviation == Approx(deviation).epsilon(0.045));
  }
  CHECK(there_and_back({{0, 1, 0}, 1e-300}).deviation == Approx(0.000244140625));
  CHECK(there_and_back({{0, 1, 0}, 1e300}).deviation == Approx(14.672));
}

TEST_CASE("a gravity that no encoder wrote is refused", "[bag][gravity]") {
  detail::BitWriter writer;
  writer.put((1U << 14) - 1, 14);
  writer.put(0, 21);
  const std::vector<std::uint8_t> bytes = writer.take();
  detail::BitReader reader(bytes.data(), bytes.size());
  CHECK_THROWS_AS(detail::get_gravity<double>(reader), FormatError);
  detail::BitReader short_reader(bytes.data(), 4);
  CHECK_THROWS_AS(detail::get_gravity<double>(short_reader), FormatError);
}
