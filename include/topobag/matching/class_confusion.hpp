// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include <topobag/error.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// What `ClassConfusion` believes before it has counted anything, in counts a class.
struct ConfusionPrior {
  double same = 9.0;         ///< that an object keeps its class
  double other = 1.0;        ///< that it gets another one, shared evenly by
  std::size_t classes = 80;  ///< the number of classes, this one with them
};

/// How often an object that the map calls one class is called another by the query's detector:
/// counts of label pairs of one object each, given or learnt (`learn_confusion.hpp`), as
/// probabilities under a Dirichlet prior.
///
///     options.chance.confusion = confusion;                  // what such a pair costs
///     options.consistency.classes = confusion.groups(0.02);  // which pairs are offered
class ClassConfusion {
 public:
  /// Throws InvalidValue unless the prior's counts are positive and finite and its classes two or
  /// more.
  explicit ClassConfusion(const ConfusionPrior& prior = {}) : prior_(prior) {
    require_count(prior.same);
    require_count(prior.other);
    if (prior.classes < 2) throw InvalidValue("a confusion needs at least two classes");
  }

  /// Counts an object that is `candidate` in the map and `query` in the query. A matrix of known
  /// probabilities is given as counts: the number of objects it rests on times each of them.
  /// Throws InvalidValue for a count that is not positive and finite. O(log pairs).
  void add(ClassId candidate, ClassId query, double count = 1.0) {
    require_count(count);
    counts_[{candidate, query}] += count;
    totals_[candidate] += count;
  }

  /// P(the query's label | the candidate's, one object), in (0, 1); sums to 1 over the prior's
  /// classes. O(log pairs).
  double probability(ClassId candidate, ClassId query) const {
    const auto seen = counts_.find({candidate, query});
    const auto total = totals_.find(candidate);
    const double expected = candidate == query
                                ? prior_.same
                                : prior_.other / (static_cast<double>(prior_.classes) - 1.0);
    return ((seen == counts_.end() ? 0.0 : seen->second) + expected) /
           ((total == totals_.end() ? 0.0 : total->second) + prior_.same + prior_.other);
  }

  /// −log10 of it.
  double cost(ClassId candidate, ClassId query) const {
    return -std::log10(probability(candidate, query));
  }

  /// `base` with all pairs joined that were counted and have at least this probability, one way or
  /// the other. O(pairs · classes).
  ClassGroups groups(double min_probability, ClassGroups base = {}) const {
    for (const auto& [labels, count] : counts_) {
      const auto& [candidate, query] = labels;
      if (candidate != query && probability(candidate, query) >= min_probability) {
        base.join(candidate, query);
      }
    }
    return base;
  }

 private:
  static void require_count(double count) {
    if (!(count > 0.0) || !std::isfinite(count)) {
      throw InvalidValue("a confusion's counts must be positive and finite");
    }
  }

  ConfusionPrior prior_;
  std::map<std::pair<ClassId, ClassId>, double> counts_;  // candidate's label, query's
  std::map<ClassId, double> totals_;                      // by candidate's label
};

}  // namespace v0
}  // namespace topobag
