// SPDX-License-Identifier: MIT
#include <cstddef>
#include <thread>
#include <utility>
#include <vector>

#include <topobag/edges/delaunay_triangulation.hpp>

#include "catch.hpp"
#include "edges/planar_layouts.hpp"
#include "edges/planar_triangulations.hpp"
#include "edges/planar_truth.hpp"

using namespace topobag;
using namespace layouts;

TEMPLATE_TEST_CASE("copies share nothing, and a moved-from triangulation is empty",
                   "[edges][delaunay]", LastUsedVertexHint, HierarchyHint) {
  Random random(16);
  using Triangulation = DelaunayTriangulation<Eigen::Vector2d, TestType>;
  Triangulation original;
  original.bulk_load(positions(scattered(random, 400, 100)));
  const EdgeList edges = original.undirected_edges();

  Triangulation copy(original);
  CHECK(copy.undirected_edges() == edges);
  const NodeIndex some = copy.vertices().front();
  copy.remove(some);
  copy.insert({1000, 1000});
  CHECK(copy.is_valid());
  CHECK(original.is_valid());
  CHECK(original.undirected_edges() == edges);

  Triangulation moved(std::move(original));
  CHECK(moved.undirected_edges() == edges);
  CHECK(original.empty());
  CHECK(original.is_valid());
  CHECK(original.insert({1, 2}) == node_index(0));

  copy = moved;
  CHECK(copy.undirected_edges() == edges);
  const Triangulation& self = copy;
  copy = self;
  CHECK(copy.undirected_edges() == edges);
  original = std::move(moved);
  CHECK(original.undirected_edges() == edges);
  CHECK(original.is_valid());
  CHECK(moved.is_valid());
  original.remove(some);
  CHECK(original.is_valid());
}

TEST_CASE("any number of threads may ask at once", "[edges][delaunay]") {
  Random random(17);
  Planar triangulation;
  triangulation.bulk_load(positions(without_duplicates(scattered(random, 2000, 1000))));
  const Planar& shared = triangulation;
  std::vector<Eigen::Vector2d> queries;
  for (int i = 0; i < 1000; ++i) queries.push_back(scaled(random_point(random, 1100), 0));
  const auto answers = [&] {
    std::vector<std::size_t> result;
    for (const auto& query : queries) {
      result.push_back(value(*shared.nearest_neighbor(query)));
      result.push_back(shared.locate(query).index());
      result.push_back(shared.neighbors(node_index(result.size() % shared.size())).size());
    }
    result.push_back(shared.undirected_edges().size());
    result.push_back(shared.convex_hull().size());
    result.push_back(shared.is_valid());
    return result;
  };
  std::vector<std::vector<std::size_t>> results(5);
  std::vector<std::thread> threads;
  for (std::size_t t = 1; t < results.size(); ++t) {
    threads.emplace_back([&, t] { results[t] = answers(); });
  }
  for (std::thread& thread : threads) thread.join();
  results[0] = answers();
  for (const auto& result : results) CHECK(result == results[0]);
}
