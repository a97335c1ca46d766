// SPDX-License-Identifier: MIT
#include "score_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "html_text.hpp"

namespace program {
namespace {

// As the page's script knows them.
constexpr std::uint8_t true_place = 1;
constexpr std::uint8_t correct = 2;
constexpr std::uint8_t imprecise = 4;
constexpr std::uint8_t wrong = 8;
constexpr std::uint8_t accepted = 16;

std::uint8_t flag_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::correct:
      return correct;
    case Outcome::imprecise:
      return imprecise;
    case Outcome::wrong:
      return wrong;
    default:
      return accepted;
  }
}

template <typename Value>
std::string bytes_of(const std::vector<Value>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)});
}

}  // namespace

ScoreImage::ScoreImage(std::size_t rows, std::size_t columns, std::size_t max_side)
    : block_(std::max<std::size_t>(1, (std::max(rows, columns) + max_side - 1) / max_side)),
      rows_((rows + block_ - 1) / block_),
      columns_((columns + block_ - 1) / block_),
      scores_(rows_ * columns_, std::numeric_limits<float>::quiet_NaN()),
      flags_(rows_ * columns_, 0) {}

void ScoreImage::add(std::size_t row, std::size_t column, double score) {
  float& best = scores_[cell(row, column)];
  const auto value = static_cast<float>(score);
  if (std::isnan(best) || value > best) best = value;
}

void ScoreImage::mark_true(std::size_t row, std::size_t column) {
  flags_[cell(row, column)] |= true_place;
}

void ScoreImage::mark_answer(std::size_t row, std::size_t column, Outcome outcome) {
  flags_[cell(row, column)] |= flag_of(outcome);
}

void ScoreImage::hint(std::size_t row, std::size_t column, std::string text) {
  if (block_ == 1) hints_[cell(row, column)] = std::move(text);
}

Figure ScoreImage::figure(const Names& names) const {
  Figure figure{names.id, names.title, "", ""};
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  std::size_t marked = 0;
  std::size_t outlined = 0;
  for (std::size_t i = 0; i < scores_.size(); ++i) {
    if (!std::isnan(scores_[i])) {
      low = std::min(low, scores_[i]);
      high = std::max(high, scores_[i]);
    }
    if ((flags_[i] & true_place) != 0) ++outlined;
    if ((flags_[i] & ~true_place) != 0) ++marked;
  }
  if (low > high) low = high = 0.0F;
  Json hints = Json::object();
  for (const auto& [index, text] : hints_) hints[std::to_string(index)] = text;
  figure.drawn = Json{{"rows", rows_},
                      {"columns", columns_},
                      {"block", block_},
                      {"low", low},
                      {"high", high},
                      {"sign", names.sign},
                      {"row_names", names.rows},
                      {"column_names", names.columns},
                      {"row_label", "query key frame"},
                      {"column_label", "candidate key frame"},
                      {"score_label", names.score},
                      {"scores", bytes_of(scores_)},
                      {"flags", bytes_of(flags_)},
                      {"hints", hints}};
  figure.caption =
      "Every pair that was asked for, a row per query; where nothing is drawn there is no "
      "score. " +
      (block_ > 1 ? "A cell is the best of " + std::to_string(block_) + " × " +
                        std::to_string(block_) + " pairs. "
                  : std::string());
  if (outlined > 0) figure.caption += "Outlined: true places by the protocol. ";
  if (marked > 0) {
    figure.caption +=
        "Circles: accepted answers that are correct; triangles: imprecise; crosses: wrong.";
  }
  figure.drawing = "<div><canvas class=\"matrix\" role=\"img\" aria-label=\"" +
                   escaped(names.title) +
                   "\"></canvas><p class=\"readout\">Point at a cell to read its pair.</p></div>\n";
  return figure;
}

}  // namespace program
