// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include <topobag/matching/layout_prior.hpp>
#include <topobag/types/class_catalog.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// At which distances two classes stand, in tenths of places.
struct UsualLayout {
  std::string_view a, b;
  std::array<short, DistanceBins::count> level, spatial;
};

/// What `learn_layouts` gives for 84 rooms of ScanNet and ScanNet++ (their annotated boxes, seen by
/// a simulated camera) and the desk of TUM's freiburg1 as detected: 1,217 objects, of them the
/// classes that stand together in four places or more.
inline constexpr std::array<UsualLayout, 40> usual_layouts{{
    {"backpack",
     "backpack",
     {0, 0, 0, 0, 0, 0, 20, 0, 10, 10, 20, 10, 0, 0},
     {0, 0, 0, 0, 0, 0, 10, 10, 10, 10, 20, 10, 0, 0}},
    {"backpack",
     "chair",
     {6, 4, 1, 0, 0, 0, 11, 30, 24, 17, 16, 27, 12, 1},
     {0, 4, 2, 4, 0, 0, 11, 28, 26, 17, 17, 27, 13, 2}},
    {"backpack",
     "couch",
     {0, 0, 0, 0, 0, 5, 5, 8, 13, 22, 8, 3, 12, 5},
     {0, 0, 0, 0, 0, 0, 10, 3, 15, 24, 6, 6, 12, 5}},
    {"backpack",
     "potted plant",
     {0, 0, 0, 0, 0, 0, 5, 0, 5, 0, 10, 10, 0, 10},
     {0, 0, 0, 0, 0, 0, 0, 0, 5, 5, 10, 10, 0, 10}},
    {"backpack",
     "bed",
     {0, 0, 0, 1, 0, 2, 2, 0, 8, 4, 15, 12, 6, 0},
     {0, 0, 0, 0, 0, 0, 1, 4, 4, 8, 16, 12, 6, 0}},
    {"backpack",
     "dining table",
     {2, 0, 0, 0, 0, 3, 9, 24, 22, 34, 35, 16, 13, 3},
     {2, 0, 0, 0, 0, 0, 0, 29, 24, 38, 34, 17, 13, 3}},
    {"backpack",
     "tv",
     {0, 0, 0, 0, 0, 0, 0, 2, 3, 8, 40, 9, 6, 11},
     {0, 0, 0, 0, 0, 0, 0, 2, 0, 6, 38, 15, 8, 11}},
    {"chair",
     "chair",
     {1, 1, 1, 5, 23, 35, 31, 36, 47, 53, 88, 63, 62, 34},
     {0, 0, 0, 2, 7, 55, 26, 39, 52, 52, 89, 63, 62, 34}},
    {"chair",
     "couch",
     {1, 1, 2, 2, 0, 0, 3, 9, 22, 14, 32, 38, 35, 21},
     {0, 2, 0, 3, 1, 0, 3, 9, 22, 14, 31, 39, 35, 21}},
    {"chair",
     "potted plant",
     {0, 0, 0, 0, 0, 0, 3, 13, 7, 22, 8, 13, 3, 3},
     {0, 0, 0, 0, 0, 0, 0, 5, 14, 24, 7, 13, 5, 3}},
    {"chair",
     "bed",
     {0, 0, 1, 1, 1, 1, 4, 10, 23, 42, 57, 49, 17, 4},
     {0, 0, 1, 0, 1, 0, 5, 11, 22, 43, 56, 49, 18, 4}},
    {"chair",
     "dining table",
     {11, 1, 10, 5, 23, 35, 56, 64, 60, 66, 68, 86, 54, 31},
     {8, 1, 0, 13, 25, 34, 54, 64, 62, 67, 70, 87, 54, 31}},
    {"chair",
     "tv",
     {1, 0, 0, 0, 1, 1, 6, 29, 34, 64, 65, 41, 35, 24},
     {0, 0, 0, 1, 0, 0, 2, 18, 40, 46, 70, 61, 37, 24}},
    {"chair",
     "mouse",
     {0, 0, 0, 0, 2, 1, 6, 10, 5, 5, 10, 18, 4, 10},
     {0, 0, 0, 0, 0, 2, 7, 5, 10, 4, 10, 18, 4, 10}},
    {"chair",
     "keyboard",
     {1, 0, 1, 0, 1, 6, 4, 18, 10, 3, 24, 18, 9, 16},
     {0, 0, 0, 0, 1, 6, 4, 16, 13, 3, 24, 18, 9, 16}},
    {"chair",
     "refrigerator",
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 11, 20, 7, 12, 20},
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 11, 20, 7, 12, 20}},
    {"couch",
     "couch",
     {2, 0, 10, 0, 11, 34, 25, 20, 28, 17, 7, 13, 1, 2},
     {2, 0, 0, 10, 6, 35, 29, 20, 29, 17, 7, 13, 1, 2}},
    {"couch",
     "potted plant",
     {0, 0, 0, 0, 0, 0, 0, 0, 2, 2, 4, 2, 14, 16},
     {0, 0, 0, 0, 0, 0, 0, 0, 2, 2, 4, 1, 15, 16}},
    {"couch",
     "bed",
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 6, 8, 25, 10},
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 6, 8, 25, 10}},
    {"couch",
     "dining table",
     {0, 0, 0, 0, 0, 1, 4, 11, 12, 20, 37, 35, 27, 13},
     {0, 0, 0, 0, 0, 0, 3, 11, 14, 17, 35, 39, 27, 13}},
    {"couch",
     "tv",
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 28, 32, 34, 6},
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 21, 37, 34, 7}},
    {"couch",
     "refrigerator",
     {0, 0, 0, 0, 0, 0, 0, 0, 1, 4, 3, 2, 11, 20},
     {0, 0, 0, 0, 0, 0, 0, 0, 1, 4, 3, 2, 11, 20}},
    {"potted plant",
     "bed",
     {0, 0, 0, 0, 0, 0, 0, 2, 7, 7, 8, 8, 3, 4},
     {0, 0, 0, 0, 0, 0, 0, 0, 7, 4, 14, 8, 3, 4}},
    {"potted plant",
     "dining table",
     {0, 0, 1, 5, 0, 11, 1, 11, 0, 3, 4, 13, 3, 1},
     {0, 0, 0, 0, 0, 5, 5, 18, 0, 2, 4, 13, 3, 1}},
    {"bed",
     "bed",
     {2, 0, 0, 2, 43, 41, 43, 25, 18, 14, 8, 9, 5, 0},
     {0, 0, 0, 0, 37, 43, 51, 23, 19, 13, 9, 10, 5, 0}},
    {"bed",
     "dining table",
     {0, 0, 0, 0, 0, 0, 1, 4, 20, 56, 52, 38, 9, 11},
     {0, 0, 0, 0, 0, 0, 0, 3, 19, 58, 53, 38, 9, 11}},
    {"bed",
     "tv",
     {0, 0, 0, 0, 0, 0, 0, 0, 6, 18, 36, 33, 17, 0},
     {0, 0, 0, 0, 0, 0, 0, 0, 6, 10, 41, 36, 16, 1}},
    {"dining table",
     "dining table",
     {0, 0, 2, 5, 31, 92, 78, 39, 54, 58, 46, 60, 52, 35},
     {0, 0, 0, 1, 33, 84, 85, 31, 64, 58, 46, 60, 52, 35}},
    {"dining table",
     "tv",
     {2, 1, 1, 0, 15, 12, 26, 19, 30, 25, 52, 46, 24, 28},
     {0, 0, 0, 2, 0, 8, 20, 32, 30, 33, 50, 52, 24, 29}},
    {"dining table",
     "mouse",
     {0, 3, 0, 3, 1, 2, 3, 10, 8, 7, 10, 6, 9, 7},
     {0, 0, 0, 5, 1, 2, 4, 11, 8, 7, 10, 6, 9, 7}},
    {"dining table",
     "keyboard",
     {2, 0, 3, 0, 6, 3, 17, 2, 14, 13, 6, 10, 10, 13},
     {0, 0, 2, 3, 4, 3, 16, 6, 14, 12, 7, 9, 11, 13}},
    {"dining table",
     "refrigerator",
     {0, 0, 0, 0, 0, 0, 0, 0, 2, 20, 20, 11, 15, 13},
     {0, 0, 0, 0, 0, 0, 0, 0, 2, 16, 23, 8, 18, 13}},
    {"tv",
     "tv",
     {3, 0, 0, 0, 13, 29, 56, 17, 11, 13, 30, 21, 14, 23},
     {0, 3, 0, 0, 10, 29, 54, 21, 11, 13, 31, 20, 15, 23}},
    {"tv",
     "mouse",
     {4, 0, 0, 2, 9, 6, 13, 16, 6, 3, 2, 4, 9, 6},
     {0, 0, 0, 4, 2, 8, 11, 25, 7, 3, 2, 4, 9, 6}},
    {"tv",
     "keyboard",
     {5, 1, 0, 6, 14, 10, 12, 4, 9, 10, 7, 6, 15, 11},
     {0, 0, 0, 0, 12, 9, 17, 14, 9, 10, 7, 6, 13, 13}},
    {"tv",
     "refrigerator",
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 8, 15, 10},
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 13, 15, 10}},
    {"mouse",
     "mouse",
     {0, 0, 0, 10, 0, 0, 0, 0, 0, 2, 10, 2, 3, 13},
     {0, 0, 0, 10, 0, 0, 0, 0, 0, 2, 10, 2, 3, 13}},
    {"mouse",
     "keyboard",
     {0, 0, 0, 0, 21, 12, 5, 0, 21, 6, 1, 3, 7, 6},
     {0, 0, 0, 0, 21, 12, 5, 0, 21, 6, 1, 3, 7, 6}},
    {"microwave",
     "refrigerator",
     {0, 0, 0, 0, 0, 0, 0, 0, 7, 18, 15, 20, 0, 0},
     {0, 0, 0, 0, 0, 0, 0, 0, 7, 13, 20, 20, 0, 0}},
    {"refrigerator",
     "refrigerator",
     {0, 3, 13, 10, 3, 17, 3, 0, 0, 10, 0, 0, 0, 0},
     {0, 0, 0, 0, 3, 13, 27, 3, 3, 10, 0, 0, 0, 0}},
}};

inline DistanceCounts places(const std::array<short, DistanceBins::count>& tenths) {
  DistanceCounts counts{};
  for (std::size_t bin = 0; bin < counts.size(); ++bin) counts[bin] = 0.1 * tenths[bin];
  return counts;
}

}  // namespace detail

/// How a catalog's classes usually stand to each other, by their names; pairs of which nothing is
/// known are left out. No default of `recognition_options`: measured, it does not pay.
inline LayoutPrior usual_layouts(const ClassCatalog& catalog) {
  LayoutPrior prior;
  for (const detail::UsualLayout& layout : detail::usual_layouts) {
    const std::optional<ClassId> a = catalog.find(layout.a), b = catalog.find(layout.b);
    if (a && b) prior.add(*a, *b, detail::places(layout.level), detail::places(layout.spatial));
  }
  return prior;
}

}  // namespace v0
}  // namespace topobag
