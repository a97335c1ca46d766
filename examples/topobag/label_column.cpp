// SPDX-License-Identifier: MIT
#include "label_column.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include <topobag/evaluation/text_lines.hpp>

namespace program {

std::string labels_text(const topobag::LabelWeights& weights,
                        const topobag::ClassCatalog& catalog) {
  std::string text;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    text += (i > 0 ? "|" : "") + catalog.name(weights.label(i)) + '=' +
            std::to_string(int{weights.byte(i)});
  }
  return text;
}

topobag::LabelWeights read_labels(const CsvReader& csv, std::optional<std::size_t> column,
                                  topobag::ClassId label, const topobag::ClassCatalog& catalog) {
  if (!column || csv.text(*column).empty()) return {};
  const std::string_view text = csv.text(*column);
  std::vector<topobag::WeightedLabel> labels;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('|', begin), text.size());
    const std::string_view part = text.substr(begin, end - begin);
    const std::size_t equals = part.rfind('=');
    const auto weight = equals == std::string_view::npos
                            ? std::nullopt
                            : parse_number(topobag::trimmed(part.substr(equals + 1)));
    if (!weight) {
      throw csv.error("labels '" + std::string(text) +
                      "' are not written as class=weight|class=weight");
    }
    labels.push_back(
        {csv.located([&] { return catalog.at(topobag::trimmed(part.substr(0, equals))); }),
         *weight});
    begin = end + 1;
  }
  const topobag::LabelWeights weights = csv.located([&] { return topobag::LabelWeights(labels); });
  if (!topobag::has_best_label(label, weights)) {
    throw csv.error("labels '" + std::string(text) + "' give another class than '" +
                    catalog.name(label) + "' the most weight");
  }
  return weights;
}

}  // namespace program
