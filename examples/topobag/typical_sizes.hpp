// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/bag/described_catalog.hpp>
#include <topobag/sensing/pinhole_camera.hpp>

#include "node_table.hpp"

namespace program {

using topobag::TypicalSizes;

/// A box at its depth more than so many times as large as is typical, or as small, is not believed.
inline constexpr double max_size_factor = 4.0;

/// Makes the depth of every detection unknown with which the diagonal of its box would be that far
/// from its class's: the box is another object's, or the depth that of something before it or
/// behind.
void disbelieve_depths(const topobag::PinholeCamera<>& camera, const TypicalSizes& sizes,
                       std::vector<FrameRow>& frames);

}  // namespace program
