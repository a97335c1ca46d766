// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The columns that the rows of `gain` (finite) get in a one-to-one assignment of the largest total
/// gain; with more rows than columns some rows get none.
///
/// Kuhn–Munkres by shortest augmenting paths. O(r² c) for the shorter side r and the longer c.
template <typename Derived>
std::vector<std::optional<std::size_t>> best_assignment(const Eigen::MatrixBase<Derived>& gain) {
  const bool flipped = gain.rows() > gain.cols();
  const Eigen::MatrixXd cost =
      flipped ? Eigen::MatrixXd(-gain.transpose()) : Eigen::MatrixXd(-gain);
  const auto rows = static_cast<std::size_t>(cost.rows());
  const auto columns = static_cast<std::size_t>(cost.cols());
  const std::size_t none = columns;
  constexpr double infinity = std::numeric_limits<double>::infinity();

  std::vector<double> row_price(rows, 0.0), column_price(columns, 0.0);
  std::vector<std::size_t> row_of(columns, rows);  // of each column; `rows` = free
  for (std::size_t start = 0; start < rows; ++start) {
    std::vector<double> slack(columns, infinity);
    std::vector<std::size_t> previous(columns, none);  // column before this one on the path
    std::vector<bool> reached(columns, false);
    std::size_t row = start, column = none;
    do {
      std::size_t next = none;
      double step = infinity;
      for (std::size_t j = 0; j < columns; ++j) {
        if (reached[j]) continue;
        const double reduced = cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(j)) -
                               row_price[row] - column_price[j];
        if (reduced < slack[j]) {
          slack[j] = reduced;
          previous[j] = column;
        }
        if (next == none || slack[j] < step) {
          step = slack[j];
          next = j;
        }
      }
      row_price[start] += step;
      for (std::size_t j = 0; j < columns; ++j) {
        if (reached[j]) {
          row_price[row_of[j]] += step;
          column_price[j] -= step;
        } else {
          slack[j] -= step;
        }
      }
      column = next;
      reached[column] = true;
      row = row_of[column];
    } while (row != rows);
    while (column != none) {
      const std::size_t before = previous[column];
      row_of[column] = before == none ? start : row_of[before];
      column = before;
    }
  }

  std::vector<std::optional<std::size_t>> column_of(static_cast<std::size_t>(gain.rows()));
  for (std::size_t j = 0; j < columns; ++j) {
    if (row_of[j] == rows) continue;
    if (flipped) {
      column_of[j] = row_of[j];
    } else {
      column_of[row_of[j]] = j;
    }
  }
  return column_of;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
