// SPDX-License-Identifier: MIT
// The numbers of examples/docs/data_walk.md that the program does not print.
#include <cmath>
#include <vector>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/graph/correlation_matrix.hpp>
#include <topobag/graph/topology_weight.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/types/ranged_detection.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("frame 41 of fr1_rpy gives the numbers of the page", "[docs][delaunay]") {
  const auto box = [](double u, double v, double width, double height) {
    return box_around({u, v}, width, height);
  };
  const ClassId tv{62}, keyboard{66}, cup{41}, mouse{64}, book{73}, chair{56};
  const std::vector<RangedDetection> detections{
      {box(462.3, 153.5, 321.5, 263.6), tv, 0.869, 0.918},
      {box(434.3, 398.2, 269.7, 107.9), keyboard, 0.846, 0.940},
      {box(302.9, 283.5, 47.0, 63.2), cup, 0.786, 0.996},
      {box(558.9, 364.0, 52.0, 53.4), mouse, 0.785, 1.067},
      {box(622.8, 357.5, 31.7, 65.0), mouse, 0.379, 0.000},
      {box(75.6, 130.9, 131.3, 77.8), book, 0.317, 1.261},
      {box(53.7, 197.1, 107.2, 74.0), book, 0.215, 1.126},
      {box(139.9, 36.6, 126.1, 66.3), chair, 0.129, 2.491},
      {box(177.4, 205.6, 79.2, 108.1), book, 0.114, 1.005}};
  const PinholeCamera<> camera{517.3, 516.5, 318.6, 255.3, 640, 480};
  const auto lifted = lift_detections(detections, camera, ClassCatalog::coco80());
  CHECK(lifted.dropped.low_confidence == 3);
  CHECK(lifted.dropped.no_depth == 1);
  REQUIRE(lifted.nodes.size() == 5);

  const SemanticNode<>& first = lifted.nodes[0];
  CHECK(first.position->isApprox(Eigen::Vector3d(0.255, -0.181, 0.918), 1e-3));
  CHECK(first.size.isApprox(Eigen::Vector2d(0.571, 0.469), 1e-3));
  const Eigen::Vector3d along = first.position->normalized();
  const Eigen::Vector3d across = along.unitOrthogonal();
  CHECK(std::sqrt(along.dot(first.covariance * along)) == Approx(0.053).epsilon(0.01));
  CHECK(std::sqrt(across.dot(first.covariance * across)) == Approx(0.033).epsilon(0.02));

  const TopologyGraph<> graph = make_topology_graph(lifted.nodes, DelaunayEdges2<>{});
  CHECK(graph.edges().size() == 8);
  Eigen::Matrix<double, 5, 5> D;
  D << 1, 0.444, 0.378, 0.495, 0.922,  //
      0.444, 1, 0.321, 0.314, 1.032,   //
      0.378, 0.321, 1, 0, 0.717,       //
      0.495, 0.314, 0, 1, 0,           //
      0.922, 1.032, 0.717, 0, 1;
  CHECK((correlation_matrix(graph) - D).cwiseAbs().maxCoeff() < 6e-4);
  const Eigen::Vector4d row = topology_weight(graph, 1.0).row(0);
  CHECK((row - Eigen::Vector4d(1115.6, 738.1, 3.4, 205.8)).cwiseAbs().maxCoeff() < 0.06);
  CHECK(encode(graph).size() == 78);
}
