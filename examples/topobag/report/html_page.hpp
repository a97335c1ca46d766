// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "figure.hpp"

namespace program {

/// What a report says, in plain text but for the figures' drawings.
struct Report {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts{};  ///< name and value
  std::vector<std::string> notes{};                          ///< such as what could not be drawn
  std::vector<Figure> figures{};
};

/// The report as one HTML file that needs no other: light and dark, for the screen and for print.
/// Its numbers are in the page as JSON, and offered as JSON and CSV by links.
std::string html_page(const Report& report);

/// The numbers of all figures, by the figures' ids.
Json report_json(const Report& report);

/// The page's parts.
extern const char* const page_style;   ///< CSS
extern const char* const page_script;  ///< JavaScript

}  // namespace program
