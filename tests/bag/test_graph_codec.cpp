// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/edges/complete_edges.hpp>
#include <topobag/sensing/node_noise.hpp>

#include "bag/realistic_graphs.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

using Bytes = std::vector<std::uint8_t>;

double max_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

void check_close(const TopologyGraph<>& graph, const TopologyGraph<>& back) {
  REQUIRE(back.size() == graph.size());
  CHECK(back.edges() == graph.edges());
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const SemanticNode<>& before = graph.nodes()[i];
    const SemanticNode<>& after = back.nodes()[i];
    CHECK(after.label == before.label);
    CHECK(std::abs(after.confidence - before.confidence) <= 0.004);
    CHECK(std::abs(after.existence - before.existence) <= 0.004);
    CHECK(max_difference(after.size, before.size) <= 0.004);
    CHECK(std::abs(after.z - before.z) <= 0.002);
    REQUIRE(after.pixel.has_value() == before.pixel.has_value());
    if (before.pixel) CHECK(max_difference(*after.pixel, *before.pixel) <= 0.5);
    REQUIRE(after.position.has_value() == before.position.has_value());
    CHECK(after.covariance.isZero(0.0) == before.covariance.isZero(0.0));
    if (!before.position) continue;
    CHECK((*after.position - *before.position).norm() <= 0.0034);
  }
}

}  // namespace

TEST_CASE("a graph comes back from its bytes within the stated error", "[bag][codec]") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const TopologyGraph<> graph = realistic_graph(random, random() % 30);
    check_close(graph, decode(encode(graph)));
  }
}

TEST_CASE("encoding what was decoded gives the same bytes", "[bag][codec]") {
  std::mt19937 random(2);
  for (int trial = 0; trial < 300; ++trial) {
    const Bytes once = encode(realistic_graph(random, random() % 30));
    CHECK(encode(decode(once)) == once);
    const Bytes as_float = encode(decode<float>(once));
    CHECK(encode(decode<float>(as_float)) == as_float);
  }
}

TEST_CASE("covariances keep the noise model's shape", "[bag][codec]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> scale(0.1, 3.0);
  for (int trial = 0; trial < 200; ++trial) {
    auto nodes = random_nodes(random, 5);
    for (auto& node : nodes) {
      node.covariance =
          scale(random) * NodeNoise{}.covariance(*node.position, node.size, random() % 2 == 0);
    }
    const auto back = decode(encode(TopologyGraph<>(nodes)));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::Vector3d ray = nodes[i].position->normalized();
      const Eigen::Vector3d across = ray.unitOrthogonal();
      for (const Eigen::Vector3d& axis : {ray, across}) {
        const double before = std::sqrt(axis.dot(nodes[i].covariance * axis));
        const double after = std::sqrt(axis.dot(back.nodes()[i].covariance * axis));
        CHECK(after == Approx(before).epsilon(0.045));
      }
      CHECK(back.nodes()[i].covariance.isApprox(back.nodes()[i].covariance.transpose(), 0.0));
    }
  }
}

TEST_CASE("covariances of any shape stay positive definite", "[bag][codec]") {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    auto nodes = random_nodes(random, 1);
    Eigen::Vector4d turn;
    for (double& x : turn) x = normal(random);
    const Eigen::Matrix3d R = Eigen::Quaterniond(turn.normalized()).toRotationMatrix();
    Eigen::Vector3d variances;
    for (double& x : variances) x = std::exp(3.0 * normal(random));
    nodes[0].covariance =
        std::exp(16.0 * normal(random)) * (R * variances.asDiagonal() * R.transpose());
    if (trial % 5 == 0) nodes[0].position.reset();
    if (trial % 7 == 0) nodes[0].position = Eigen::Vector3d::Zero();
    const Bytes bytes = encode(TopologyGraph<>(nodes));
    const Eigen::Matrix3d back = decode(bytes).nodes()[0].covariance;
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(back).eigenvalues().minCoeff() > 0.0);
    CHECK(encode(decode(bytes)) == bytes);
  }
}

TEST_CASE("views come back within the stated error", "[bag][codec]") {
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const TopologyGraph<> graph = realistic_graph(random, 3);
    const TopologyGraph<> back = decode(encode(graph));
    REQUIRE(back.views().size() == graph.views().size());
    for (std::size_t i = 0; i < graph.views().size(); ++i) {
      const View<>& before = graph.views()[i];
      const View<>& after = back.views()[i];
      const Eigen::Isometry3d between = before.T_graph_camera.inverse() * after.T_graph_camera;
      CHECK(between.translation().norm() <= 0.0034);
      CHECK(Eigen::AngleAxisd(between.linear()).angle() <= 0.0013);
      CHECK(std::abs(after.camera.fx - before.camera.fx) <= 1.0 / 32);
      CHECK(std::abs(after.camera.cy - before.camera.cy) <= 1.0 / 32);
      CHECK(after.camera.width == before.camera.width);
      CHECK(after.camera.height == before.camera.height);
      REQUIRE(after.occluders.size() == before.occluders.size());
      for (std::size_t k = 0; k < before.occluders.size(); ++k) {
        const Occluder& o = before.occluders[k];
        const Occluder& p = after.occluders[k];
        CHECK(std::abs(p.z - o.z) <= 0.002);
        CHECK(std::abs(p.box.x1 - o.box.x1) <= 0.5);
        CHECK(std::abs(p.box.y2 - o.box.y2) <= 0.5);
      }
    }
    CHECK(decode(encode(graph, ViewSection::left_out)).views().empty());
  }
}

TEST_CASE("half a turn is no trap for a view's rotation", "[bag][codec]") {
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0),
                                      Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(-1, 2, 0.001)}) {
    for (const double angle : {half_a_turn, half_a_turn - 1e-4, half_a_turn - 1e-3, 0.0, 1e-5}) {
      View<> view;
      view.T_graph_camera.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
      const Bytes bytes = encode(TopologyGraph<>({}, {}, {view}));
      const TopologyGraph<> back = decode(bytes);
      CHECK(encode(back) == bytes);
      const Eigen::Matrix3d between =
          view.T_graph_camera.linear().transpose() * back.views()[0].T_graph_camera.linear();
      CHECK(Eigen::AngleAxisd(between).angle() <= 0.0012);
    }
  }
}

TEST_CASE("12 nodes take no more than 200 bytes", "[bag][codec]") {
  std::mt19937 random(6);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<SemanticNode<>> nodes = random_nodes(random, 12, 80);
    for (auto& node : nodes) {
      node.confidence = static_cast<double>(random() % 1000) / 1000.0;
      node.existence = static_cast<double>(1 + random() % 1000) / 1000.0;
      node.covariance = NodeNoise{}.covariance(*node.position, node.size, random() % 3 == 0);
    }
    CHECK(encode(make_topology_graph(nodes, KnnEdges{})).size() <= 200);
  }
}

TEST_CASE("degenerate graphs keep what they have", "[bag][codec]") {
  CHECK(encode(TopologyGraph<>{}).size() <= 3);
  CHECK(decode(encode(TopologyGraph<>{})).empty());
  CHECK(decode(encode(TopologyGraph<>{std::vector<SemanticNode<>>(1)})).size() == 1);

  SemanticNode<> behind;  // without pixel, with a depth of its own
  behind.label = ClassId{-5};
  behind.position = Eigen::Vector3d(0, 0, -2);
  behind.z = 1.0;
  SemanticNode<> bearing_only;
  bearing_only.label = ClassId{std::numeric_limits<std::int32_t>::max()};
  bearing_only.pixel = Eigen::Vector2d(-3e9, 12.25);
  bearing_only.size = {-1.0, 0.0};
  bearing_only.confidence = 3.0;
  bearing_only.existence = 0.0;
  const TopologyGraph<> back = decode(encode(TopologyGraph<>({behind, bearing_only})));
  CHECK(back.nodes()[0].label == behind.label);
  CHECK(*back.nodes()[0].position == *behind.position);
  CHECK(back.nodes()[0].z == 1.0);
  CHECK_FALSE(back.nodes()[0].pixel);
  CHECK(back.nodes()[1].label == bearing_only.label);
  CHECK(*back.nodes()[1].pixel == Eigen::Vector2d(-1048576.0, 12.0));
  CHECK(back.nodes()[1].size.isZero(0.0));
  CHECK(back.nodes()[1].confidence == 1.0);
  CHECK(back.nodes()[1].existence == Approx(1.0 / 127.0));
}

TEST_CASE("any set of edges comes back", "[bag][codec]") {
  std::mt19937 random(7);
  for (const std::size_t n : {2u, 3u, 10u, 60u, 400u}) {
    const auto nodes = random_nodes(random, n);
    std::vector<EdgeList> sets = {EdgeList{},
                                  CompleteEdges{}(nodes),
                                  KnnEdges{4}(nodes),
                                  {make_edge(node_index(n - 1), node_index(n - 2))}};
    for (const EdgeList& edges : sets) {
      const TopologyGraph<> graph(nodes, edges);
      CHECK(decode(encode(graph)).edges() == graph.edges());
    }
  }
  const auto nodes = random_nodes(random, 400);
  CHECK(encode(TopologyGraph<>(nodes, KnnEdges{4}(nodes))).size() < 400 * 18);
}
