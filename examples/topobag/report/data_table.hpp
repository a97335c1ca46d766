// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "json_output.hpp"

namespace program {

/// Rows of values under named columns.
struct DataTable {
  std::vector<std::string> columns{};
  std::vector<Json> rows{};  ///< arrays as long as `columns`
};

Json to_json(const DataTable& table);

/// With a header row; null is an empty field.
std::string to_csv(const DataTable& table);

}  // namespace program
