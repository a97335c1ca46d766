// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/savable_graph.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/image_descriptor.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The one kind of descriptors that a bag has with a graph's; unknown for a graph that is not
/// topobag's. Throws InvalidValue when they are of two kinds.
template <typename Graph>
AppearanceKind kind_with([[maybe_unused]] const AppearanceKind& known,
                         [[maybe_unused]] const Graph& graph) {
  if constexpr (is_topology_graph_v<Graph>) {
    return common_kind(known, graph.appearance_kind(), "the key frame");
  } else {
    return {};
  }
}

/// Of all descriptors in a bag: those of objects, and those of whole images.
struct DescriptorKinds {
  AppearanceKind appearance;
  ImageKind image;

  /// With those of one more entry. Throws InvalidValue when they are of other kinds.
  template <typename Graph>
  DescriptorKinds with(const Graph& graph, const EntryInfo& info) const {
    return {kind_with(appearance, graph), common_kind(image, info.image.kind(), "the key frame")};
  }
  /// With those of another bag. Throws the same.
  DescriptorKinds with(const DescriptorKinds& other) const {
    return {common_kind(appearance, other.appearance, "the other bag"),
            common_kind(image, other.image, "the other bag")};
  }
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
