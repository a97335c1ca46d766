// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <topobag/evaluation/detail/pose_text.hpp>
#include <topobag/evaluation/labelled_scores.hpp>

namespace topobag {
inline namespace v0 {

/// Scores of some pairs, and the relative poses that a method gives them, if it does.
struct ScoreList {
  std::vector<ScoredPair> pairs;                     ///< in the file's order
  std::vector<Eigen::Isometry3d> T_candidate_query;  ///< one per pair, or none at all
};

namespace detail {

template <typename Lines>
ScoreMatrix read_score_rows(Lines& lines, std::string_view line) {
  std::vector<double> all;
  std::vector<double> row;
  std::size_t columns = 0;
  Eigen::Index rows = 0;
  do {
    std::string_view first = line.substr(0, std::min(line.find_first_of(", \t"), line.size()));
    if (columns == 0 && !first.empty() && !parse_number(first) && first.find(';') == first.npos) {
      throw lines.error("'" + std::string(first.substr(0, 40)) +
                        "' is not a number: a matrix of scores has no header, and that of a list "
                        "is query,candidate,score.");
    }
    lines.numbers(line, row);
    if (columns == 0) columns = row.size();
    if (row.size() != columns) {
      throw lines.error("this row has " + std::to_string(row.size()) + " scores, the first " +
                        std::to_string(columns) + ".");
    }
    all.insert(all.end(), row.begin(), row.end());
    ++rows;
  } while (lines.next(line));
  return Eigen::Map<const ScoreMatrix>(all.data(), rows, static_cast<Eigen::Index>(columns));
}

template <typename Lines>
std::uint32_t index_of(const Lines& lines, double value) {
  if (!(value >= 0.0 && value <= 4294967295.0) ||
      value != static_cast<double>(static_cast<std::uint32_t>(value))) {
    throw lines.error("query and candidate are row numbers of the poses, from 0.");
  }
  return static_cast<std::uint32_t>(value);
}

template <typename Lines>
ScoreList read_score_pairs(Lines& lines, bool with_poses) {
  ScoreList list;
  std::vector<double> row;
  std::string_view line;
  const std::size_t columns = with_poses ? 10 : 3;
  while (lines.next(line)) {
    lines.numbers(line, row);
    if (row.size() != columns) {
      throw lines.error("this line has " + std::to_string(row.size()) + " numbers, the header " +
                        std::to_string(columns) + ".");
    }
    list.pairs.push_back({index_of(lines, row[0]), index_of(lines, row[1]), row[2]});
    if (with_poses) list.T_candidate_query.push_back(pose_from_quaternion(lines, row.data() + 3));
  }
  return list;
}

}  // namespace detail

/// Reads the scores of any method from CSV. Without a header: a matrix, a row per query, a column
/// per candidate. With the header `query,candidate,score`: a list of pairs, numbered from 0 as
/// their poses are; with `query,candidate,score,tx,ty,tz,qx,qy,qz,qw` the list also gives
/// T_candidate_query, m. `#` starts a comment line. Throws Error with `name` and the line for
/// anything else. About 0.5 s for four million scores.
/// @param stream  a `std::istream`
template <typename Stream>
std::variant<ScoreMatrix, ScoreList> read_score_csv(Stream& stream, const std::string& name) {
  TextLines lines(stream, name);
  std::string_view line;
  if (!lines.next(line)) throw Error(name + " holds no scores.");
  if (line.substr(0, 5) == "query") {
    std::string header(line);
    header.erase(std::remove(header.begin(), header.end(), ' '), header.end());
    if (header == "query,candidate,score") return detail::read_score_pairs(lines, false);
    if (header == "query,candidate,score,tx,ty,tz,qx,qy,qz,qw") {
      return detail::read_score_pairs(lines, true);
    }
    throw lines.error(
        "the header of a list of pairs is query,candidate,score, with or without "
        ",tx,ty,tz,qx,qy,qz,qw.");
  }
  return detail::read_score_rows(lines, line);
}

/// The same from a file.
/// @param path  a `std::string`, or what else converts to one
template <typename Path = std::string>
std::variant<ScoreMatrix, ScoreList> read_score_csv(const Path& path) {
  std::ifstream file = open_file(path);
  return read_score_csv(file, path);
}

}  // namespace v0
}  // namespace topobag
