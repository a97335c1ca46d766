// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include <topobag/types/ids.hpp>
#include <topobag/types/label_weights.hpp>

namespace topobag {
inline namespace v0 {

/// What the sightings of an object say together that it is: the mean of what each says, weighted by
/// its confidence.
class LabelSum {
 public:
  /// @param weights  none: it says `label` alone
  void add(ClassId label, const LabelWeights& weights, double confidence) {
    if (weights.empty()) sums_[label] += confidence;
    if (!weights.empty()) any_weights_ = true;
    double total = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) total += weights.byte(i);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      sums_[weights.label(i)] += confidence * weights.byte(i) / total;
    }
  }

  /// The class with most behind it; ties go to the smaller number. Precondition: something was
  /// added.
  ClassId label() const {
    auto most = sums_.begin();
    for (auto sum = sums_.begin(); sum != sums_.end(); ++sum) {
      if (sum->second > most->second) most = sum;
    }
    return most->first;
  }

  /// What it may be; none where no sighting had any: labels that change are the detector's whim.
  LabelWeights weights() const {
    if (!any_weights_) return {};
    std::vector<WeightedLabel> all;
    for (const auto& [label, weight] : sums_) all.push_back({label, weight});
    return LabelWeights(all);
  }

 private:
  std::map<ClassId, double> sums_;
  bool any_weights_ = false;
};

}  // namespace v0
}  // namespace topobag
