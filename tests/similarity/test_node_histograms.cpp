// SPDX-License-Identifier: MIT
#include <topobag/similarity/node_histograms.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const SparseHistogram x({{1, 2.0}}), y({{2, 1.0}}), diagonal({{1, 3.0}, {2, 4.0}});

NodeHistograms graph(std::vector<std::pair<ClassId, SparseHistogram>> nodes) {
  return NodeHistograms(std::move(nodes));
}

}  // namespace

TEST_CASE("nodes are kept in an order of their own, histograms at length 1", "[similarity]") {
  const NodeHistograms p = graph({{ClassId{2}, y}, {ClassId{1}, diagonal}, {ClassId{1}, x}});
  CHECK(p.labels() == std::vector<ClassId>{ClassId{1}, ClassId{1}, ClassId{2}});
  CHECK(p.histograms()[0].entries()[0].weight == 1.0);
  CHECK(dot(p.histograms()[1], p.histograms()[1]) == Approx(1.0));
}

TEST_CASE("the assigned cosine on hand-computed numbers", "[similarity]") {
  // Cosines: x·x = 1, x·diagonal = .6, y·diagonal = .8, y·x = 0. The best total is 1 + .8.
  const NodeHistograms p = graph({{ClassId{1}, x}, {ClassId{1}, y}});
  const NodeHistograms q = graph({{ClassId{1}, diagonal}, {ClassId{1}, x}, {ClassId{2}, y}});
  CHECK(assigned_cosine(p, q) == Approx(1.8 / 3.0));
  CHECK(assigned_cosine(p, graph({{ClassId{1}, diagonal}})) == Approx(0.8 / 2.0));

  ClassWeights weights;
  weights.set(ClassId{1}, 2.0);
  CHECK(assigned_cosine(p, q, weights) == Approx(2.0 * 1.8 / 5.0));
  weights.set(ClassId{1}, 0.0);
  CHECK(assigned_cosine(p, p, weights) == 0.0);
}

TEST_CASE("two nodes of a class without surroundings are alike", "[similarity]") {
  const NodeHistograms lonely = graph({{ClassId{1}, SparseHistogram{}}});
  CHECK(assigned_cosine(lonely, lonely) == 1.0);
  CHECK(assigned_cosine(lonely, graph({{ClassId{1}, x}})) == 0.0);
  CHECK(assigned_cosine(lonely, graph({{ClassId{2}, SparseHistogram{}}})) == 0.0);
}
