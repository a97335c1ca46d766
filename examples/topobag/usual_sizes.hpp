// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/class_catalog.hpp>

#include "node_table.hpp"

namespace program {

/// How many times as large as things of their classes are the objects that boxes and depths make,
/// in the middle of all; nothing where too few are of a class of COCO's whose things are of about
/// one size.
std::optional<double> size_factor(const std::vector<FrameRow>& frames,
                                  const topobag::PinholeCamera<>& camera,
                                  const topobag::ClassCatalog& catalog, double min_confidence);

/// Doubts depths and focal length where that is far from once, in a sentence without its full stop;
/// empty where it is not.
/// @param of_depths  what may be wrong of the depths, as a question
std::string size_doubt_text(const std::vector<FrameRow>& frames,
                            const topobag::PinholeCamera<>& camera,
                            const topobag::ClassCatalog& catalog, double min_confidence,
                            const std::string& of_depths);

}  // namespace program
