// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include <topobag/error.hpp>
#include <topobag/recognition/false_scores.hpp>

namespace topobag {
inline namespace v0 {

/// What a calibration goes by.
enum class CalibrationSource { null_model, certain_negatives };

/// When certain negatives are enough, and what is expected beforehand.
struct CalibrationOptions {
  std::size_t min_negatives = 200;  ///< certain negatives from which on the null model is left
  double prior = 0.5;               ///< share of look-ups that are of a place in the map
};

/// Turns scores into what a user can bear: a false-accept rate, and the probability that an
/// accepted match is true.
///
/// It learns from look-ups that are known to be false: the front end says which key frames cannot
/// be the query's place; until it has said so often enough, a null model serves
/// (`null_model.hpp`). All rates are of look-ups in maps of about the size learnt from.
class Calibration {
 public:
  /// Throws InvalidValue unless the prior is in (0, 1).
  explicit Calibration(const CalibrationOptions& options = {}) : options_(options) {
    if (!(options.prior > 0.0 && options.prior < 1.0)) {
      throw InvalidValue("the prior of a true place must be in (0, 1)");
    }
  }

  /// A look-up among key frames that cannot be its place; see `false_score`.
  void add_negative(std::optional<double> score) { negatives_.add(score); }

  /// A look-up of a layout that is nowhere.
  void add_null(std::optional<double> score) { null_.add(score); }

  /// Certain negatives that were added.
  std::size_t negatives() const noexcept { return negatives_.size(); }

  /// What the answers go by at present.
  CalibrationSource source() const noexcept {
    return negatives_.size() >= options_.min_negatives ? CalibrationSource::certain_negatives
                                                       : CalibrationSource::null_model;
  }

  /// Look-ups that answers rest on.
  std::size_t look_ups() const noexcept { return current().size(); }

  /// The score to ask for when this share of false look-ups may be accepted. Extrapolated for a
  /// rate below one in the look-ups seen; from none seen it follows the chance model alone.
  ScoreThreshold threshold(double false_accept_rate) const {
    return current().threshold(false_accept_rate);
  }

  /// The share of false look-ups that reach `score`.
  FalseAcceptRate false_accept_rate(double score) const { return current().rate(score); }

  /// P(true | a look-up reaches `score`) by Bayes' rule, were every true look-up to reach it.
  double probability(double score) const {
    const double false_share = (1.0 - options_.prior) * false_accept_rate(score).rate;
    return options_.prior / (options_.prior + false_share);
  }

 private:
  const FalseScores& current() const noexcept {
    return source() == CalibrationSource::certain_negatives ? negatives_ : null_;
  }

  CalibrationOptions options_;
  FalseScores negatives_;
  FalseScores null_;
};

}  // namespace v0
}  // namespace topobag
