// SPDX-License-Identifier: MIT
#include "box_reach.hpp"

#include <algorithm>
#include <random>
#include <string>

#include "catch.hpp"

namespace {

/// What is said of 400 boxes of an image as `write` puts each down.
template <typename Write>
std::string said_of_reach(std::uint32_t seed, const Write& write) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  program::BoxReach reach(640, 480);
  for (int i = 0; i < 400; ++i) {
    const double w = 40.0 + 400.0 * share(random), h = 20.0 + 100.0 * share(random);
    const double x = share(random) * (640.0 - w), y = share(random) * (480.0 - h);
    reach.add(write(x, y, w, h));
  }
  return reach.complaint("a form");
}

}  // namespace

TEST_CASE("boxes that are written in another form reach beyond their image",
          "[examples][regression]") {
  using topobag::box_around;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const auto right = [](double x, double y, double w, double h) {
      return box_around({x + 0.5 * w, y + 0.5 * h}, w, h);
    };
    const auto swapped = [](double x, double y, double w, double h) {
      return box_around({x + 0.5 * w, y + 0.5 * h}, h, w);
    };
    const auto by_corner = [](double x, double y, double w, double h) {
      return box_around({x, y}, w, h);
    };
    const auto corners = [](double x, double y, double w, double h) {
      return box_around({x, y}, x + w, y + h);
    };
    CHECK(said_of_reach(seed, right).empty());
    const std::string told = said_of_reach(seed, swapped);
    CHECK(told.find(" of 400 boxes reach far beyond the image; a form: are width and height the "
                    "other way round?") != std::string::npos);
    for (const std::string& said : {said_of_reach(seed, by_corner), said_of_reach(seed, corners)}) {
      CHECK(said.find(" of 400 boxes reach far beyond the image; a form") != std::string::npos);
    }
  }
}

TEST_CASE("a few boxes beyond their image are a detector's", "[examples]") {
  program::BoxReach reach(640, 480);
  for (int i = 0; i < 96; ++i) reach.add({10.0, 10.0, 600.0, 400.0});
  for (int i = 0; i < 4; ++i) reach.add({10.0, 10.0, 900.0, 400.0});
  CHECK(reach.complaint("a form").empty());
  for (int i = 0; i < 2; ++i) reach.add({10.0, 10.0, 900.0, 400.0});
  CHECK(reach.complaint("a form") == "6 of 102 boxes reach far beyond the image; a form");
  program::BoxReach unknown(0, 0);
  for (int i = 0; i < 100; ++i) unknown.add({10.0, 10.0, 900.0, 400.0});
  CHECK(unknown.complaint("a form").empty());
}
