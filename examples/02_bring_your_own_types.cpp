// SPDX-License-Identifier: MIT
// A front end with types of its own: detections, depth images, classes, edges. Nothing is copied
// into types of the library, nothing inherits.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <vector>

#include <topobag/recognition/loop_detector.hpp>
#include <topobag/sensing/lift_detections.hpp>

// ---- The front end's own
// -------------------------------------------------------------------------

namespace plant {

/// A detector's output: centre and size relative to the image, an index into its names.
struct YoloBox {
  float cx, cy, w, h;
  int name;
  float score;
};

const std::vector<const char*> names{"valve", "gauge", "pump", "hand wheel", "worker"};

/// A depth image in metres, from the upper-left corner; NaN where nothing was measured.
class DepthImage {
 public:
  DepthImage(int width, int height)
      : width_(width), metres_(static_cast<std::size_t>(width * height), std::nanf("")) {}

  float& at(int x, int y) { return metres_[static_cast<std::size_t>(y * width_ + x)]; }
  float at(int x, int y) const { return metres_[static_cast<std::size_t>(y * width_ + x)]; }

 private:
  int width_;
  std::vector<float> metres_;
};

const int width = 640;
const int height = 480;

struct Frame {
  double stamp;
  std::vector<YoloBox> boxes;
  DepthImage depth{width, height};
};

/// Stands in for a detector and a depth camera before a wall of machinery, `shift` m to the left.
Frame take_frame(double stamp, float shift) {
  struct Object {
    float x, y, z;  // m
    int name;
  };
  const std::vector<Object> wall{{-0.9f, -0.4f, 2.5f, 0}, {-0.3f, 0.3f, 2.2f, 1},
                                 {0.1f, -0.5f, 2.8f, 2},  {0.6f, 0.4f, 2.4f, 3},
                                 {0.9f, -0.3f, 2.6f, 1},  {-0.7f, 0.5f, 2.0f, 4}};
  Frame frame{stamp, {}, DepthImage(width, height)};
  for (const Object& object : wall) {
    const float u = 500.0f * (object.x + shift) / object.z + 320.0f;
    const float v = 500.0f * object.y / object.z + 240.0f;
    const float side = 100.0f / object.z;
    frame.boxes.push_back({u / width, v / height, side / width, side / height, object.name, 0.8f});
    for (float y = v - side / 2; y < v + side / 2; ++y) {
      for (float x = u - side / 2; x < u + side / 2; ++x) {
        frame.depth.at(static_cast<int>(x), static_cast<int>(y)) = object.z;
      }
    }
  }
  return frame;
}

}  // namespace plant

// ---- How it plugs in
// -----------------------------------------------------------------------------

/// Any struct is a detection once it can tell its box, class and score.
template <>
struct topobag::detection_traits<plant::YoloBox> {
  static BoundingBox box(const plant::YoloBox& b) {
    return box_around({b.cx * plant::width - 0.5, b.cy * plant::height - 0.5}, b.w * plant::width,
                      b.h * plant::height);
  }
  static ClassId label(const plant::YoloBox& b) { return ClassId{b.name}; }
  static double confidence(const plant::YoloBox& b) { return b.score; }
};

namespace {

using namespace topobag;

/// The detector's names, and which of them walk about.
ClassCatalog plant_classes() {
  ClassCatalog catalog;
  for (std::size_t i = 0; i < plant::names.size(); ++i) {
    const bool walks = plant::names[i] == std::string("worker");
    catalog.add(ClassId{static_cast<int>(i)}, plant::names[i],
                walks ? Dynamics::high : Dynamics::low);
  }
  return catalog;
}

/// An edge builder is any callable from nodes to edges: here one object after the other.
EdgeList chain(const std::vector<SemanticNode<>>& nodes) {
  EdgeList edges;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    edges.push_back(make_edge(node_index(i - 1), node_index(i)));
  }
  return edges;
}

TopologyGraph<> graph_of(const plant::Frame& frame) {
  static const ClassCatalog catalog = plant_classes();
  const PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, plant::width, plant::height};
  // A depth source is any callable from a pixel to metres, or to nothing.
  const auto depth = [&](const Eigen::Vector2d& pixel) -> std::optional<double> {
    const int x = static_cast<int>(std::lround(pixel.x()));
    const int y = static_cast<int>(std::lround(pixel.y()));
    if (x < 0 || y < 0 || x >= plant::width || y >= plant::height) return std::nullopt;
    const float metres = frame.depth.at(x, y);
    return std::isnan(metres) ? std::nullopt : std::optional<double>(metres);
  };
  return make_topology_graph(lift_detections(frame.boxes, depth, camera, catalog).nodes, chain);
}

}  // namespace

int main() {
  LoopDetector<> loops;
  const plant::Frame first = plant::take_frame(0.0, 0.0f);
  const plant::Frame again =
      plant::take_frame(60.0, 0.2f);  // the camera came back 0.2 m to the left
  loops.detect_and_add(KeyframeId{100}, first.stamp, graph_of(first));
  const Recognition loop = loops.detect_and_add(KeyframeId{200}, again.stamp, graph_of(again));

  if (!loop || loop.accepted->id != KeyframeId{100}) return EXIT_FAILURE;
  if (loop.accepted->matched.count(ClassId{4}) != 0) return EXIT_FAILURE;  // the worker walks about
  const Eigen::Vector3d moved = loop.accepted->pose->T_candidate_query.translation();
  std::cout << "loop to key frame " << value(loop.accepted->id) << ", moved by "
            << moved.transpose() << " m\n";
  return (moved - Eigen::Vector3d(-0.2, 0.0, 0.0)).norm() < 0.02 ? EXIT_SUCCESS : EXIT_FAILURE;
}
