// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <topobag/error.hpp>
#include <topobag/recognition/calibration.hpp>

namespace topobag {
inline namespace v0 {

/// When a match is believed, stated as a rate: of the queries of places that the map does not
/// hold, so many may be accepted, however large the map. One set for all data; the pages say how it
/// was chosen.
///
/// A score is −log10 of the odds that chance gave one match of one place as good. A query asks
/// every place of the map, those that retrieval passes over as well, but only the N that hold such
/// objects as were matched could have given that match. Among them chance gives N · 10^−score: the
/// score to ask for is log10(N / rate), less what the chance model, which bounds a probability from
/// above, is too careful by (`surplus`). A keyboard, a monitor and a mouse are asked of the few
/// places with all three, four chairs of nearly all. Between graphs of which neither has views
/// nothing can be missing, and less of the surplus is left (`surplus_without_views`).
struct DecisionOptions {
  double false_accept_rate = 1e-3;  ///< share of queries of places that the map does not hold
  double min_lead = 1.0;            ///< in support, over every pose that puts the query elsewhere
  double lead_deviations =
      3.0;                     ///< σ of the noise of both, more, over a place believable by itself
  double rival_support = 1.0;  ///< positive; from which another place is that, in full
  std::size_t more_places = 5;  ///< that are taken to hold such objects, of all: a map of few
                                ///< places does not tell what is rare
  double surplus = 1.25;  ///< decades by which 10^−score exceeds the rate of chance, as measured
  double surplus_without_views = 0.5;  ///< the same, of made-up places that have nothing in common

  std::optional<Calibration> calibration{};  ///< learnt in this very map: says the score to ask for
  std::optional<double> min_score{};         ///< with it, that is the score to ask for

  /// The score to ask for among `places`. A calibration, whose scores are of whatever was matched,
  /// asks by the places of the whole map instead, as far as they have grown since it was learnt.
  /// Throws InvalidValue for a rate outside (0, 1].
  /// @param with_views  of the query or the candidate
  /// @param map_places  of the whole map; 0 = as many as the calibration was learnt with
  double threshold(std::size_t places, bool with_views = true, std::size_t map_places = 0) const {
    if (min_score) return *min_score;
    if (calibration) return calibration->threshold(false_accept_rate, map_places).score;
    if (!(false_accept_rate > 0.0 && false_accept_rate <= 1.0)) {
      throw InvalidValue("a false-accept rate must be in (0, 1]");
    }
    const auto asked = static_cast<double>(std::max<std::size_t>(places, 1));
    return std::log10(asked / false_accept_rate) - (with_views ? surplus : surplus_without_views);
  }
};

}  // namespace v0
}  // namespace topobag
