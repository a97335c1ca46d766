// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/entry_info.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The infos of many entries, property by property: what no entry has costs nothing.
///
/// Poses are kept as a quaternion and a translation, so a rotation comes back to some 1e-15.
class InfoColumns {
 public:
  std::size_t size() const noexcept { return size_; }

  void push_back(const EntryInfo& info) {
    if (info.stamp && stamps_.empty()) stamps_.resize(size_, absent);
    if (info.session != 0 && sessions_.empty()) sessions_.resize(size_, 0);
    if (!info.label.empty() && labels_.empty()) labels_.resize(size_);
    if (info.T_world_camera && poses_.empty()) poses_.resize(size_, Pose{absent});
    if (info.image.known() && images_.empty()) images_.resize(size_);
    ++size_;
    if (!stamps_.empty() || info.stamp) stamps_.push_back(info.stamp.value_or(absent));
    if (!sessions_.empty() || info.session != 0) sessions_.push_back(info.session);
    if (!labels_.empty() || !info.label.empty()) labels_.push_back(info.label);
    if (!poses_.empty() || info.T_world_camera) poses_.push_back(packed(info.T_world_camera));
    if (!images_.empty() || info.image.known()) images_.push_back(info.image);
  }

  EntryInfo operator[](std::size_t i) const {
    EntryInfo info;
    if (!stamps_.empty() && stamps_[i] < absent) info.stamp = stamps_[i];
    if (!sessions_.empty()) info.session = sessions_[i];
    if (!labels_.empty()) info.label = labels_[i];
    if (!poses_.empty() && poses_[i][0] < absent) info.T_world_camera = unpacked(poses_[i]);
    info.image = image(i);
    return info;
  }

  /// What one entry's image looks like.
  const ImageDescriptor& image(std::size_t i) const {
    static const ImageDescriptor unknown;
    return images_.empty() ? unknown : images_[i];
  }

  /// Whether the entry has a pose, and its camera stands in the region.
  bool stands_in(std::size_t i, const MapRegion& region) const {
    if (poses_.empty() || !(poses_[i][0] < absent)) return false;
    return region.contains(Eigen::Vector3d(poses_[i][0], poses_[i][1], poses_[i][2]));
  }

  /// Moves one entry.
  void set_pose(std::size_t i, const Eigen::Isometry3d& T_world_camera) {
    if (poses_.empty()) poses_.resize(size_, Pose{absent});
    poses_[i] = packed(T_world_camera);
  }

  void shrink_to_fit() {
    stamps_.shrink_to_fit();
    sessions_.shrink_to_fit();
    labels_.shrink_to_fit();
    poses_.shrink_to_fit();
    images_.shrink_to_fit();
  }

  std::size_t bytes() const noexcept {
    std::size_t bytes =
        stamps_.capacity() * sizeof(double) + sessions_.capacity() * sizeof(std::uint32_t) +
        labels_.capacity() * sizeof(std::string) + poses_.capacity() * sizeof(Pose) +
        images_.capacity() * sizeof(ImageDescriptor);
    for (const ImageDescriptor& image : images_) bytes += image.kind().length();
    for (const std::string& label : labels_) {
      if (label.size() > 15) bytes += label.capacity() + 1;
    }
    return bytes;
  }

 private:
  using Pose = std::array<double, 7>;
  static constexpr double absent = std::numeric_limits<double>::infinity();

  static Pose packed(const std::optional<Eigen::Isometry3d>& T) {
    if (!T) return {absent};
    const Eigen::Quaterniond q(T->linear());
    const auto& t = T->translation();
    return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
  }
  static Eigen::Isometry3d unpacked(const Pose& pose) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() = Eigen::Vector3d(pose[0], pose[1], pose[2]);
    T.linear() =
        Eigen::Quaterniond(pose[6], pose[3], pose[4], pose[5]).normalized().toRotationMatrix();
    return T;
  }

  std::size_t size_ = 0;
  // Each is empty as long as no entry has the property.
  std::vector<double> stamps_;
  std::vector<std::uint32_t> sessions_;
  std::vector<std::string> labels_;
  std::vector<Pose> poses_;
  std::vector<ImageDescriptor> images_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
