// SPDX-License-Identifier: MIT
// Insertions, removals and look-ups in any order: the triangulation stays one, and is the one that
// its vertices give at once.
#include <vector>

#include <topobag/edges/delaunay_triangulation.hpp>

#include "fuzz/fuzz_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  topobag::DelaunayTriangulation<Eigen::Vector2d> triangulation;
  const auto place = [&]() -> Eigen::Vector2d {
    if (input.below(8) == 0) return {input.number(), input.number()};
    const double x = input.below(16), y = input.below(16);
    return {x, y};
  };
  while (!input.empty() && triangulation.size() < 64) {
    const std::vector<topobag::NodeIndex> there = triangulation.vertices();
    const int step = input.below(4);
    try {
      if (step == 0 && !there.empty()) {
        triangulation.remove(there[input.byte() % there.size()]);
      } else if (step == 1) {
        triangulation.nearest_neighbor(place());
        triangulation.locate(place());
      } else {
        triangulation.insert(place());
      }
    } catch (const topobag::Error&) {
      require(triangulation.vertices() == there, "a refused position changes nothing");
    }
    require(triangulation.is_valid(), "a triangulation");
  }
  return 0;
}
