// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <topobag/bag/detail/packed_column.hpp>
#include <topobag/error.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

// The units of the format: a change of one of them is a new version of it.
inline constexpr double steps_per_metre = 256.0;
inline constexpr double steps_per_size_metre = 128.0;
inline constexpr double steps_per_pixel = 1.0;
inline constexpr double steps_of_share = 127.0;  // of a share in [0, 1]
inline constexpr double steps_per_octave = 8.0;  // of a standard deviation, from 1 m
inline constexpr double max_metres = 1048576.0;
inline constexpr std::size_t max_nodes = 4096;  // a histogram's words are n²: some 10^7

inline constexpr ColumnRange metre_range{-(std::int64_t{1} << 28), std::int64_t{1} << 28};
inline constexpr ColumnRange size_range{0, std::int64_t{1} << 27};
inline constexpr ColumnRange pixel_range{-(std::int64_t{1} << 20), std::int64_t{1} << 20};
inline constexpr ColumnRange share_range{0, 127};
inline constexpr ColumnRange existence_range{1, 127};
inline constexpr ColumnRange deviation_range{-80, 48};  // 1 mm to 64 m
inline constexpr std::int64_t max_elongation = 48;      // a factor of 64 between the axes
inline constexpr ColumnRange label_range{std::numeric_limits<std::int32_t>::min(),
                                         std::numeric_limits<std::int32_t>::max()};

/// The nodes of a graph, property by property.
///
/// A covariance is kept by what the noise model gives it, one standard deviation along the viewing
/// ray and one across it; other shapes are rounded off to that.
class NodeColumns {
 public:
  // What a node may lack.
  static constexpr std::int64_t has_pixel = 1;
  static constexpr std::int64_t has_position = 2;
  static constexpr std::int64_t has_depth = 4;  ///< other than the position's
  static constexpr std::int64_t has_covariance = 8;

  /// Of nodes that `require_savable` lets pass.
  template <typename Scalar>
  explicit NodeColumns(const std::vector<SemanticNode<Scalar>>& nodes) {
    for (Column* column : {&confidence_, &label_, &existence_, &parts_, &width_, &height_, &u_, &v_,
                           &x_, &y_, &z_, &along_, &across_}) {
      column->reserve(nodes.size());
    }
    for (const SemanticNode<Scalar>& node : nodes) add(node);
  }

  /// Throws FormatError.
  explicit NodeColumns(BitReader& reader) {
    const std::size_t n = reader.get_count();
    if (n > max_nodes) throw FormatError("a graph of more than 4096 nodes: the data are damaged");
    confidence_ = get_column(reader, n, share_range, vouching_width);
    label_ = get_column(reader, n, label_range);
    existence_ = get_column(reader, n, existence_range);
    parts_ = get_column(reader, n, {0, has_pixel | has_position | has_depth | has_covariance});
    width_ = get_column(reader, n, size_range);
    height_ = get_column(reader, n, size_range);
    const std::size_t pixels = count(has_pixel);
    u_ = get_column(reader, pixels, pixel_range);
    v_ = get_column(reader, pixels, pixel_range);
    const std::size_t positions = count(has_position);
    x_ = get_column(reader, positions, metre_range);
    y_ = get_column(reader, positions, metre_range);
    z_ = get_column(reader, positions, metre_range);
    depth_ = get_column(reader, count(has_depth), metre_range);
    const std::size_t covariances = count(has_covariance);
    along_ = get_column(reader, covariances, deviation_range);
    across_ = get_column(reader, covariances, deviation_range);
  }

  void put(BitWriter& writer) const {
    writer.put_number(confidence_.size());
    put_column(writer, confidence_, vouching_width);
    for (const Column* column : {&label_, &existence_, &parts_, &width_, &height_, &u_, &v_, &x_,
                                 &y_, &z_, &depth_, &along_, &across_}) {
      put_column(writer, *column);
    }
  }

  template <typename Scalar>
  std::vector<SemanticNode<Scalar>> nodes() const {
    std::vector<SemanticNode<Scalar>> nodes(confidence_.size());
    std::size_t pixel = 0, position = 0, depth = 0, covariance = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      SemanticNode<Scalar>& node = nodes[i];
      node.confidence = static_cast<Scalar>(static_cast<double>(confidence_[i]) / steps_of_share);
      node.label = static_cast<ClassId>(label_[i]);
      node.existence = static_cast<Scalar>(static_cast<double>(existence_[i]) / steps_of_share);
      node.size = vector(width_[i], height_[i], steps_per_size_metre).template cast<Scalar>();
      if (has(i, has_pixel)) {
        node.pixel = vector(u_[pixel], v_[pixel], steps_per_pixel).template cast<Scalar>();
        ++pixel;
      }
      std::int64_t z = 0;
      Eigen::Vector3d ray = Eigen::Vector3d::Zero();
      if (has(i, has_position)) {
        ray = point(position);
        node.position = ray.template cast<Scalar>();
        z = std::max(z_[position++], std::int64_t{0});
      }
      if (has(i, has_depth)) z = depth_[depth++];
      node.z = static_cast<Scalar>(static_cast<double>(z) / steps_per_metre);
      if (has(i, has_covariance)) {
        node.covariance =
            covariance_of(ray, along_[covariance], across_[covariance]).template cast<Scalar>();
        ++covariance;
      }
    }
    return nodes;
  }

 private:
  template <typename Scalar>
  void add(const SemanticNode<Scalar>& node) {
    const auto share = [](Scalar x, ColumnRange range) {
      return quantized(static_cast<double>(x), steps_of_share, range);
    };
    std::int64_t parts = 0;
    confidence_.push_back(share(node.confidence, share_range));
    label_.push_back(value(node.label));
    existence_.push_back(share(node.existence, existence_range));
    width_.push_back(
        quantized(static_cast<double>(node.size.x()), steps_per_size_metre, size_range));
    height_.push_back(
        quantized(static_cast<double>(node.size.y()), steps_per_size_metre, size_range));
    if (node.pixel) {
      parts |= has_pixel;
      u_.push_back(quantized(static_cast<double>(node.pixel->x()), steps_per_pixel, pixel_range));
      v_.push_back(quantized(static_cast<double>(node.pixel->y()), steps_per_pixel, pixel_range));
    }
    std::int64_t depth_of_position = 0;
    Eigen::Vector3d ray = Eigen::Vector3d::Zero();
    if (node.position) {
      parts |= has_position;
      x_.push_back(metres(node.position->x()));
      y_.push_back(metres(node.position->y()));
      z_.push_back(metres(node.position->z()));
      depth_of_position = std::max(z_.back(), std::int64_t{0});
      ray = point(x_.size() - 1);
    }
    if (const std::int64_t depth = metres(node.z); depth != depth_of_position) {
      parts |= has_depth;
      depth_.push_back(depth);
    }
    if (!node.covariance.isZero(Scalar(0))) {
      parts |= has_covariance;
      add_covariance(node.covariance.template cast<double>(), ray);
    }
    parts_.push_back(parts);
  }

  void add_covariance(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& ray) {
    const Eigen::Vector3d direction = direction_of(ray);
    const double along2 = direction.dot(covariance * direction);
    const double across2 = (covariance.trace() - along2) / 2.0;
    const std::int64_t across = deviation(across2);
    across_.push_back(across);
    along_.push_back(
        std::clamp(deviation(along2), across - max_elongation, across + max_elongation));
  }

  static Eigen::Matrix3d covariance_of(const Eigen::Vector3d& ray, std::int64_t along,
                                       std::int64_t across) {
    const double along2 = variance(along), across2 = variance(across);
    const Eigen::Vector3d direction = direction_of(ray);
    const Eigen::Matrix3d projection = direction * direction.transpose();
    return across2 * Eigen::Matrix3d::Identity() + (along2 - across2) * projection;
  }

  static Eigen::Vector3d direction_of(const Eigen::Vector3d& ray) {
    return ray.isZero(0.0) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(ray.normalized());
  }

  /// A variance, m², as the logarithm of its root.
  static std::int64_t deviation(double variance) {
    const double least =
        std::exp2(2.0 * static_cast<double>(deviation_range.low) / steps_per_octave);
    return quantized(0.5 * std::log2(std::max(variance, least)), steps_per_octave, deviation_range);
  }
  static double variance(std::int64_t deviation) {
    return std::exp2(2.0 * static_cast<double>(deviation) / steps_per_octave);
  }

  template <typename Scalar>
  static std::int64_t metres(Scalar x) {
    return quantized(static_cast<double>(x), steps_per_metre, metre_range);
  }
  static Eigen::Vector2d vector(std::int64_t x, std::int64_t y, double steps) {
    return Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y)) / steps;
  }
  Eigen::Vector3d point(std::size_t i) const {
    return Eigen::Vector3d(static_cast<double>(x_[i]), static_cast<double>(y_[i]),
                           static_cast<double>(z_[i])) /
           steps_per_metre;
  }

  bool has(std::size_t i, std::int64_t part) const { return (parts_[i] & part) != 0; }
  std::size_t count(std::int64_t part) const {
    return static_cast<std::size_t>(std::count_if(
        parts_.begin(), parts_.end(), [&](std::int64_t parts) { return (parts & part) != 0; }));
  }

  // Of every node:
  Column confidence_, label_, existence_, parts_, width_, height_;
  // Of those that have the part, in their order:
  Column u_, v_, x_, y_, z_, depth_, along_, across_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
