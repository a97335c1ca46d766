// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <topobag/types/class_catalog.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/label_weights.hpp>

#include "csv_reader.hpp"

namespace program {

/// The column `labels` of a node table: what else an object may be, each class with its weight,
/// `cup=0.6|bowl=0.4`, on any scale; empty = the class alone. In bytes as they are kept.
std::string labels_text(const topobag::LabelWeights& weights, const topobag::ClassCatalog& catalog);

/// Reads it; none where the table has no such column. Throws topobag::Error with the line for a
/// class that the catalog does not hold, a weight that is none, and where another class than
/// `label` has most.
topobag::LabelWeights read_labels(const CsvReader& csv, std::optional<std::size_t> column,
                                  topobag::ClassId label, const topobag::ClassCatalog& catalog);

}  // namespace program
