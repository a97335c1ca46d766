// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <topobag/bag/detail/codec/node_layout.hpp>
#include <topobag/bag/detail/codec/packed_column.hpp>
#include <topobag/error.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The nodes of a graph, property by property.
///
/// A covariance is kept by what the noise model gives it, one standard deviation along the viewing
/// ray and one across it; other shapes are rounded off to that.
class NodeColumns {
 public:
  /// Of nodes that `require_savable` lets pass.
  template <typename Scalar>
  explicit NodeColumns(const std::vector<SemanticNode<Scalar>>& nodes) {
    for (Column& column : columns_) column.reserve(nodes.size());
    for (const SemanticNode<Scalar>& node : nodes) add(node);
  }

  /// Of a graph in this version. Throws FormatError.
  NodeColumns(BitReader& reader, unsigned version) {
    const std::size_t n = reader.get_count();
    if (n > max_nodes) throw FormatError("a graph of more than 4096 nodes: the data are damaged");
    for (const NodeColumn& c : node_columns) {
      of(c.property) = get_column(reader, c.part == 0 ? n : count(c.part), c.range, c.min_width);
    }
    if (version < 2 && count(has_label_weights) > 0) {
      throw FormatError("a graph of version 1 with label weights: the data are damaged");
    }
  }

  /// Whether the node may be of several classes, which follow elsewhere.
  bool has_weights(std::size_t i) const { return has(i, has_label_weights); }

  void put(BitWriter& writer) const {
    writer.put_number(size());
    for (const NodeColumn& c : node_columns) put_column(writer, of(c.property), c.min_width);
  }

  template <typename Scalar>
  std::vector<SemanticNode<Scalar>> nodes() const {
    std::vector<SemanticNode<Scalar>> nodes(of(Property::confidence).size());
    std::size_t pixel = 0, position = 0, depth = 0, covariance = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      SemanticNode<Scalar>& node = nodes[i];
      node.confidence =
          static_cast<Scalar>(static_cast<double>(of(Property::confidence)[i]) / steps_of_share);
      node.label = static_cast<ClassId>(of(Property::label)[i]);
      node.existence =
          static_cast<Scalar>(static_cast<double>(of(Property::existence)[i]) / steps_of_share);
      node.size = vector(of(Property::width)[i], of(Property::height)[i], steps_per_size_metre)
                      .template cast<Scalar>();
      if (has(i, has_pixel)) {
        node.pixel = vector(of(Property::u)[pixel], of(Property::v)[pixel], steps_per_pixel)
                         .template cast<Scalar>();
        ++pixel;
      }
      std::int64_t z = 0;
      Eigen::Vector3d ray = Eigen::Vector3d::Zero();
      if (has(i, has_position)) {
        ray = point(position);
        node.position = ray.template cast<Scalar>();
        z = std::max(of(Property::z)[position++], std::int64_t{0});
      }
      if (has(i, has_depth)) z = of(Property::depth)[depth++];
      node.z = static_cast<Scalar>(static_cast<double>(z) / steps_per_metre);
      if (has(i, has_covariance)) {
        node.covariance =
            covariance_of(ray, of(Property::along)[covariance], of(Property::across)[covariance])
                .template cast<Scalar>();
        ++covariance;
      }
    }
    return nodes;
  }

 private:
  using Property = NodeProperty;

  template <typename Scalar>
  void add(const SemanticNode<Scalar>& node) {
    const auto share = [](Scalar x, ColumnRange range) {
      return quantized(static_cast<double>(x), steps_of_share, range);
    };
    std::int64_t parts = 0;
    of(Property::confidence).push_back(share(node.confidence, share_range));
    of(Property::label).push_back(value(node.label));
    of(Property::existence).push_back(share(node.existence, existence_range));
    of(Property::width)
        .push_back(quantized(static_cast<double>(node.size.x()), steps_per_size_metre, size_range));
    of(Property::height)
        .push_back(quantized(static_cast<double>(node.size.y()), steps_per_size_metre, size_range));
    if (node.pixel) {
      parts |= has_pixel;
      of(Property::u)
          .push_back(quantized(static_cast<double>(node.pixel->x()), steps_per_pixel, pixel_range));
      of(Property::v)
          .push_back(quantized(static_cast<double>(node.pixel->y()), steps_per_pixel, pixel_range));
    }
    std::int64_t depth_of_position = 0;
    Eigen::Vector3d ray = Eigen::Vector3d::Zero();
    if (node.position) {
      parts |= has_position;
      of(Property::x).push_back(metres(node.position->x()));
      of(Property::y).push_back(metres(node.position->y()));
      of(Property::z).push_back(metres(node.position->z()));
      depth_of_position = std::max(of(Property::z).back(), std::int64_t{0});
      ray = point(of(Property::x).size() - 1);
    }
    if (const std::int64_t depth = metres(node.z); depth != depth_of_position) {
      parts |= has_depth;
      of(Property::depth).push_back(depth);
    }
    if (!node.covariance.isZero(Scalar(0))) {
      parts |= has_covariance;
      add_covariance(node.covariance.template cast<double>(), ray);
    }
    if (!node.label_weights.empty()) parts |= has_label_weights;
    of(Property::parts).push_back(parts);
  }

  template <typename Covariance, typename Ray>
  void add_covariance(const Covariance& covariance, const Ray& ray) {
    const Eigen::Vector3d direction = direction_of(ray);
    const double along2 = direction.dot(covariance * direction);
    const double across2 = (covariance.trace() - along2) / 2.0;
    const std::int64_t across = deviation(across2);
    of(Property::across).push_back(across);
    of(Property::along)
        .push_back(std::clamp(deviation(along2), across - max_elongation, across + max_elongation));
  }

  template <typename Ray>
  static Eigen::Matrix3d covariance_of(const Ray& ray, std::int64_t along, std::int64_t across) {
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
    return Eigen::Vector3d(static_cast<double>(of(Property::x)[i]),
                           static_cast<double>(of(Property::y)[i]),
                           static_cast<double>(of(Property::z)[i])) /
           steps_per_metre;
  }

  bool has(std::size_t i, std::int64_t part) const { return (of(Property::parts)[i] & part) != 0; }
  std::size_t count(std::int64_t part) const {
    return static_cast<std::size_t>(
        std::count_if(of(Property::parts).begin(), of(Property::parts).end(),
                      [&](std::int64_t parts) { return (parts & part) != 0; }));
  }

  Column& of(NodeProperty property) { return columns_[static_cast<std::size_t>(property)]; }
  const Column& of(NodeProperty property) const {
    return columns_[static_cast<std::size_t>(property)];
  }
  std::size_t size() const { return of(Property::parts).size(); }

  std::array<Column, node_columns.size()> columns_;  ///< by property
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
