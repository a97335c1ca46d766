// SPDX-License-Identifier: MIT
#include "depth_column.hpp"

#include <string_view>

namespace program {
namespace {

constexpr std::string_view letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
static_assert(letters.size() == 1U << topobag::DepthGrid::level_bits);

}  // namespace

std::string depth_text(const topobag::DepthGrid::Levels& levels) {
  std::string text;
  for (const topobag::DepthGrid::Level level : levels) text += letters[level];
  return text;
}

std::optional<topobag::DepthGrid::Levels> read_depth(const CsvReader& csv,
                                                     std::optional<std::size_t> column) {
  if (!column || csv.text(*column).empty()) return std::nullopt;
  const std::string_view text = csv.text(*column);
  topobag::DepthGrid::Levels levels{};
  if (text.size() != levels.size()) {
    throw csv.error("depth has to be " + std::to_string(levels.size()) + " characters, not " +
                    std::to_string(text.size()));
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::size_t level = letters.find(text[i]);
    if (level == std::string_view::npos) {
      throw csv.error("depth holds '" + std::string(1, text[i]) + "', which is not of base64");
    }
    levels[i] = static_cast<topobag::DepthGrid::Level>(level);
  }
  return levels;
}

}  // namespace program
