// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "json_output.hpp"

namespace program {

/// The page that shows a map in three dimensions: one HTML file that needs no other.
/// @param view  as `map_view` makes it
std::string view_page(const Json& view);

/// The page's parts, of the files in `view/page`.
extern const char* const view_style;   ///< CSS
extern const char* const view_body;    ///< HTML
extern const char* const view_script;  ///< JavaScript

}  // namespace program
