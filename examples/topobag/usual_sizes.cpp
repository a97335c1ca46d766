// SPDX-License-Identifier: MIT
#include "usual_sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string_view>
#include <utility>

namespace program {
namespace {

/// The diagonal of what a camera sees of such a thing from in front, m: round figures of common
/// things.
constexpr std::array<std::pair<std::string_view, double>, 20> usual_diagonals{{
    {"bicycle", 1.8},   {"car", 4.0},       {"chair", 1.0},        {"couch", 2.0},
    {"bed", 2.2},       {"toilet", 0.8},    {"tv", 0.75},          {"laptop", 0.42},
    {"mouse", 0.12},    {"keyboard", 0.45}, {"cell phone", 0.16},  {"book", 0.3},
    {"cup", 0.13},      {"bottle", 0.27},   {"refrigerator", 1.8}, {"potted plant", 0.6},
    {"microwave", 0.6}, {"sink", 0.6},      {"bowl", 0.2},         {"backpack", 0.5},
}};

double usual_diagonal(const std::string& name) {
  const auto found = std::find_if(usual_diagonals.begin(), usual_diagonals.end(),
                                  [&](const auto& usual) { return usual.first == name; });
  return found == usual_diagonals.end() ? 0.0 : found->second;
}

}  // namespace

std::optional<double> size_factor(const std::vector<FrameRow>& frames,
                                  const topobag::PinholeCamera<>& camera,
                                  const topobag::ClassCatalog& catalog, double min_confidence) {
  std::vector<double> factors;
  for (const FrameRow& frame : frames) {
    for (const topobag::RangedDetection& seen : frame.detections) {
      if (!(seen.z > 0.0) || seen.confidence < min_confidence) continue;
      const double usual = usual_diagonal(catalog.name(seen.label));
      if (usual == 0.0) continue;
      factors.push_back(
          seen.z * std::hypot(seen.box.width() / camera.fx, seen.box.height() / camera.fy) / usual);
    }
  }
  const std::size_t few = 30;
  if (factors.size() < few) return std::nullopt;
  const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
  std::nth_element(factors.begin(), middle, factors.end());
  return *middle;
}

std::string size_doubt_text(const std::vector<FrameRow>& frames,
                            const topobag::PinholeCamera<>& camera,
                            const topobag::ClassCatalog& catalog, double min_confidence,
                            const std::string& of_depths) {
  const double far = 2.5;  // times; 0.9 to 1.3 in recordings of desks, offices and rooms
  const std::optional<double> factor = size_factor(frames, camera, catalog, min_confidence);
  if (!factor || (*factor<far&& * factor * far> 1.0)) return "";
  std::ostringstream text;
  text.precision(2);
  text << "objects are " << *factor
       << " times as large as things of their classes are, in the median: " << of_depths
       << ", and the focal length that of the images?";
  return text.str();
}

}  // namespace program
