// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <topobag/bag/entry_info.hpp>
#include <topobag/error.hpp>
#include <topobag/types/image_descriptor.hpp>

namespace topobag {
inline namespace v0 {

/// What the images as a whole have to say in a query, beside the graphs. By default nothing, and
/// nothing of an entry, or of a query, whose image is not known.
struct ImageComparison {
  ImageDescriptor query{};       ///< of the query's image
  double min_similarity = -1.0;  ///< cosine below which an entry is not asked; −1 = all are
  /// In [0, 1]: an entry's similarity is (1 − weight) · s + weight · max(0, cosine) for graphs that
  /// are s alike; s where its image is not known.
  double weight = 0.0;

  /// Whether an entry might not be asked for its image.
  bool restricts() const noexcept { return query.known() && min_similarity > -1.0; }
  /// Whether the images count in the similarity.
  bool scores() const noexcept { return query.known() && weight > 0.0; }

  /// Whether the entry's image is like enough. Throws InvalidValue for a descriptor of another
  /// kind.
  bool admits(const EntryInfo& info) const {
    return !restricts() || !info.image.known() || cosine_with(info.image) >= min_similarity;
  }

  /// The similarity of an entry whose graph is so similar. Throws as `admits`. O(length).
  double score(double graphs, const ImageDescriptor& image) const {
    if (!scores() || !image.known()) return graphs;
    return (1.0 - weight) * graphs + weight * std::max(0.0, cosine_with(image));
  }

  /// Throws InvalidValue for a weight that is not in [0, 1], and a query's descriptor of another
  /// kind than the bag's.
  void validate(ImageKind of_bag) const {
    if (!(weight >= 0.0 && weight <= 1.0)) {
      throw InvalidValue("the weight of the images in a similarity must be in [0, 1]");
    }
    common_kind(of_bag, query.kind(), "the query");
  }

 private:
  double cosine_with(const ImageDescriptor& image) const {
    common_kind(query.kind(), image.kind(), "the entry");
    return cosine_similarity(query, image);
  }
};

}  // namespace v0
}  // namespace topobag
