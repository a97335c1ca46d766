// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/similarity/class_histogram.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>
#include <topobag/similarity/padded_cosine.hpp>

#include "catch.hpp"
#include "node_table.hpp"

using namespace topobag;

namespace {

struct Place {
  TopologyGraph<> graph;
  Eigen::Isometry3d T_world_camera;
  double stamp;  ///< s
};

/// Every twelfth frame of TUM fr3_long_office, with nodes.
std::vector<Place> long_office(const std::string& data) {
  const ClassCatalog classes = ClassCatalog::coco80();
  const auto table =
      program::read_node_table(data + "/nodes/fr3_long_office.eao_yolo_tri", classes);
  const PinholeCamera<double> kinect{535.4, 539.2, 320.1, 247.6, 640, 480};
  std::vector<Place> places;
  for (std::size_t i = 0; i < table.frames.size(); i += 12) {
    const program::FrameRow& frame = table.frames[i];
    auto nodes = lift_detections(frame.detections, kinect, classes).nodes;
    if (nodes.empty()) continue;
    places.push_back({make_topology_graph(std::move(nodes), KnnEdges{}), *frame.T_world_camera,
                      frame.timestamp});
  }
  return places;
}

/// Average precision over all pairs more than 20 s apart: positive up to 0.5 m and 30°, negative
/// beyond 1 m or 45°.
template <typename Similarity>
double average_precision(const std::vector<Place>& places, const Similarity& similarity) {
  std::vector<std::pair<double, bool>> pairs;
  std::size_t positives = 0;
  for (const Place& p : places) {
    for (const Place& q : places) {
      if (q.stamp - p.stamp < 20.0) continue;
      const Eigen::Isometry3d T_p_q = p.T_world_camera.inverse() * q.T_world_camera;
      const double metres = T_p_q.translation().norm();
      const double degrees = Eigen::AngleAxisd(T_p_q.linear()).angle() * 180.0 / 3.14159265358979;
      const bool positive = metres <= 0.5 && degrees <= 30.0;
      if (!positive && metres <= 1.0 && degrees <= 45.0) continue;
      pairs.emplace_back(similarity(p.graph, q.graph), positive);
      positives += positive ? 1U : 0U;
    }
  }
  REQUIRE(positives > 0);
  std::sort(pairs.begin(), pairs.end());  // of equal scores the negatives count first
  double sum = 0.0;
  std::size_t found = 0;
  for (std::size_t rank = 1; rank <= pairs.size(); ++rank) {
    if (!pairs[pairs.size() - rank].second) continue;
    ++found;
    sum += static_cast<double>(found) / static_cast<double>(rank);
  }
  return sum / static_cast<double>(positives);
}

}  // namespace

TEST_CASE("similarities on real detections", "[similarity][data]") {
  const char* const data = std::getenv("TOPOBAG_DATA");
  if (data == nullptr) {
    std::cout << "Skips the similarities on real detections: TOPOBAG_DATA is not set.\n";
    return;
  }
  const std::vector<Place> places = long_office(data);

  SECTION("the paper's padded cosine is nearly a node count") {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Place& p : places) {
      for (const Place& q : places) {
        const auto n = static_cast<double>(p.graph.size());
        const auto k = static_cast<double>(q.graph.size());
        sum += std::abs(PaddedCosine{}(p.graph, q.graph) - std::min(n, k) / std::max(n, k));
        ++count;
      }
    }
    CHECK(sum / static_cast<double>(count) < 0.05);
  }

  SECTION("classes tell more than the padded cosine, classes with distances more than classes") {
    const double padded = average_precision(places, PaddedCosine{});
    const double classes = average_precision(places, ClassHistogram{});
    const double distances = average_precision(places, ClassPairDistanceHistogram{});
    CHECK(classes > 2.0 * padded);
    CHECK(distances > 1.3 * classes);
  }
}
