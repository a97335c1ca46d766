// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "input_error.hpp"

namespace program {

/// An option's text, read as finite numbers between commas.
class NumberList {
 public:
  /// @param form  what is asked for, to be said when it is not there
  /// Throws InputError for what is no number.
  NumberList(const std::string& option, const std::string& text, const char* form);

  std::size_t size() const { return numbers_.size(); }
  double operator[](std::size_t i) const { return numbers_[i]; }

  /// To be thrown; it names the option and the form.
  InputError error(const std::string& why) const { return {place_, why + "; give " + form_}; }

 private:
  std::string place_;
  const char* form_;
  std::vector<double> numbers_;
};

}  // namespace program
