// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <topobag/evaluation/place_truth.hpp>

#include "svg_plot.hpp"

namespace program {

/// What became of a query.
enum class Outcome {
  correct,
  imprecise,
  wrong,
  unscored,  ///< accepted, but the truth is not known
  missed,    ///< nothing was accepted, though there is a true place
  nothing,   ///< nothing was accepted, and nothing was to be found as far as is known
};

inline constexpr std::array<Outcome, 6> all_outcomes{Outcome::correct, Outcome::imprecise,
                                                     Outcome::wrong,   Outcome::unscored,
                                                     Outcome::missed,  Outcome::nothing};

/// The outcome of an accepted match by the verdict on its pose.
Outcome outcome_of(topobag::PoseVerdict verdict);

/// The name of an outcome for readers, its style class and its marker.
struct OutcomeStyle {
  const char* name;
  const char* style;
  Marker marker;
};
OutcomeStyle style_of(Outcome outcome);

/// The place that a query could have been recognised at: its nearest positive candidate.
struct TruePlace {
  std::size_t candidate = 0;
  double distance_m = 0.0;
  double angle_deg = 0.0;
  double gap_s = 0.0;               ///< between the two times
  std::optional<double> overlap{};  ///< of the two views, [0, 1]; needs a frustum
};

struct QueryOutcome {
  Outcome outcome = Outcome::nothing;
  std::optional<std::size_t> answer{};  ///< the accepted candidate
  double score = 0.0;                   ///< of the answer
  std::optional<TruePlace> place{};
  std::optional<std::size_t> objects{};  ///< in the query's graph
};

/// What a true place is where no protocol is given.
inline constexpr const char* default_protocol =
    "distance=0.5,angle=30,negative-distance=1,negative-angle=45";

/// The true poses of a run, a pose per key frame, and what a true loop is.
struct KnownPlaces {
  topobag::Trajectory queries;
  topobag::Trajectory map;
  topobag::PlaceTruth truth;
  std::optional<topobag::DepthFrustum> frustum{};  ///< what a camera sees; the overlap needs it
};

/// What a true loop is by `protocol` among the true poses of a run.
/// @param loop_gap  s; given, queries and map are one sequence that is looked for places at least
///                  this much older, which goes before what the protocol excludes
KnownPlaces known_places(topobag::Trajectory queries, topobag::Trajectory map,
                         topobag::PlaceProtocol protocol, std::optional<double> loop_gap);

/// The nearest positive candidate of a query; ties go to the first. O(candidates).
std::optional<TruePlace> nearest_true_place(const KnownPlaces& places, std::size_t query);

}  // namespace program
