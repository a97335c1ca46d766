// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/view.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Whether there is any depth to be written.
template <typename Scalar>
bool any_depth(const std::vector<View<Scalar>>& views) {
  return std::any_of(views.begin(), views.end(), [](const auto& view) { return !!view.depth; });
}

/// Writes how far each view sees: whether that is known, and the levels of its grid.
template <typename Scalar>
void put_depths(BitWriter& writer, const std::vector<View<Scalar>>& views) {
  using Depth = View<>::Depth;
  for (const View<Scalar>& view : views) {
    writer.put(view.depth ? 1 : 0, 1);
    if (!view.depth) continue;
    for (const Depth::Level level : view.depth->levels()) {
      writer.put(level, Depth::level_bits);
    }
  }
}

/// Reads it for each of the views. Throws FormatError.
template <typename Scalar>
void get_depths(BitReader& reader, std::vector<View<Scalar>>& views) {
  using Depth = View<>::Depth;
  for (View<Scalar>& view : views) {
    if (reader.get(1) == 0) continue;
    const auto& camera = view.camera;
    if (camera.width < 1 || camera.height < 1) {
      throw FormatError("a view has depths but no image: the data are damaged");
    }
    Depth::Levels levels;
    for (Depth::Level& level : levels) {
      level = static_cast<Depth::Level>(reader.get(Depth::level_bits));
    }
    view.depth.emplace(levels, camera.width, camera.height);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
