// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "figure.hpp"
#include "query_outcome.hpp"

namespace program {

/// A matrix of scores as a figure: queries down, candidates across. Beyond `max_side` cells a side,
/// a cell is a square block of pairs and shows their best.
class ScoreImage {
 public:
  ScoreImage(std::size_t rows, std::size_t columns, std::size_t max_side = 400);

  /// @param score  higher = more alike
  void add(std::size_t row, std::size_t column, double score);
  void mark_true(std::size_t row, std::size_t column);
  void mark_answer(std::size_t row, std::size_t column, Outcome outcome);

  /// Shown when the pointer is on the pair. Ignored where a cell is more than one pair.
  void hint(std::size_t row, std::size_t column, std::string text);

  /// Pairs along one side of a cell.
  std::size_t block() const { return block_; }

  /// How the figure names its parts.
  struct Names {
    std::string id;
    std::string title;
    std::string score;                    ///< "similarity"
    std::vector<std::int64_t> rows{};     ///< of the queries
    std::vector<std::int64_t> columns{};  ///< of the candidates
    double sign = 1.0;                    ///< -1: scores are shown negated
  };

  Figure figure(const Names& names) const;

 private:
  std::size_t cell(std::size_t row, std::size_t column) const {
    return row / block_ * columns_ + column / block_;
  }

  std::size_t block_;
  std::size_t rows_;           ///< in cells
  std::size_t columns_;        ///< in cells
  std::vector<float> scores_;  ///< NaN = none
  std::vector<std::uint8_t> flags_;
  std::map<std::size_t, std::string> hints_;
};

}  // namespace program
