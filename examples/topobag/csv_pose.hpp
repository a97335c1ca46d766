// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include <Eigen/Geometry>

#include <topobag/types/rigid_motion.hpp>

#include "csv_reader.hpp"

namespace program {

/// Whether a field says that there is no number, as tools write that.
inline bool says_nan(std::string_view field) {
  return field == "nan" || field == "NaN" || field == "NAN" || field == "-nan";
}

/// The columns tx ty tz qx qy qz qw of a table, of which it has all or none.
class CsvPose {
 public:
  /// @param csv  must live as long
  explicit CsvPose(const CsvReader& csv) : csv_(csv) {
    const std::array<const char*, 7> names{"tx", "ty", "tz", "qx", "qy", "qz", "qw"};
    given_ = std::any_of(names.begin(), names.end(),
                         [&](const char* name) { return csv.find_column(name).has_value(); });
    for (std::size_t i = 0; given_ && i < names.size(); ++i) columns_[i] = csv.column(names[i]);
  }

  /// Whether the table has them.
  bool given() const { return given_; }

  /// The pose of the current row; nothing where all of its fields are empty. Throws topobag::Error.
  std::optional<Eigen::Isometry3d> read() const {
    const bool absent =
        !given_ || std::all_of(columns_.begin(), columns_.end(),
                               [&](std::size_t column) { return csv_.text(column).empty(); });
    if (absent) return std::nullopt;
    std::array<double, 7> v{};
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (says_nan(csv_.text(columns_[i]))) {
        throw csv_.error(
            "the pose is not a number; leave its seven fields empty where it is not "
            "known");
      }
      v[i] = csv_.number(columns_[i]);
    }
    return csv_.located([&] { return topobag::pose_from_numbers(v); });
  }

 private:
  const CsvReader& csv_;
  bool given_ = false;
  std::array<std::size_t, 7> columns_{};
};

}  // namespace program
