// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/graph/topology_weight.hpp>
#include <topobag/similarity/detail/assigned_gain.hpp>

namespace topobag {
inline namespace v0 {

/// Which row of W_P meets which row of W_Q.
enum class RowOrder {
  detection,            ///< the paper: row i meets row i, in node order
  class_then_position,  ///< row i meets row i, sorted by class, then u, then v
  assignment            ///< the best one-to-one assignment of rows within each class
};

/// The paper's similarity, eq. 11 and 12, to the letter: the mean over N = max(n, k) of the cosines
/// of the rows of W_P and W_Q (eq. 9, 10), the shorter padded with zero rows.
///
/// The base line of the field, not a recommendation. The rows hold pixels times metres, so their
/// cosines are near 1 whatever the objects are, and S is nearly min(n, k) / max(n, k): on real
/// detections its average precision was .03 where chance is .017, and a random number in place of
/// every class changed it by less than .0015.
///
/// A zero row, and one that overflows, contributes 0. S lies in [−1, 1]: cosines are negative where
/// u or v are. With `detection` S depends on the order of the nodes. Symmetric; S(P, P) = 1 unless
/// W_P has a zero row. O(n²); with `assignment` also O(n³), and negative cosines count as 0.
struct PaddedCosine {
  RowOrder row_order = RowOrder::detection;  ///< which rows meet
  double depth_scale = 1.0;  ///< z of eq. 1 in metres; or F: the depth image's raw value

  /// The rows of W scaled to length 1, in the order in which they are compared.
  struct Descriptor {
    std::vector<ClassId> labels;              ///< class of each row
    std::vector<std::array<double, 4>> rows;  ///< parallel to `labels`
  };

  template <typename Scalar>
  Descriptor descriptor(const TopologyGraph<Scalar>& graph) const {
    const Eigen::Matrix<double, Eigen::Dynamic, 4> W =
        topology_weight(graph, static_cast<Scalar>(depth_scale)).template cast<double>();
    std::vector<std::tuple<ClassId, double, double, std::array<double, 4>>> sorted;
    sorted.reserve(graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const auto& node = graph.nodes()[i];
      const auto pixel = node.pixel.value_or(Eigen::Matrix<Scalar, 2, 1>::Zero());
      sorted.emplace_back(node.label, pixel.x(), pixel.y(),
                          unit_row(W.row(static_cast<Eigen::Index>(i)).transpose()));
    }
    if (row_order != RowOrder::detection) std::sort(sorted.begin(), sorted.end());
    Descriptor descriptor;
    for (const auto& [label, u, v, row] : sorted) {
      descriptor.labels.push_back(label);
      descriptor.rows.push_back(row);
    }
    return descriptor;
  }

  template <typename Described = Descriptor>
  double similarity(const Described& p, const Described& q) const {
    const std::size_t common = std::min(p.rows.size(), q.rows.size());
    if (common == 0) return 0.0;
    double sum = 0.0;
    if (row_order == RowOrder::assignment) {
      // The smaller descriptor goes first: the rounding does not depend on the arguments' order.
      const bool in_order = std::tie(p.labels, p.rows) <= std::tie(q.labels, q.rows);
      const Described& a = in_order ? p : q;
      const Described& b = in_order ? q : p;
      sum = detail::assigned_gain(a.labels, b.labels, [&](std::size_t i, std::size_t j) {
        return std::max(0.0, cosine(a.rows[i], b.rows[j]));
      });
    } else {
      for (std::size_t i = 0; i < common; ++i) sum += cosine(p.rows[i], q.rows[i]);
    }
    return std::clamp(sum / static_cast<double>(std::max(p.rows.size(), q.rows.size())), -1.0, 1.0);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }

 private:
  /// Zero for a row that is zero or has overflowed.
  template <typename Row>
  static std::array<double, 4> unit_row(const Eigen::MatrixBase<Row>& row) {
    std::array<double, 4> unit{};
    using Vector = Eigen::Matrix<typename Row::Scalar, 4, 1>;
    const Vector vector = row;
    if (vector.allFinite()) Eigen::Map<Vector>(unit.data()) = vector.stableNormalized();
    return unit;
  }

  template <typename Row>
  static double cosine(const Row& a, const Row& b) {
    return Eigen::Map<const Eigen::Vector4d>(a.data()).dot(
        Eigen::Map<const Eigen::Vector4d>(b.data()));
  }
};

}  // namespace v0
}  // namespace topobag
