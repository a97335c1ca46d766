// SPDX-License-Identifier: MIT
#include "docs.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>

namespace python {

const char* doc(const char* name) {
  static const std::unordered_map<std::string_view, const char*> comments{
#include "docstrings.inc"
  };
  const auto found = comments.find(name);
  if (found == comments.end()) {
    throw std::out_of_range("no header documents " + std::string(name));
  }
  return found->second;
}

}  // namespace python
