// SPDX-License-Identifier: MIT
// A camera saw a desk before; now it sees it from elsewhere. Where is it?
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <vector>

#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/sensing/lift_detections.hpp>

using namespace topobag;

const PinholeCamera<> camera{525.0, 525.0, 319.5, 239.5, 640, 480};
const ClassCatalog catalog = ClassCatalog::coco80();

/// What a detector and a depth camera give: boxes, and a depth for each pixel.
struct Image {
  std::vector<Detection> detections;
  std::vector<double> distances;  ///< of the object in each box, m

  std::optional<double> operator()(const Eigen::Vector2d& pixel) const {
    for (std::size_t i = 0; i < detections.size(); ++i) {
      if (detections[i].box.contains(pixel)) return distances[i];
    }
    return std::nullopt;
  }
};

/// Takes an image of the desk.
Image look_from(const Eigen::Isometry3d& T_world_camera) {
  struct Object {
    const char* name;
    Eigen::Vector3d position;  // m
    double width, height;      // m
  };
  const std::vector<Object> desk{
      {"tv", {0.0, -0.25, 2.0}, 0.5, 0.3},          {"keyboard", {0.0, 0.3, 1.6}, 0.4, 0.1},
      {"mouse", {0.45, 0.3, 1.6}, 0.08, 0.06},      {"cup", {-0.6, 0.15, 1.8}, 0.1, 0.12},
      {"potted plant", {0.8, -0.3, 2.2}, 0.3, 0.4}, {"book", {-0.75, -0.3, 2.1}, 0.25, 0.3}};
  Image image;
  for (const Object& object : desk) {
    const Eigen::Vector3d seen = T_world_camera.inverse() * object.position;
    image.detections.push_back(
        {box_around(*camera.project(seen), camera.fx * object.width / seen.z(),
                    camera.fy * object.height / seen.z()),
         catalog.at(object.name), 0.9});
    image.distances.push_back(seen.z());
  }
  return image;
}

int main() {
  const Eigen::Isometry3d T_world_before = Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d T_world_now =
      Eigen::Translation3d(0.3, -0.1, -0.4) * Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitY());
  const Image before = look_from(T_world_before);
  const Image now = look_from(T_world_now);

  // README begins
  const auto graph_of = [](const Image& image) {
    return make_topology_graph(lift_detections(image.detections, image, camera, catalog).nodes,
                               DelaunayEdges2<>{});
  };
  Relocalizer<> relocalizer(recognition_options(catalog));
  relocalizer.map().add(KeyframeId{7}, graph_of(before));
  const Recognition found = relocalizer.localize(graph_of(now));
  if (found) std::cout << found.accepted->pose->T_candidate_query.matrix() << '\n';
  // README ends

  if (!found || found.accepted->id != KeyframeId{7}) return EXIT_FAILURE;
  const PoseError error =
      pose_error(T_world_before.inverse() * T_world_now, found.accepted->pose->T_candidate_query);
  std::cout << "off by " << error.translation_m << " m, " << error.rotation_deg << " degrees\n";
  return error.translation_m < 0.01 && error.rotation_deg < 1.0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
