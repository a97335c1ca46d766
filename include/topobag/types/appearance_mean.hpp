// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include <topobag/types/appearance.hpp>

namespace topobag {
inline namespace v0 {

/// The mean direction of an object's descriptors.
class AppearanceMean {
 public:
  /// One that is unknown adds nothing. Precondition: they are of one kind. O(1).
  void add(const Appearance& appearance) {
    if (!appearance.known()) return;
    kind_ = appearance.kind();
    const auto vector =
        Eigen::Map<const Eigen::Matrix<std::int8_t, capacity, 1>>(appearance.bytes().data())
            .cast<float>();
    sum_ += vector / vector.norm();
  }

  /// Unknown where nothing was added, or all cancels out.
  Appearance mean() const {
    if (kind_.length() == 0 || sum_.isZero(0.0F)) return {};
    return Appearance(kind_, sum_.head(static_cast<Eigen::Index>(kind_.length())));
  }

 private:
  static constexpr int capacity = static_cast<int>(AppearanceKind::max_length);

  AppearanceKind kind_;
  Eigen::Matrix<float, capacity, 1> sum_ = Eigen::Matrix<float, capacity, 1>::Zero();
};

}  // namespace v0
}  // namespace topobag
