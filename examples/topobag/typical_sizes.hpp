// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <vector>

#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/ids.hpp>

#include "node_table.hpp"

namespace program {

/// Width and height, m, that the objects of a class usually have.
using TypicalSizes = std::map<topobag::ClassId, std::array<double, 2>>;

/// A box at its depth more than so many times as large as is typical, or as small, is not believed.
inline constexpr double max_size_factor = 4.0;

/// Makes the depth of every detection unknown with which the diagonal of its box would be that far
/// from its class's: the box is another object's, or the depth that of something before it or
/// behind.
void disbelieve_depths(const topobag::PinholeCamera<>& camera, const TypicalSizes& sizes,
                       std::vector<FrameRow>& frames);

}  // namespace program
