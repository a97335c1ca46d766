// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// How often `part` stands in `text`.
inline std::size_t times(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

/// The addresses in a page, but for the name of SVG.
inline std::vector<std::string> references(const std::string& page) {
  std::vector<std::string> found;
  for (std::size_t at = page.find("://"); at != std::string::npos; at = page.find("://", at + 1)) {
    const std::string address = page.substr(at < 8 ? 0 : at - 8, 40);
    if (address.find("http://www.w3.org/2000/svg") == std::string::npos) found.push_back(address);
  }
  return found;
}
