// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// Who comes back mostly looks the same way: among a map's key frames one is near the query's view.
/// A pose that chance fits is turned anywhere.
///
/// The rotation of a true match is near none with probability `share` (an isotropic Gaussian of
/// `deviation` about each axis), else uniform on SO(3), as that of chance is. The prior odds are
/// kept apart from what the objects say, so that a symmetric layout stays ambiguous.
struct ViewpointPrior {
  double share = 0.7;      ///< of the revisits that look the same way; 0 = no prior
  double deviation = 0.4;  ///< rad, about each axis

  /// log10 of the density of the rotation under a true match over that under chance.
  /// @param R  a rotation matrix
  template <typename Derived>
  double log10_odds(const Eigen::MatrixBase<Derived>& R) const {
    if (!(share > 0.0)) return 0.0;
    const double two_pi = 6.283185307179586;
    const double turns = Eigen::AngleAxisd(R).angle() / deviation;
    // The volume of SO(3) is 8π².
    const double peak = 2.0 * two_pi * two_pi * std::pow(two_pi * deviation * deviation, -1.5);
    return log10_mixture(peak, turns);
  }

  /// The same where the vertical is known, of the angle about it, rad in [0, π].
  double log10_odds_of_yaw(double yaw) const {
    if (!(share > 0.0)) return 0.0;
    const double two_pi = 6.283185307179586;
    const double turns = yaw / deviation;
    const double peak = std::sqrt(two_pi) / deviation;
    return log10_mixture(peak, turns);
  }

 private:
  /// @param peak   density of the usual views at none turned, over that of any view
  /// @param turns  standard deviations by which the view is turned
  double log10_mixture(double peak, double turns) const {
    return std::log10(share * peak * std::exp(-0.5 * turns * turns) + 1.0 - share);
  }
};

}  // namespace v0
}  // namespace topobag
