// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <topobag/error.hpp>

/// The text of the error that `call` throws.
template <typename Call>
std::string error_text(const Call& call) {
  try {
    call();
  } catch (const topobag::Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}
