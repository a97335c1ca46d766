// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include <topobag/matching/detail/real_roots.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// The monic polynomial of four roots.
detail::Quartic with_roots(const std::array<double, 4>& roots) {
  detail::Quartic p{1.0, 0.0, 0.0, 0.0, 0.0};
  for (const double root : roots) {
    for (std::size_t i = p.size(); i-- > 1;) p[i] = p[i - 1] - root * p[i];
    p[0] *= -root;
  }
  return p;
}

}  // namespace

TEST_CASE("every root of a quartic in the interval is found", "[real_roots]") {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (int round = 0; round < 5000; ++round) {
    std::array<double, 4> roots{};
    for (double& root : roots) root = any(random);
    std::sort(roots.begin(), roots.end());
    double closest = 1.0;
    for (std::size_t i = 1; i < 4; ++i) closest = std::min(closest, roots[i] - roots[i - 1]);
    if (closest < 1e-2) continue;  // ill-conditioned
    const detail::Roots found = detail::real_roots(with_roots(roots), 0.1, 2.0);
    std::size_t expected = 0;
    for (const double root : roots) {
      if (root <= 0.1 || root >= 2.0) continue;
      REQUIRE(expected < found.size);
      CHECK(std::abs(found.x[expected] - root) < 1e-7);
      ++expected;
    }
    CHECK(found.size == expected);
  }
}

TEST_CASE("a double root is found, and none where there is none", "[real_roots]") {
  const detail::Roots twice = detail::real_roots(with_roots({0.5, 0.5, -1.0, -2.0}), 0.1, 2.0);
  REQUIRE(twice.size >= 1);
  for (const double root : twice) CHECK(std::abs(root - 0.5) < 1e-6);
  CHECK(detail::real_roots({1.0, 0.0, 1.0, 0.0, 1.0}, 0.1, 2.0).size == 0);
  CHECK(detail::real_roots({0.0, 0.0, 0.0, 0.0, 0.0}, 0.1, 2.0).size <= 4);
  const detail::Roots line = detail::real_roots({-1.0, 1.0, 0.0, 0.0, 0.0}, 0.1, 2.0);
  REQUIRE(line.size == 1);
  CHECK(line.x[0] == Approx(1.0));
}
