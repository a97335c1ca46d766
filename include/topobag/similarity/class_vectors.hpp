// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/sparse_histogram.hpp>
#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// What stands for each class in place of its label number: a one-hot vector, in which no class is
/// nearer to another than a third, or a vector of the user's, such as a word embedding.
class ClassVectors {
 public:
  /// Sets the vector of a class. Throws InvalidValue unless all of it is finite and not all is
  /// zero. Classes without a vector stay one-hot, at right angles to every other.
  /// @param vector  any Eigen vector of double
  template <typename Derived>
  void set(ClassId label, const Eigen::MatrixBase<Derived>& vector) {
    if (!vector.allFinite() || vector.isZero(0.0)) {
      throw InvalidValue("the vector of class " + std::to_string(value(label)) +
                         " has to be finite and not zero");
    }
    std::vector<SparseHistogram::Entry> entries;
    for (Eigen::Index i = 0; i < vector.size(); ++i) {
      entries.push_back(
          {detail::histogram_word(dimension, static_cast<std::uint64_t>(i)), vector[i]});
    }
    vectors_[label] = SparseHistogram(std::move(entries)).normalized();
  }

  /// Of length 1.
  SparseHistogram operator()(ClassId label) const {
    const auto it = vectors_.find(label);
    if (it != vectors_.end()) return it->second;
    return SparseHistogram({{detail::histogram_word(label), 1.0}});
  }

 private:
  static constexpr std::uint64_t dimension = 1;  ///< keeps the words of dimensions and labels apart

  std::map<ClassId, SparseHistogram> vectors_;
};

}  // namespace v0
}  // namespace topobag
