// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/bag/detail/codec/node_layout.hpp>
#include <topobag/error.hpp>
#include <topobag/types/label_weights.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Whether a node of these may be of several classes.
template <typename Scalar>
bool any_weights(const std::vector<SemanticNode<Scalar>>& nodes) noexcept {
  for (const SemanticNode<Scalar>& node : nodes) {
    if (!node.label_weights.empty()) return true;
  }
  return false;
}

/// Writes what the nodes may be that may be of several classes: their number less two, and of each
/// its class and its weight, but of the first, which is 255.
template <typename Scalar>
void put_label_weights(BitWriter& writer, const std::vector<SemanticNode<Scalar>>& nodes) {
  for (const SemanticNode<Scalar>& node : nodes) {
    const LabelWeights& weights = node.label_weights;
    if (weights.empty()) continue;
    writer.put(weights.size() - 2, 2);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      writer.put_signed(value(weights.label(i)));
      if (i > 0) writer.put(weights.byte(i), 8);
    }
  }
}

/// The same for the nodes of which `has(i)`. Throws FormatError.
template <typename Scalar, typename Has>
void get_label_weights(BitReader& reader, std::vector<SemanticNode<Scalar>>& nodes,
                       const Has& has) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!has(i)) continue;
    const auto count = static_cast<std::size_t>(reader.get(2)) + 2;
    std::vector<WeightedLabel> labels(count);
    for (std::size_t k = 0; k < count; ++k) {
      const std::int64_t label = reader.get_signed();
      if (label < label_range.low || label > label_range.high) {
        throw FormatError("a node may be of a class that is none: the data are damaged");
      }
      labels[k] = {static_cast<ClassId>(label),
                   k == 0 ? 255.0 : static_cast<double>(reader.get(8))};
    }
    const LabelWeights weights(labels);
    bool same = weights.size() == count && has_best_label(nodes[i].label, weights);
    for (std::size_t k = 0; same && k < count; ++k) {
      same = labels[k] == WeightedLabel{weights.label(k), static_cast<double>(weights.byte(k))};
    }
    if (!same) throw FormatError("a node's label weights do not add up: the data are damaged");
    nodes[i].label_weights = weights;
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
