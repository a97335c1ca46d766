// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "json_output.hpp"
#include "keyframe.hpp"

namespace program {

/// Which key frame it is: its idx, and, of a saved map, its id and its session.
/// @param prefix  of the keys
inline Json keyframe_json(const Keyframe& keyframe, const std::string& prefix) {
  Json json{{prefix + "idx", keyframe.idx}};
  if (!keyframe.saved) return json;
  json[prefix + "id"] = keyframe.saved->id;
  json[prefix + "session"] = keyframe.saved->session.id;
  if (!keyframe.saved->session.name.empty()) {
    json[prefix + "session_name"] = keyframe.saved->session.name;
  }
  return json;
}

}  // namespace program
