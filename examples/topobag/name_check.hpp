// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

namespace program {

/// Takes one of the names, in any case, for the value behind it, and says of any other which there
/// are.
template <typename Value>
CLI::Validator one_of(const std::map<std::string, Value>& names) {
  std::string all;
  for (const auto& [name, value] : names) all += (all.empty() ? "" : ", ") + name;
  return {[names, all](std::string& text) {
            const auto found = names.find(CLI::detail::to_lower(text));
            if (found == names.end()) return "'" + text + "' is none of " + all;
            text = std::to_string(static_cast<int>(found->second));
            return std::string();
          },
          all};
}

}  // namespace program
