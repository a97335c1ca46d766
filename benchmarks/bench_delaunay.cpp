// SPDX-License-Identifier: MIT
// What do canonical Delaunay edges cost beside CGAL itself?
//
// For each n: many different random layouts in a 640 x 480 image (few would be learnt by the branch
// predictor), in batches; each batch goes through `DelaunayEdges2` and through plain CGAL, first
// one and then the other in turn. CGAL gets points in the same order and collects its finite edges
// in a vector; of its two ways, point by point and as a range (which sorts them in space), the
// faster counts. Figures are medians over the batches, ns a layout; the ratio is the median of the
// batches' ratios, so that a noisy neighbour slows both sides alike.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <random>
#include <vector>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <topobag/edges/delaunay_edges2.hpp>

namespace {

using Nodes = std::vector<topobag::SemanticNode<>>;
using Triangulation =
    CGAL::Delaunay_triangulation_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Points = std::vector<Triangulation::Point>;

std::size_t ours(const Nodes& nodes) { return topobag::DelaunayEdges2{}(nodes).size(); }

std::size_t collect_edges(const Triangulation& triangulation, std::size_t n) {
  std::vector<Triangulation::Edge> edges;
  edges.reserve(3 * n);
  for (const auto& edge : triangulation.finite_edges()) edges.push_back(edge);
  return edges.size();
}

std::size_t cgal_one_by_one(const Points& points) {
  Triangulation triangulation;
  for (const auto& point : points) triangulation.insert(point);
  return collect_edges(triangulation, points.size());
}

std::size_t cgal_range(const Points& points) {
  Triangulation triangulation;
  triangulation.insert(points.begin(), points.end());
  return collect_edges(triangulation, points.size());
}

/// Time a layout, ns; adds the number of edges to `edges`.
template <typename Layout, typename Run>
double time_of(const std::vector<Layout>& layouts, std::size_t begin, std::size_t end, Run run,
               std::size_t& edges) {
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = begin; i < end; ++i) edges += run(layouts[i]);
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / static_cast<double>(end - begin);
}

/// Reads every input once, so that both sides find it in the cache where it fits.
double sum_of_u(const Nodes& nodes, const Points& points) {
  double sum = 0.0;
  for (const auto& node : nodes) sum += node.pixel->x();
  for (const auto& point : points) sum += point.x();
  return sum;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool compare(std::size_t n, std::mt19937_64& random) {
  const std::size_t batches = n >= 100000 ? 9 : 240;
  const std::size_t batch = std::max<std::size_t>(1, 2000 / n);
  std::uniform_real_distribution<double> u(0.0, 640.0), v(0.0, 480.0);
  std::vector<Nodes> nodes(batches * batch, Nodes(n));
  std::vector<Points> points(batches * batch);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (auto& node : nodes[i]) {
      node.pixel = Eigen::Vector2d(u(random), v(random));
      points[i].emplace_back(node.pixel->x(), node.pixel->y());
    }
  }

  std::vector<double> ours_ns, one_by_one_ns, range_ns;
  double cached = 0.0;
  std::size_t our_edges = 0, cgal_edges = 0, range_edges = 0;
  for (std::size_t b = 0; b < batches; ++b) {
    const std::size_t begin = b * batch, end = begin + batch;
    for (std::size_t i = begin; i < end; ++i) cached += sum_of_u(nodes[i], points[i]);
    const auto run_ours = [&] { ours_ns.push_back(time_of(nodes, begin, end, ours, our_edges)); };
    const auto run_one_by_one = [&] {
      one_by_one_ns.push_back(time_of(points, begin, end, cgal_one_by_one, cgal_edges));
    };
    const auto run_range = [&] {
      range_ns.push_back(time_of(points, begin, end, cgal_range, range_edges));
    };
    if (b % 3 == 0) {
      run_ours();
      run_one_by_one();
      run_range();
    }
    if (b % 3 == 1) {
      run_one_by_one();
      run_range();
      run_ours();
    }
    if (b % 3 == 2) {
      run_range();
      run_ours();
      run_one_by_one();
    }
  }
  const bool range_wins = median(range_ns) < median(one_by_one_ns);
  const std::vector<double>& cgal_ns = range_wins ? range_ns : one_by_one_ns;
  std::vector<double> ratios;
  for (std::size_t b = 0; b < batches; ++b) ratios.push_back(ours_ns[b] / cgal_ns[b]);
  const double ratio = median(ratios);
  std::printf("%8zu %10zu %14.0f %14.0f %14.0f %7.2f\n", n, nodes.size(), median(ours_ns),
              median(one_by_one_ns), median(range_ns), ratio);
  std::printf(
      "{\"bench\":\"delaunay\",\"n\":%zu,\"ours_ns\":%.0f,\"cgal_ns\":%.0f,\"ratio\":%.3f}\n", n,
      median(ours_ns), median(cgal_ns), ratio);
  return our_edges == cgal_edges && cgal_edges == range_edges && cached > 0.0;
}

}  // namespace

int main() {
  std::mt19937_64 random(1);
  std::printf("%8s %10s %14s %14s %14s %7s\n", "n", "layouts", "ours, ns", "CGAL, ns",
              "CGAL range, ns", "ratio");
  for (const std::size_t n : {5u, 10u, 20u, 50u, 100u, 1000u, 100000u}) {
    if (!compare(n, random)) {
      std::fprintf(stderr, "The numbers of edges differ at n = %zu.\n", n);
      return 1;
    }
  }
}
