// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// What the graphs were made with that a calibration learnt from, as far as scores depend on it: by
/// names of the host's own, such as the window that it fuses and the least score of a detection.
/// The library reads no meaning into them; they are kept with the calibration, so that its host can
/// tell when it is used with graphs that were made otherwise.
class CalibrationConditions {
 public:
  /// States one, or states it anew. Throws InvalidValue unless the name is a word and the value is
  /// a line that is not empty. O(log n).
  void set(const std::string& name, std::string value) {
    const auto above = [](char least) {
      return [least](char c) { return static_cast<unsigned char>(c) >= least && c != '\x7F'; };
    };
    if (name.empty() || !std::all_of(name.begin(), name.end(), above('!'))) {
      throw InvalidValue("the name of a calibration's condition must be a word");
    }
    if (value.empty() || !std::all_of(value.begin(), value.end(), above(' '))) {
      throw InvalidValue("a calibration's condition '" + name + "' must be a line of text");
    }
    stated_[name] = std::move(value);
  }

  /// All that are stated, by their names.
  const std::map<std::string, std::string>& stated() const noexcept { return stated_; }

  /// The names that both state, each with another value, in their order. O(n + m).
  std::vector<std::string> differing(const CalibrationConditions& other) const {
    std::vector<std::string> names;
    for (const auto& [name, value] : stated_) {
      const auto found = other.stated_.find(name);
      if (found != other.stated_.end() && found->second != value) names.push_back(name);
    }
    return names;
  }

 private:
  std::map<std::string, std::string> stated_;
};

}  // namespace v0
}  // namespace topobag
