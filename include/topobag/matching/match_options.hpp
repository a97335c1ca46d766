// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include <topobag/matching/chance_model.hpp>
#include <topobag/matching/consistency_graph.hpp>
#include <topobag/matching/missing_objects.hpp>
#include <topobag/matching/refine_pose.hpp>
#include <topobag/matching/scale_range.hpp>
#include <topobag/matching/viewpoint_prior.hpp>
#include <topobag/sensing/sensor_profile.hpp>

namespace topobag {
inline namespace v0 {

/// How poses are found and scored.
struct MatchOptions {
  ConsistencyOptions consistency{};  ///< which pairs of nodes agree
  ChanceModel chance{};              ///< how often chance does as well
  MissingObjects missing{};          ///< what absent objects cost
  ViewpointPrior viewpoint{};        ///< how likely a revisit is turned so
  RefineOptions refine{};            ///< the fit over all objects
  std::size_t max_steps = 4000;      ///< branches of the clique search
  std::size_t slack = 1;  ///< cliques this much smaller than the largest are tried as well
  /// Cliques whose pose is worked out, largest and tightest first. Where chairs abound a third of
  /// the candidates has more, and what those add is time: half of a query's with 64.
  std::size_t max_hypotheses = 10;
  /// Significance, at its first fit, of what is worked out, but for the best; refining seldom gains
  /// two decades. Nine poses in ten are below 0: with all of them a query takes half as long again,
  /// and of 21,078 one is decided otherwise.
  double min_promise = -2.0;
  /// Standard deviations (of a 3-D residual) within which a pair supports a pose.
  double inlier_deviations = default_sensor.gate_deviations;
  double max_residual = default_sensor.gate;  ///< m; beyond it a pair supports no pose
  /// m; inliers nearer to one line leave the rotation about it open.
  double min_spread = default_sensor.min_spread;
  double max_rotation_deviation =
      0.31;  ///< rad; a pose less certain about its worst axis is degenerate
  /// m; two poses further apart than this are different.
  double distinct_translation = default_sensor.pose_resolution;
  double distinct_rotation = rotation_resolution;  ///< rad; poses turned by more are different
  /// Of the query's unit, where that is not known; by default both graphs are in metres.
  std::optional<ScaleRange> scale{};
};

}  // namespace v0
}  // namespace topobag
