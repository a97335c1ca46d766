// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <topobag/evaluation/labelled_scores.hpp>

#include "json_output.hpp"
#include "recognition_run.hpp"

namespace program {

/// One method of a comparison.
struct ComparedMethod {
  std::string name;
  std::string meaning;
  topobag::LabelledScores labelled{};
  std::optional<double> pair_us{};    ///< time over pairs, µs; none of foreign scores
  std::optional<RunSummary> poses{};  ///< of its verified candidates; none where it gives no pose
};

/// Methods on the same pairs of key frames.
struct Comparison {
  std::string map_set;
  std::string query_set;
  std::string protocol;         ///< what a true place is
  std::size_t verified = 0;     ///< best answers of a similarity that are verified
  std::size_t true_pairs = 0;   ///< by the protocol
  std::size_t false_pairs = 0;  ///< by the protocol
  std::vector<ComparedMethod> methods{};
};

/// A number that a comparison's table gives of a method.
struct ComparisonNumber {
  const char* key;      ///< in JSON
  const char* heading;  ///< for readers
  int decimals;
  std::optional<double> value;  ///< undefined without a true place, or without a pose
};

/// The columns of the table. Retrieval metrics are of each query's best answer.
std::vector<ComparisonNumber> numbers_of(const ComparedMethod& method);

std::string to_json(const Comparison& comparison);

/// The table in Markdown.
std::string to_markdown(const Comparison& comparison);

/// The table for a reader, with what its rows and columns are.
std::string to_table(const Comparison& comparison);

}  // namespace program
