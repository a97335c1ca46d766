// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <topobag/graph/topology_graph.hpp>

namespace topobag {
inline namespace v0 {

/// O of eq. 7: n × 4, row i = [u_i v_i z_i c_i] (px, px, m, label number) in node order.
///
/// @param depth_scale  1 for z in metres; F for the paper's other reading, the depth image's raw
/// value u and v of a node without a pixel are 0. O(n).
template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, 4> vertex_matrix(const TopologyGraph<Scalar>& graph,
                                                       Scalar depth_scale = Scalar(1)) {
  Eigen::Matrix<Scalar, Eigen::Dynamic, 4> O(static_cast<Eigen::Index>(graph.size()), 4);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const SemanticNode<Scalar>& node = graph.nodes()[i];
    const auto pixel = node.pixel.value_or(Eigen::Matrix<Scalar, 2, 1>::Zero());
    O.row(static_cast<Eigen::Index>(i)) << pixel.x(), pixel.y(), node.z * depth_scale,
        static_cast<Scalar>(value(node.label));
  }
  return O;
}

}  // namespace v0
}  // namespace topobag
