// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <topobag/types/dynamics.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

struct ClassRow {
  std::int32_t number;
  const char* name;
  Dynamics dynamics;
};

/// Table 3 of the paper.
inline constexpr ClassRow paper_classes[] = {
    {1, "tv", Dynamics::low},           {2, "keyboard", Dynamics::low},
    {3, "chair", Dynamics::medium},     {4, "book", Dynamics::medium},
    {5, "mouse", Dynamics::medium},     {6, "teddy_bear", Dynamics::medium},
    {7, "potted_plant", Dynamics::low}, {8, "cup", Dynamics::medium},
    {9, "vase", Dynamics::low},         {10, "car", Dynamics::high},
    {11, "desk", Dynamics::low},        {12, "water_dispenser", Dynamics::low},
    {13, "bucket", Dynamics::medium},   {14, "door", Dynamics::low},
    {15, "bag", Dynamics::medium},      {16, "bookshelf", Dynamics::low},
};

/// COCO's 80 detection classes in the order in which detectors number them.
inline constexpr ClassRow coco80_classes[] = {
    {0, "person", Dynamics::high},
    {1, "bicycle", Dynamics::high},
    {2, "car", Dynamics::high},
    {3, "motorcycle", Dynamics::high},
    {4, "airplane", Dynamics::high},
    {5, "bus", Dynamics::high},
    {6, "train", Dynamics::high},
    {7, "truck", Dynamics::high},
    {8, "boat", Dynamics::high},
    {9, "traffic light", Dynamics::low},
    {10, "fire hydrant", Dynamics::low},
    {11, "stop sign", Dynamics::low},
    {12, "parking meter", Dynamics::low},
    {13, "bench", Dynamics::low},
    {14, "bird", Dynamics::high},
    {15, "cat", Dynamics::high},
    {16, "dog", Dynamics::high},
    {17, "horse", Dynamics::high},
    {18, "sheep", Dynamics::high},
    {19, "cow", Dynamics::high},
    {20, "elephant", Dynamics::high},
    {21, "bear", Dynamics::high},
    {22, "zebra", Dynamics::high},
    {23, "giraffe", Dynamics::high},
    {24, "backpack", Dynamics::medium},
    {25, "umbrella", Dynamics::medium},
    {26, "handbag", Dynamics::medium},
    {27, "tie", Dynamics::medium},
    {28, "suitcase", Dynamics::medium},
    {29, "frisbee", Dynamics::medium},
    {30, "skis", Dynamics::medium},
    {31, "snowboard", Dynamics::medium},
    {32, "sports ball", Dynamics::medium},
    {33, "kite", Dynamics::medium},
    {34, "baseball bat", Dynamics::medium},
    {35, "baseball glove", Dynamics::medium},
    {36, "skateboard", Dynamics::medium},
    {37, "surfboard", Dynamics::medium},
    {38, "tennis racket", Dynamics::medium},
    {39, "bottle", Dynamics::medium},
    {40, "wine glass", Dynamics::medium},
    {41, "cup", Dynamics::medium},
    {42, "fork", Dynamics::medium},
    {43, "knife", Dynamics::medium},
    {44, "spoon", Dynamics::medium},
    {45, "bowl", Dynamics::medium},
    {46, "banana", Dynamics::medium},
    {47, "apple", Dynamics::medium},
    {48, "sandwich", Dynamics::medium},
    {49, "orange", Dynamics::medium},
    {50, "broccoli", Dynamics::medium},
    {51, "carrot", Dynamics::medium},
    {52, "hot dog", Dynamics::medium},
    {53, "pizza", Dynamics::medium},
    {54, "donut", Dynamics::medium},
    {55, "cake", Dynamics::medium},
    {56, "chair", Dynamics::medium},
    {57, "couch", Dynamics::low},
    {58, "potted plant", Dynamics::low},
    {59, "bed", Dynamics::low},
    {60, "dining table", Dynamics::low},
    {61, "toilet", Dynamics::low},
    {62, "tv", Dynamics::low},
    {63, "laptop", Dynamics::low},
    {64, "mouse", Dynamics::medium},
    {65, "remote", Dynamics::medium},
    {66, "keyboard", Dynamics::low},
    {67, "cell phone", Dynamics::medium},
    {68, "microwave", Dynamics::low},
    {69, "oven", Dynamics::low},
    {70, "toaster", Dynamics::low},
    {71, "sink", Dynamics::low},
    {72, "refrigerator", Dynamics::low},
    {73, "book", Dynamics::medium},
    {74, "clock", Dynamics::low},
    {75, "vase", Dynamics::low},
    {76, "scissors", Dynamics::medium},
    {77, "teddy bear", Dynamics::medium},
    {78, "hair drier", Dynamics::medium},
    {79, "toothbrush", Dynamics::medium},
};

/// Names that mean the same class in COCO's and VOC's spelling. A desk is not a dining table.
inline constexpr std::pair<const char*, const char*> class_aliases[] = {
    {"tvmonitor", "tv"},
    {"sofa", "couch"},
    {"pottedplant", "potted plant"},
    {"diningtable", "dining table"},
    {"aeroplane", "airplane"},
    {"motorbike", "motorcycle"},
};

/// Lower case, with every run of space, `_` and `-` turned into one space, none at the ends. Of
/// ASCII alone: the host's locale must not change what a name is.
inline std::string normalized_class_name(std::string_view name) {
  std::string key;
  for (const char c : name) {
    const bool separator = c == '_' || c == '-' || c == ' ' || (c >= '\t' && c <= '\r');
    if (!separator) {
      key += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!key.empty() && key.back() != ' ') {
      key += ' ';
    }
  }
  if (!key.empty() && key.back() == ' ') key.pop_back();
  return key;
}

/// Levenshtein distance, O(|a| |b|).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
