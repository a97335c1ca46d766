// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <topobag/types/class_catalog.hpp>

#include "node_table.hpp"

namespace program {

/// Reads `set`.frames.csv and, in place of boxes, `set`.clusters.csv: idx (of the frame), class, conf,
/// x, y, z (centroid, m), dx, dy, dz (extent, m) and optionally sx, sy, sz (standard deviations of
/// the centroid, m), all along the axes of the sensor, whose poses the frames have: x forward, y
/// left, z up. Further columns are ignored. Throws topobag::Error with the file and the line.
NodeTable read_cluster_table(const std::string& set, const topobag::ClassCatalog& catalog);

}  // namespace program
