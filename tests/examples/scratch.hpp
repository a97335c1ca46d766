// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <topobag/error.hpp>

#include "csv_reader.hpp"
#include "scratch_folder.hpp"

/// What `call` throws as a topobag::Error, without the folder that its text begins with.
template <typename Call>
std::string error_in(const ScratchFolder& folder, const Call& call) {
  try {
    call();
  } catch (const topobag::Error& error) {
    const std::string text = error.what();
    const std::string prefix = folder.path("");
    return text.compare(0, prefix.size(), prefix) == 0 ? text.substr(prefix.size()) : text;
  }
  return "nothing was thrown";
}
