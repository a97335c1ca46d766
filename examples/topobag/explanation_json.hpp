// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/recognition/explanation.hpp>

#include "json_output.hpp"

namespace program {

/// An explanation for machines: every candidate with all its stages, objects and changes.
Json to_json(const topobag::Explanation& explanation);

}  // namespace program
