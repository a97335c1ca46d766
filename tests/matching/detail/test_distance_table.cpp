// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>

#include <topobag/matching/detail/distance_table.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

TEST_CASE("a distance table holds each distance and its variance", "[matching]") {
  std::mt19937 random(62);
  auto nodes = noisy_graph(random, 9, 3).nodes();
  nodes[4].position.reset();
  nodes[7].position = nodes[2].position;
  const detail::DistanceTable table{TopologyGraph<>(nodes)};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const detail::Distance& distance = table.row(i)[j];
      if (i == j || !nodes[i].position || !nodes[j].position) {
        CHECK(distance.length == 0.0);
        continue;
      }
      const Eigen::Vector3d line = *nodes[i].position - *nodes[j].position;
      const Eigen::Matrix3d covariance = nodes[i].covariance + nodes[j].covariance;
      CHECK(distance.length == Approx(line.norm()));
      CHECK(distance.variance ==
            Approx(line.isZero(0.0) ? covariance.trace() / 3.0
                                    : line.normalized().dot(covariance * line.normalized())));
    }
  }
}
