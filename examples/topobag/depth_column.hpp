// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <topobag/sensing/depth_grid.hpp>

#include "csv_reader.hpp"

namespace program {

/// The column `depth` of a table's frames: how far the camera sees in each of 10 × 8 cells, a
/// character a cell, row by row from the upper left (see `topobag::DepthGrid`). The characters are
/// base64's, A = not measured; empty = not known.
std::string depth_text(const topobag::DepthGrid::Levels& levels);

/// Reads it; nothing where the table has no such column, or the frame no depth. Throws InputError.
std::optional<topobag::DepthGrid::Levels> read_depth(const CsvReader& csv,
                                                     std::optional<std::size_t> column);

}  // namespace program
