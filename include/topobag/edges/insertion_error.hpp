// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// The smallest magnitude, 2⁻¹⁴², that a coordinate other than zero may have in a triangulation.
constexpr double min_allowed_value = 0x1p-142;

/// The largest magnitude, 2²⁰¹, that a coordinate may have in a triangulation.
constexpr double max_allowed_value = 0x1p201;

/// Why a coordinate cannot be triangulated.
enum class CoordinateFault {
  nan,        ///< not a number
  infinite,   ///< ±∞
  too_large,  ///< magnitude above `max_allowed_value`
  too_small   ///< not zero, and magnitude below `min_allowed_value`
};

/// What is wrong with a coordinate, if anything. Constant time.
inline std::optional<CoordinateFault> validate_coordinate(double coordinate) noexcept {
  const double magnitude = std::abs(coordinate);
  if (magnitude >= min_allowed_value && magnitude <= max_allowed_value) return std::nullopt;
  if (magnitude == 0.0) return std::nullopt;
  if (magnitude < min_allowed_value) return CoordinateFault::too_small;
  if (std::isnan(coordinate)) return CoordinateFault::nan;
  return std::isinf(coordinate) ? CoordinateFault::infinite : CoordinateFault::too_large;
}

/// Replaces a coordinate that is too small by zero, and leaves every other one alone.
inline double mitigate_underflow(double coordinate) noexcept {
  return std::abs(coordinate) < min_allowed_value ? 0.0 : coordinate;
}

/// A position that cannot be triangulated. The index is that of the vertex or node in the input.
class InsertionError : public InvalidValue {
 public:
  /// The sentence follows from the fault.
  explicit InsertionError(CoordinateFault fault, std::optional<std::size_t> index = std::nullopt)
      : InvalidValue(sentence(fault, index), index), fault_(fault) {}

  /// What is wrong with the first bad coordinate.
  CoordinateFault fault() const noexcept { return fault_; }

 private:
  static std::string sentence(CoordinateFault fault, std::optional<std::size_t> index) {
    const std::string subject =
        "The position" + (index ? " of vertex " + std::to_string(*index) : std::string());
    switch (fault) {
      case CoordinateFault::nan:
        return subject + " has a coordinate that is not a number: leave it out.";
      case CoordinateFault::infinite:
        return subject + " has an infinite coordinate: leave it out.";
      case CoordinateFault::too_large:
        return subject + " has a coordinate beyond 2^201: choose a larger unit of length.";
      case CoordinateFault::too_small:
        break;
    }
    return subject + " has a coordinate below 2^-142 that is not zero: pass mitigate_underflow(x).";
  }

  CoordinateFault fault_;
};

/// Throws `InsertionError` unless every coordinate of `position` is zero or has a magnitude in
/// [`min_allowed_value`, `max_allowed_value`]. `index` goes into the error.
template <typename Derived>
void validate_position(const Eigen::MatrixBase<Derived>& position,
                       std::optional<std::size_t> index = std::nullopt) {
  for (Eigen::Index i = 0; i < position.size(); ++i) {
    if (const auto fault = validate_coordinate(static_cast<double>(position[i]))) {
      throw InsertionError(*fault, index);
    }
  }
}

}  // namespace v0
}  // namespace topobag
