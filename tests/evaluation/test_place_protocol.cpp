// SPDX-License-Identifier: MIT
#include <limits>

#include <topobag/evaluation/place_protocol.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

PlaceProtocol by_distance(double distance_m) {
  PlaceProtocol protocol;
  protocol.distance_m = distance_m;
  return protocol;
}

PairRelation relation(const PlaceProtocol& protocol, double distance_m, double angle_deg = 0.0) {
  protocol.validate();
  return relation_by_distance(protocol, distance_m, [&] { return angle_deg; });
}

}  // namespace

TEST_CASE("a distance alone leaves no band", "[evaluation]") {
  const PlaceProtocol protocol = by_distance(3.0);
  CHECK(relation(protocol, 3.0, 180.0) == PairRelation::positive);
  CHECK(relation(protocol, 3.001) == PairRelation::negative);
}

TEST_CASE("distance, angle and the band between", "[evaluation]") {
  PlaceProtocol protocol = by_distance(0.5);
  protocol.angle_deg = 30.0;
  CHECK(relation(protocol, 0.5, 30.0) == PairRelation::positive);
  CHECK(relation(protocol, 0.5, 30.1) == PairRelation::negative);
  protocol.negative_distance_m = 1.0;
  CHECK(relation(protocol, 0.9, 0.0) == PairRelation::ignored);
  CHECK(relation(protocol, 1.0, 0.0) == PairRelation::negative);
  CHECK(relation(protocol, 0.1, 170.0) == PairRelation::ignored);
  protocol.negative_angle_deg = 45.0;
  CHECK(relation(protocol, 0.1, 45.0) == PairRelation::negative);
  CHECK(relation(protocol, 0.1, 44.0) == PairRelation::ignored);
}

TEST_CASE("limits that coincide make the pair positive", "[evaluation]") {
  PlaceProtocol protocol = by_distance(3.0);
  protocol.negative_distance_m = 3.0;
  CHECK(relation(protocol, 3.0) == PairRelation::positive);
}

TEST_CASE("covisibility turns the limits round", "[evaluation]") {
  PlaceProtocol protocol;
  protocol.covisibility = 0.3;
  CHECK(relation_by_covisibility(protocol, 0.3) == PairRelation::positive);
  CHECK(relation_by_covisibility(protocol, 0.29) == PairRelation::negative);
  protocol.negative_covisibility = 0.1;
  CHECK(relation_by_covisibility(protocol, 0.29) == PairRelation::ignored);
  CHECK(relation_by_covisibility(protocol, 0.1) == PairRelation::negative);
}

TEST_CASE("a protocol that contradicts itself is refused", "[evaluation]") {
  const auto refused = [](auto&& change) {
    PlaceProtocol protocol = by_distance(1.0);
    change(protocol);
    CHECK_THROWS_AS(protocol.validate(), InvalidValue);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](PlaceProtocol& p) { p.distance_m.reset(); });
  refused([](PlaceProtocol& p) { p.covisibility = 0.5; });
  refused([](PlaceProtocol& p) { p.distance_m = -1.0; });
  refused([&](PlaceProtocol& p) { p.distance_m = nan; });
  refused([](PlaceProtocol& p) { p.distance_m = std::numeric_limits<double>::infinity(); });
  refused([](PlaceProtocol& p) { p.angle_deg = 181.0; });
  refused([](PlaceProtocol& p) { p.negative_distance_m = 0.9; });
  refused([](PlaceProtocol& p) { p.negative_angle_deg = 45.0; });
  refused([](PlaceProtocol& p) { p.frustum = DepthFrustum{}; });
  refused([](PlaceProtocol& p) { p.negative_covisibility = 0.1; });
  refused([&](PlaceProtocol& p) { p.exclude_seconds = nan; });
  refused([](PlaceProtocol& p) {
    p.angle_deg = 30.0;
    p.negative_angle_deg = 20.0;
  });
  refused([](PlaceProtocol& p) {
    p.distance_m.reset();
    p.covisibility = 0.5;
  });
}
