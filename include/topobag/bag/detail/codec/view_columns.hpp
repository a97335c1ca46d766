// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/detail/codec/node_layout.hpp>
#include <topobag/bag/detail/codec/packed_column.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/view.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

inline constexpr double half_a_turn = 3.14159265358979323846;
inline constexpr double steps_per_radian = 4096.0;
inline constexpr double steps_per_camera_pixel = 16.0;
inline constexpr ColumnRange rotation_range{-12868, 12868};  // up to half a turn
inline constexpr ColumnRange camera_range{-(std::int64_t{1} << 28), std::int64_t{1} << 28};
inline constexpr ColumnRange image_range{0, std::int64_t{1} << 24};
inline constexpr ColumnRange count_range{0, std::int64_t{1} << 32};
inline constexpr ColumnRange box_range{0, 2 * pixel_range.high};

/// The views of a graph, property by property.
class ViewColumns {
 public:
  /// Of views that `require_savable` lets pass.
  template <typename Scalar>
  explicit ViewColumns(const std::vector<View<Scalar>>& views) {
    for (const View<Scalar>& view : views) add(view);
  }

  /// Throws FormatError.
  explicit ViewColumns(BitReader& reader) {
    const std::size_t n = reader.get_count();
    occluders_ = get_column(reader, n, count_range, vouching_width);
    for (Column& column : translation_) column = get_column(reader, n, metre_range);
    for (Column& column : rotation_) column = get_column(reader, n, rotation_range);
    for (Column& column : camera_) column = get_column(reader, n, camera_range);
    for (Column& column : image_) column = get_column(reader, n, image_range);
    const std::size_t boxes = reader.get_count();
    z_ = get_column(reader, boxes, metre_range, vouching_width);
    for (Column& column : corner_) column = get_column(reader, boxes, pixel_range);
    for (Column& column : extent_) column = get_column(reader, boxes, box_range);
    std::uint64_t announced = 0;
    for (const std::int64_t count : occluders_) announced += static_cast<std::uint64_t>(count);
    if (announced != boxes) throw FormatError("the views' boxes do not add up: they are damaged");
  }

  void put(BitWriter& writer) const {
    writer.put_number(occluders_.size());
    put_column(writer, occluders_, vouching_width);
    for (const Column& column : translation_) put_column(writer, column);
    for (const Column& column : rotation_) put_column(writer, column);
    for (const Column& column : camera_) put_column(writer, column);
    for (const Column& column : image_) put_column(writer, column);
    writer.put_number(z_.size());
    put_column(writer, z_, vouching_width);
    for (const Column& column : corner_) put_column(writer, column);
    for (const Column& column : extent_) put_column(writer, column);
  }

  template <typename Scalar>
  std::vector<View<Scalar>> views() const {
    std::vector<View<Scalar>> views(occluders_.size());
    std::size_t box = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
      View<Scalar>& view = views[i];
      const auto real = [&](const Column& column, double steps) {
        return static_cast<double>(column[i]) / steps;
      };
      Eigen::Vector3d t, turn;
      for (int k = 0; k < 3; ++k) {
        t(k) = real(translation_[k], steps_per_metre);
        turn(k) = real(rotation_[k], steps_per_radian);
      }
      Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
      if (const double angle = turn.norm(); angle > 0.0) {
        T.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
      }
      T.translation() = t;
      view.T_graph_camera = T.template cast<Scalar>();
      const auto camera = [&](int k) {
        return static_cast<Scalar>(real(camera_[k], steps_per_camera_pixel));
      };
      view.camera = {camera(0),
                     camera(1),
                     camera(2),
                     camera(3),
                     static_cast<int>(image_[0][i]),
                     static_cast<int>(image_[1][i])};
      for (std::int64_t k = 0; k < occluders_[i]; ++k) view.occluders.push_back(occluder(box++));
    }
    return views;
  }

 private:
  template <typename Scalar>
  void add(const View<Scalar>& view) {
    const Eigen::Isometry3d T = view.T_graph_camera.template cast<double>();
    const Eigen::AngleAxisd turn(T.linear());
    // Just short of half a turn, where a rounded vector would come back as its opposite.
    const double angle = std::min(turn.angle(), half_a_turn - 4.0 / steps_per_radian);
    for (int k = 0; k < 3; ++k) {
      translation_[k].push_back(quantized(T.translation()(k), steps_per_metre, metre_range));
      rotation_[k].push_back(quantized(angle * turn.axis()(k), steps_per_radian, rotation_range));
    }
    const auto& camera = view.camera;
    const Scalar numbers[] = {camera.fx, camera.fy, camera.cx, camera.cy};
    for (int k = 0; k < 4; ++k) {
      camera_[k].push_back(
          quantized(static_cast<double>(numbers[k]), steps_per_camera_pixel, camera_range));
    }
    image_[0].push_back(quantized(camera.width, 1.0, image_range));
    image_[1].push_back(quantized(camera.height, 1.0, image_range));
    occluders_.push_back(static_cast<std::int64_t>(view.occluders.size()));
    for (const Occluder& o : view.occluders) {
      z_.push_back(quantized(o.z, steps_per_metre, metre_range));
      const double low[] = {o.box.x1, o.box.y1}, high[] = {o.box.x2, o.box.y2};
      for (int k = 0; k < 2; ++k) {
        corner_[k].push_back(quantized(low[k], steps_per_pixel, pixel_range));
        extent_[k].push_back(std::max<std::int64_t>(
            0, quantized(high[k], steps_per_pixel, pixel_range) - corner_[k].back()));
      }
    }
  }

  Occluder occluder(std::size_t i) const {
    const auto corner = [&](int k) { return static_cast<double>(corner_[k][i]) / steps_per_pixel; };
    const auto extent = [&](int k) { return static_cast<double>(extent_[k][i]) / steps_per_pixel; };
    return {{corner(0), corner(1), corner(0) + extent(0), corner(1) + extent(1)},
            static_cast<double>(z_[i]) / steps_per_metre};
  }

  // Of every view:
  Column occluders_;  ///< how many
  Column translation_[3], rotation_[3], camera_[4], image_[2];
  // Of every occluder:
  Column z_, corner_[2], extent_[2];
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
