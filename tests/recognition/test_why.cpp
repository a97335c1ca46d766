// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>
#include <string>

#include <topobag/recognition/relocalizer.hpp>
#include <topobag/recognition/why.hpp>

#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

TEST_CASE("one line tells why, and names the key frame and the verdict", "[recognition]") {
  std::mt19937 random(7);
  std::size_t recognised = 0, refused = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Relocalizer<> relocalizer;
    const SyntheticRoom room(seed, 3 + seed % 5, 3);
    relocalizer.map().add(KeyframeId{40}, room.seen_from(random_camera(random)));
    const bool same = seed % 2 == 0;
    const SyntheticRoom other(seed + 100, 3 + seed % 5, 3);
    const auto query = (same ? room : other).seen_from(random_camera(random));
    const Recognition found = relocalizer.localize(query);
    const std::string line =
        why(found, [](KeyframeId id) { return "frame <" + std::to_string(value(id)) + ">"; });
    CAPTURE(line);
    CHECK(std::count(line.begin(), line.end(), '\n') == 0);
    if (found.candidates.empty()) {
      CHECK(line == "not recognised: there is nothing to compare with");
      continue;
    }
    CHECK(line.find("frame <40>") != std::string::npos);
    if (found) {
      CHECK(line.rfind("recognised ", 0) == 0);
      ++recognised;
    } else {
      CHECK(line.rfind("not recognised", 0) == 0);
      CHECK(line.find(to_string(found.candidates.front().verdict)) != std::string::npos);
      ++refused;
    }
  }
  CHECK(recognised > 0);
  CHECK(refused > 0);
}

TEST_CASE("one line names the other place that fits about as well", "[recognition]") {
  std::mt19937 random(8);
  const SyntheticRoom room(3, 8, 4);
  Relocalizer<> relocalizer;
  for (const double x : {0.0, 50.0}) {
    const Eigen::Isometry3d camera = random_camera(random);
    relocalizer.map().add(KeyframeId{x == 0.0 ? 1u : 2u}, room.seen_from(camera),
                          standing_at(Eigen::Translation3d(x, 0.0, 0.0) * camera));
  }
  const Recognition found = relocalizer.localize(room.seen_from(random_camera(random)));
  REQUIRE_FALSE(found);
  const std::string line = why(found);
  CAPTURE(line);
  CHECK(line.find("another place fits about as well (key frame ") != std::string::npos);
}

TEST_CASE("one line tells what cannot be looked up", "[recognition]") {
  CHECK(why(Relocalizer<>().localize(TopologyGraph<>())) ==
        "not recognised: a query takes three objects with a position");
}
