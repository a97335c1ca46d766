// SPDX-License-Identifier: MIT
#include <topobag/evaluation/protocol_text.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a protocol is written as it is read", "[evaluation]") {
  for (const std::string text :
       {"distance=3", "distance=0.5,angle=30,negative-distance=1,negative-angle=45",
        "distance=25,exclude-seconds=12.5,exclude-frames=100,past-only",
        "covisibility=0.3,negative-covisibility=0.1,frustum=517.3:516.5:318.6:255.3:640:480:0.5:"
        "4"}) {
    CHECK(to_string(parse_protocol(text)) == text);
  }
  const PlaceProtocol protocol = parse_protocol(" angle=15 , distance = 0.1 ,past-only");
  CHECK(*protocol.distance_m == 0.1);
  CHECK(*protocol.angle_deg == 15.0);
  CHECK(protocol.past_only);
  CHECK_FALSE(protocol.negative_distance_m);
}

TEST_CASE("a text that is no protocol is refused", "[evaluation]") {
  for (const char* text :
       {"", "distance", "distance=", "distance=3m", "distance=nan", "distance=3,", "dist=3",
        "distance=3,past-only=1", "distance=3,exclude-frames=1.5", "distance=3,exclude-frames=-1",
        "covisibility=0.3", "covisibility=0.3,frustum=1:2:3", "angle=30",
        "covisibility=0.3,frustum=517.3:516.5:318.6:255.3:640:480:0.5:4:9",
        "distance=0.5,distance=0.6", "distance=0.5,distance=0.5",
        "past-only,distance=3,past-only"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_protocol(text), InvalidValue);
  }
}
