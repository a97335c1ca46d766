// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace program {

/// What each file of scores is called: by its name, or by its path where two have one name. Throws
/// InputError where a file is given twice.
std::vector<std::string> score_names(const std::vector<std::string>& paths);

}  // namespace program
