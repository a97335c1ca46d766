// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "data_table.hpp"

namespace program {

/// One figure of a report.
struct Figure {
  std::string id;       ///< unique on its page; letters, digits and hyphens
  std::string title;    ///< plain text
  std::string caption;  ///< plain text: what is drawn, and the numbers that matter
  std::string drawing;  ///< HTML
  DataTable table{};
  bool wide = false;  ///< over the whole width of the page
  Json drawn = {};    ///< what the page's script draws, where it does
};

}  // namespace program
