// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include <topobag/types/appearance_mean.hpp>
#include <topobag/types/label_sum.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// An object of a local graph, the same while the window slides.
enum class ObjectId : std::uint64_t {};

/// Distance of two nodes with positions, in standard deviations along the line between them.
template <typename Scalar>
Scalar deviations_apart(const SemanticNode<Scalar>& a, const SemanticNode<Scalar>& b) {
  const typename SemanticNode<Scalar>::Vector3 delta = *a.position - *b.position;
  const Scalar distance2 = delta.squaredNorm();
  if (distance2 <= Scalar(0)) return Scalar(0);
  const Scalar variance = delta.dot((a.covariance + b.covariance) * delta) / distance2;
  return variance > Scalar(0) ? std::sqrt(distance2 / variance)
                              : std::numeric_limits<Scalar>::infinity();
}

/// The sightings of one object and what they say together.
template <typename Scalar_ = double>
struct ObjectTrack {
  using Scalar = Scalar_;
  using Node = SemanticNode<Scalar>;
  using Vector3 = typename Node::Vector3;
  using Matrix3 = typename Node::Matrix3;

  /// One node of one view, with its position and covariance in the local graph's frame.
  struct Sighting {
    std::size_t view = 0;  ///< number of the view, ascending
    Node node;             ///< in the frame of the newest view
  };

  ObjectId id{};                    ///< stays with the object
  std::vector<Sighting> sightings;  ///< by rising view

  /// Class with the most confidence behind it; ties go to the smaller number.
  ClassId label() const { return labels().label(); }

  /// The fused node: information-weighted mean position; its covariance shrinks as if `correlation`
  /// of the sightings' errors were common to all (box and depth biases are). Its appearance is the
  /// mean of those that are known; in windows of fr1 that tells one object from another with AUC
  /// .95, the newest one with .91, the surest with .89; the sightings' spread adds .003 to the
  /// mean's, which is not worth its bytes. What it may be is the mean of what the sightings say.
  /// O(sightings).
  Node fused(Scalar correlation) const {
    Matrix3 information = Matrix3::Zero();
    Vector3 weighted = Vector3::Zero();
    std::vector<Scalar> widths, heights;
    widths.reserve(sightings.size());
    heights.reserve(sightings.size());
    AppearanceMean appearance;
    Node node;
    node.confidence = Scalar(0);
    for (const Sighting& s : sightings) {
      const Matrix3 weight = s.node.covariance.inverse();
      information += weight;
      weighted += weight * *s.node.position;
      widths.push_back(s.node.size.x());
      heights.push_back(s.node.size.y());
      appearance.add(s.node.appearance);
      node.confidence = std::max(node.confidence, s.node.confidence);
    }
    const Scalar n = static_cast<Scalar>(sightings.size());
    const Matrix3 mean_covariance = information.inverse();
    const LabelSum said = labels();
    node.label = said.label();
    node.label_weights = said.weights();
    node.position = mean_covariance * weighted;
    node.covariance = mean_covariance * (Scalar(1) + (n - Scalar(1)) * correlation);
    node.size = {median(widths), median(heights)};
    node.appearance = appearance.mean();
    return node;
  }

 private:
  LabelSum labels() const {
    LabelSum sum;
    for (const Sighting& s : sightings) {
      sum.add(s.node.label, s.node.label_weights, static_cast<double>(s.node.confidence));
    }
    return sum;
  }

  static Scalar median(std::vector<Scalar>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }
};

}  // namespace v0
}  // namespace topobag
