// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <topobag/error.hpp>
#include <topobag/matching/appearance_model.hpp>
#include <topobag/recognition/calibration_conditions.hpp>
#include <topobag/recognition/false_scores.hpp>

namespace topobag {
inline namespace v0 {

/// What a calibration goes by.
enum class CalibrationSource { null_model, certain_negatives };

/// In words, for a report.
inline const char* to_string(CalibrationSource source) noexcept {
  return source == CalibrationSource::null_model ? "null model" : "certain negatives";
}

/// When certain negatives are enough, and what is expected beforehand.
struct CalibrationOptions {
  std::size_t min_negatives = 200;  ///< certain negatives from which on the null model is left
  double prior = 0.5;               ///< share of queries that are of a place in the map
  double max_repeats = 0.02;  ///< share of certain negatives beyond chance that still carries over
};

/// Whether what a map taught holds for other places too.
struct CarryOver {
  double repeats = 0.0;  ///< share of certain negatives that look like a place, against chance
  std::string reason{};  ///< why it does not carry over, a sentence; empty when nothing says so

  /// Whether nothing speaks against it.
  explicit operator bool() const noexcept { return reason.empty(); }
};

/// How many places of a map the queries asked that a calibration rests on.
struct AskedPlaces {
  std::size_t queries = 0;  ///< that say it
  std::size_t places = 0;   ///< all of theirs together

  /// Of one query; 0 when none says it.
  double mean() const noexcept {
    return queries == 0 ? 0.0 : static_cast<double>(places) / static_cast<double>(queries);
  }
};

/// Turns scores into what a user can bear: a false-accept rate, and the probability that an
/// accepted match is true.
///
/// It learns from queries that are known to be false: by the poses in the world, or because the
/// front end says which key frames cannot be the query's place (`certain_negatives.hpp`); until
/// there are enough of them, a null model serves (`null_model.hpp`). The queries of one map
/// overlap, so they count for fewer than they are.
///
/// A query asks every place of the map, and each may match it falsely: of n times as many places as
/// were learnt from, n times as many false matches are expected at every score. Rates that are
/// asked for with the `places` of the map that is looked up in are therefore n times those learnt,
/// n its places over the mean of the queries learnt from (`asked_places`); as scores are −log10 of
/// odds, the threshold rises by log10 n where false scores fall as chance's do, by more where they
/// fall less steeply, as a map's repetitions do. In a smaller map n stays 1: which of the places
/// learnt from gave the false matches is not known, and they may be those that are left. Without
/// `places`, or where no query told its own, rates are of maps of about the size learnt from.
class Calibration {
 public:
  /// Throws InvalidValue unless the prior is in (0, 1) and the share of repeats in [0, 1].
  explicit Calibration(const CalibrationOptions& options = {}) : options_(options) {
    if (!(options.prior > 0.0 && options.prior < 1.0)) {
      throw InvalidValue("the prior of a true place must be in (0, 1)");
    }
    if (!(options.max_repeats >= 0.0 && options.max_repeats <= 1.0)) {
      throw InvalidValue("the share of repeats that carries over must be in [0, 1]");
    }
  }

  /// What another one's `options`, `negative_scores`, `null_scores` and `repeats` told. Throws
  /// InvalidValue as above, and when more negatives are beyond chance than have a score.
  Calibration(const CalibrationOptions& options, FalseScores negatives, FalseScores null,
              std::size_t repeats)
      : Calibration(options) {
    if (repeats > negatives.scores().size()) {
      throw InvalidValue("there are more repeats than scores of certain negatives");
    }
    negatives_ = std::move(negatives);
    null_ = std::move(null);
    repeats_ = repeats;
  }

  /// A query of a place elsewhere; see `false_score` and `false_score_by_pose`.
  /// @param beyond_chance  a decision without calibration would ask for no higher score
  /// @param places         of the map that it asked; 0 = not told
  void add_negative(std::optional<double> score, bool beyond_chance = false,
                    std::size_t places = 0) {
    negatives_.add(score);
    if (score && beyond_chance) ++repeats_;
    add_places(places);
  }

  /// A query of a layout that is nowhere.
  /// @param places  of the map that it asked; 0 = not told
  void add_null(std::optional<double> score, std::size_t places = 0) {
    null_.add(score);
    add_places(places);
  }

  /// Certain negatives that were added.
  std::size_t negatives() const noexcept { return negatives_.size(); }

  /// What the answers go by at present.
  CalibrationSource source() const noexcept {
    return negatives_.size() >= options_.min_negatives ? CalibrationSource::certain_negatives
                                                       : CalibrationSource::null_model;
  }

  /// Queries that answers rest on.
  std::size_t queries() const noexcept { return current().size(); }

  /// The score to ask for when this share of false queries may be accepted. Extrapolated for a
  /// rate below one in the queries seen; from none seen it follows the chance model alone. Throws
  /// InvalidValue unless the rate is in (0, 1].
  /// @param places  of the map that is looked up in; 0 = about as many as learnt from
  ScoreThreshold threshold(double false_accept_rate, std::size_t places = 0) const {
    const bool is_share = false_accept_rate <= 1.0;  // else it is refused as it is
    return current().threshold(is_share ? false_accept_rate / growth(places) : false_accept_rate);
  }

  /// The share of false queries that reach `score`.
  /// @param places  as of `threshold`
  FalseAcceptRate false_accept_rate(double score, std::size_t places = 0) const {
    FalseAcceptRate seen = current().rate(score);
    seen.rate = std::min(1.0, growth(places) * seen.rate);
    return seen;
  }

  /// P(true | a query reaches `score`) by Bayes' rule, were every true query to reach it. The
  /// rate is never taken for less than 1 / (queries + 1): so many false ones say no more, however
  /// high the score; none seen, it is the prior.
  /// @param places  as of `threshold`
  double probability(double score, std::size_t places = 0) const {
    const double least = 1.0 / (static_cast<double>(queries()) + 1.0);
    const double rate =
        std::min(1.0, growth(places) * std::max(false_accept_rate(score).rate, least));
    return options_.prior / (options_.prior + (1.0 - options_.prior) * rate);
  }

  /// Whether `score` lies beyond every false score seen, so that its probability is the most that
  /// this many queries can say.
  bool is_extrapolated(double score) const { return false_accept_rate(score).extrapolated; }

  /// Whether the map speaks against using this elsewhere: it does when more than `max_repeats` of
  /// the certain negatives reach the score that a decision without calibration asks for, which
  /// chance does about once in a thousand queries. Then layouts repeat in the map, the scores
  /// learnt are those of its own repetitions, and another place's are others. Without poses it
  /// takes a front end that says which key frames are of other places: the null model knows no
  /// repetitions. Its layouts are strewn anew: of 200 of them 0 to 4 reach that score in warehouses
  /// where all racks are alike, none in forty rooms of four kinds.
  CarryOver carries_over() const {
    CarryOver answer;
    if (negatives_.size() == 0) return answer;
    answer.repeats = static_cast<double>(repeats_) / static_cast<double>(negatives_.size());
    if (answer.repeats > options_.max_repeats) {
      answer.reason = std::to_string(repeats_) + " of " + std::to_string(negatives_.size()) +
                      " queries match another place better than chance does: layouts repeat, so "
                      "what was learnt here may not hold elsewhere.";
    }
    return answer;
  }

  /// Keeps what looks say, with which the scores were made (`CalibrateOptions::appearance`).
  /// Recognition judges looks by it from then on, whatever `MatchOptions::chance` says
  /// (`appearance_model`), and refuses a map whose looks are of another kind. Throws as its
  /// `validate`.
  void set_appearance(AppearanceModel model) {
    model.validate();
    appearance_ = std::move(model);
  }

  /// What looks say; nothing where that was not learnt.
  const std::optional<AppearanceModel>& appearance() const noexcept { return appearance_; }

  /// Keeps how many places the queries asked. Throws InvalidValue when there are fewer than queries
  /// that say so, or fewer queries than those.
  void set_asked_places(const AskedPlaces& asked) {
    const std::size_t beside = asked.queries - std::min(asked.queries, negatives_.size());
    if (asked.places < asked.queries || beside > null_.size()) {
      throw InvalidValue("the queries of a calibration cannot have asked so many places");
    }
    asked_ = asked;
  }

  /// How many places the queries asked, certain negatives and the null model's alike.
  const AskedPlaces& asked_places() const noexcept { return asked_; }

  /// States what the graphs that it learnt from were made with, for its host.
  void set_conditions(CalibrationConditions conditions) { conditions_ = std::move(conditions); }

  /// What is stated of that; it has no say in any answer.
  const CalibrationConditions& conditions() const noexcept { return conditions_; }

  /// What it was made with.
  const CalibrationOptions& options() const noexcept { return options_; }

  /// Of the certain negatives.
  const FalseScores& negative_scores() const noexcept { return negatives_; }

  /// Of the layouts that are nowhere.
  const FalseScores& null_scores() const noexcept { return null_; }

  /// Certain negatives that were beyond chance.
  std::size_t repeats() const noexcept { return repeats_; }

 private:
  void add_places(std::size_t places) {
    if (places == 0) return;
    ++asked_.queries;
    asked_.places += places;
  }

  /// How many times the places learnt from, at least once.
  double growth(std::size_t places) const noexcept {
    if (places == 0 || asked_.queries == 0) return 1.0;
    return std::max(1.0, static_cast<double>(places) / asked_.mean());
  }

  const FalseScores& current() const noexcept {
    return source() == CalibrationSource::certain_negatives ? negatives_ : null_;
  }

  CalibrationOptions options_;
  FalseScores negatives_;
  FalseScores null_;
  std::size_t repeats_ = 0;
  AskedPlaces asked_;
  CalibrationConditions conditions_;
  std::optional<AppearanceModel> appearance_;
};

}  // namespace v0
}  // namespace topobag
