// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <sstream>
#include <string>

#include "csv_reader.hpp"
#include "sample.hpp"
#include "scratch.hpp"

/// The desk of the sample twice in one table, the second time 50 m aside along x and 1,000 s later,
/// its frames numbered from 1,000.
/// @return the table's name
inline std::string write_desk_twice(const ScratchFolder& folder) {
  const std::string set = folder.path("twice");
  const auto twice = [&](const std::string& kind, const auto& again) {
    std::istringstream lines(program::read_file(sample_map + kind));
    std::string header, line, first, second;
    std::getline(lines, header);
    while (std::getline(lines, line)) {
      first += line + '\n';
      second += again(line) + '\n';
    }
    program::write_file(set + kind, header + '\n' + first + second);
  };
  const auto behind = [](const std::string& line, std::size_t commas) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < commas; ++i) at = line.find(',', at) + 1;
    return at;
  };
  const auto next_idx = [](const std::string& line) {
    return std::to_string(std::stoi(line) + 1000) + line.substr(line.find(','));
  };
  twice(".nodes.csv", next_idx);
  twice(".frames.csv", [&](const std::string& line) {
    const std::size_t time = behind(line, 2), x = behind(line, 3), y = behind(line, 4);
    return next_idx(line.substr(0, time)) + std::to_string(std::stod(line.substr(time)) + 1000.0) +
           ',' + std::to_string(std::stod(line.substr(x)) + 50.0) + line.substr(y - 1);
  });
  return set;
}
