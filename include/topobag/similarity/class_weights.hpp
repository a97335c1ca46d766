// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>

#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// How much a node of each class says about the place: 1 for every class until set or learnt.
class ClassWeights {
 public:
  ClassWeights() = default;

  /// The inverse document frequency of each class in a background set of N graphs: 1 + ln((1 + N) /
  /// (1 + n_c)) where n_c of them hold the class (tf-idf of Sivic and Zisserman, ICCV 2003,
  /// smoothed so that none is 0). A class never seen weighs most. Learn it from many places: within
  /// one, the objects that make it up look common. O(nodes · log classes).
  /// @param background  a range of graphs
  template <typename Graphs>
  static ClassWeights idf(const Graphs& background) {
    std::map<ClassId, std::size_t> holders;
    std::size_t graphs = 0;
    for (const auto& graph : background) {
      ++graphs;
      std::set<ClassId> classes;
      for (const auto& node : graph.nodes()) classes.insert(node.label);
      for (const ClassId label : classes) ++holders[label];
    }
    const auto weight = [&](std::size_t holding) {
      return 1.0 +
             std::log((1.0 + static_cast<double>(graphs)) / (1.0 + static_cast<double>(holding)));
    };
    ClassWeights weights;
    weights.others_ = weight(0);
    for (const auto& [label, holding] : holders) weights.weights_.emplace(label, weight(holding));
    return weights;
  }

  /// Sets one weight; 0 makes the class count for nothing. Throws InvalidValue unless it lies in
  /// [0, 10¹⁰⁰]: sums of products of weights have to be finite.
  void set(ClassId label, double weight) {
    if (!(weight >= 0.0 && weight <= 1e100)) {
      throw InvalidValue("the weight of class " + std::to_string(value(label)) +
                         " has to be finite (1e100 at most) and not negative");
    }
    weights_[label] = weight;
  }

  /// The weight of a class. O(log classes).
  double operator()(ClassId label) const {
    const auto it = weights_.find(label);
    return it == weights_.end() ? others_ : it->second;
  }

 private:
  std::map<ClassId, double> weights_;
  double others_ = 1.0;  ///< of the classes not in `weights_`
};

}  // namespace v0
}  // namespace topobag
