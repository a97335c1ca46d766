// SPDX-License-Identifier: MIT
// A SLAM program: a map that survives, loops in it, the back end's poses, and factors for it.
#include <filesystem>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>
#include <topobag/edges/knn_edges.hpp>
#include <topobag/evaluation/g2o_text.hpp>
#include <topobag/recognition/loop_detector.hpp>
#include <topobag/sensing/node_noise.hpp>

using namespace topobag;

// What the front end makes of a key frame in a room of ten objects.
TopologyGraph<> seen(unsigned room) {
  std::mt19937 random(room);
  std::uniform_real_distribution<double> metres(-1.5, 1.5);
  std::vector<SemanticNode<>> nodes(10);
  int label = 0;
  for (auto& node : nodes) {
    node.label = ClassId{label++};
    node.position = Eigen::Vector3d(0.0, 0.0, 4.0);
    for (Eigen::Index axis = 0; axis < 3; ++axis) (*node.position)(axis) += metres(random);
    node.z = node.position->z();
    node.size = {0.3, 0.3};
    node.covariance = NodeNoise{}.covariance(*node.position, node.size, false);
  }
  return make_topology_graph(std::move(nodes), KnnEdges{});
}

// Five rooms in a row, 10 m apart.
Eigen::Isometry3d in_room(unsigned room, double drift = 0.0) {
  return Eigen::Isometry3d(Eigen::Translation3d(10.0 * room + drift, 0.0, 0.0));
}

int main() {
  const std::string path = (std::filesystem::temp_directory_path() / "topobag_slam.db").string();
  std::filesystem::remove(path);
  std::ostringstream graph;
  std::size_t loops = 0;
  {
    SqliteBag<> map(path);
    LoopDetector detector(map);
    EntryInfo info;
    info.session = map.begin_session("Monday");
    for (unsigned id = 0; id < 10; ++id) {  // twice through the rooms, with a drift of 5 cm a room
      info.T_world_camera = in_room(id % 5, 0.05 * id);
      write_g2o_vertex(graph, KeyframeId{id}, *info.T_world_camera);
      const Recognition loop =
          detector.detect_and_add(KeyframeId{id}, 10.0 * id, seen(id % 5), info);
      if (!loop) continue;
      ++loops;
      write_g2o_edge(graph, loop.accepted->id, KeyframeId{id},
                     loop.accepted->pose->with_covariance());
    }
    // The back end closes the loops; the map moves with it.
    CameraPoses optimized;
    for (unsigned id = 0; id < 10; ++id) optimized.emplace(KeyframeId{id}, in_room(id % 5));
    map.set_poses(optimized);
    const auto lost = detector.T_world_query(detector.detect(500.0, seen(3), info.session));
    if (!lost || (lost->T.translation() - in_room(3).translation()).norm() > 0.05) return 1;
    if (lost->as<GtsamPose>().covariance.diagonal().minCoeff() <= 0.0) return 1;
  }
  SqliteOptions reading;
  reading.read_only = true;
  const SqliteBag<> again(path, reading);
  if (loops != 5 || again.size() != 10) return 1;
  if (!again.info(KeyframeId{9})->T_world_camera->isApprox(in_room(4))) return 1;
  std::cout << graph.str() << loops << " loops\n";
}
