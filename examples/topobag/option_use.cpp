// SPDX-License-Identifier: MIT
#include "option_use.hpp"

#include <algorithm>

#include "fleet_address.hpp"
#include "input_error.hpp"
#include "path_kind.hpp"
#include "saved_map.hpp"

namespace program {
namespace {

bool is_given(const CLI::App& command, const std::string& option) {
  const CLI::Option* found = command.get_option_no_throw(option);
  return found != nullptr && found->count() > 0;
}

/// Whether no camera saw what a saved map holds. One that cannot be read is told of by who reads
/// it.
bool is_made_of_objects(const std::string& map) {
  try {
    bool seen = false;
    read_saved_map(map, classes_of_maps({map}, {}))
        .bag.for_each([&](topobag::KeyframeId, const auto&, const topobag::TopologyGraph<>& graph) {
          seen = seen || !graph.views().empty();
        });
    return !seen;
  } catch (const topobag::Error&) {
    return true;
  }
}

/// Whether the options of a map of objects say something of this: they do of what is not known.
bool may_hold_objects(const std::string& path) {
  if (is_fleet_address(path)) return true;
  switch (path_kind(path)) {
    case PathKind::table:
      return false;
    case PathKind::sqlite_map:
    case PathKind::snapshot:
      return is_made_of_objects(path);
    default:
      return true;
  }
}

}  // namespace

void require_with(const CLI::App& command, const std::string& option,
                  const std::vector<std::string>& others) {
  if (!is_given(command, option)) return;
  std::string names;
  for (const std::string& other : others) {
    if (is_given(command, other)) return;
    if (command.get_option_no_throw(other) == nullptr) continue;
    names += (names.empty() ? "" : " or ") + other;
  }
  throw InputError(option, "it does nothing without " + names + "; give that, or leave it out");
}

void require_stress_and_gravity(const CLI::App& command) {
  require_with(command, "--gravity-noise", {"--world-up", "--map-world-up"});
  require_with(command, "--seed",
               {"--depth-noise", "--drop", "--flip", "--world-up", "--map-world-up"});
}

void require_vertical(const CLI::App& command, const std::string& set,
                      const std::vector<Keyframe>& keyframes) {
  const bool known = std::any_of(keyframes.begin(), keyframes.end(), [](const Keyframe& keyframe) {
    return keyframe.graph.gravity().has_value();
  });
  if (known || !is_given(command, "--world-up")) return;
  throw InputError("--world-up", "no key frame of " + set +
                                     " has a pose, by which it would know which way is down; give "
                                     "--trajectory, or leave it out");
}

void require_object_options(const CLI::App& command, const std::vector<std::string>& paths) {
  for (const char* option :
       {"--map-relation", "--map-words", "--object-scale", "--object-deviation"}) {
    if (!is_given(command, option)) continue;
    const bool may = std::any_of(paths.begin(), paths.end(), [](const std::string& path) {
      return !path.empty() && may_hold_objects(path);
    });
    if (may) return;
    const PathKind kind = path_kind(paths.front());
    throw InputError(option,
                     "it is for a map of objects; " + paths.front() +
                         (kind == PathKind::table ? " is a table" : " was not made of one"));
  }
}

void require_without(const CLI::App& command, const std::vector<std::string>& options,
                     const std::string& why) {
  for (const std::string& option : options) {
    if (is_given(command, option)) throw InputError(option, why);
  }
}

void require_table_options(const CLI::App& command, const std::string& map) {
  if (!is_saved_map(map)) return;
  require_without(command,
                  {"--keyframe-interval", "--window", "--min-confidence", "--depth-noise", "--drop",
                   "--flip", "--seed", "--trajectory", "--clusters"},
                  "it is for a table, and " + map +
                      " is a saved map; leave it out, or make the map anew with it");
}

}  // namespace program
