// SPDX-License-Identifier: MIT
#include "learning_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <vector>

#include "input_error.hpp"
#include "report/html_text.hpp"

namespace program {
namespace {

/// By which a map is known again, whatever file it is in: its key frames' stamps and objects.
std::string map_mark(const std::vector<Keyframe>& map) {
  std::vector<std::uint64_t> numbers;
  for (const Keyframe& keyframe : map) {
    const double microseconds = std::round(1e6 * keyframe.timestamp);
    numbers.push_back(static_cast<std::uint64_t>(static_cast<std::int64_t>(microseconds)));
  }
  std::sort(numbers.begin(), numbers.end());
  std::size_t objects = 0;
  for (const Keyframe& keyframe : map) objects += keyframe.graph.size();
  numbers.push_back(objects);
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (const std::uint64_t number : numbers) {
    for (unsigned shift = 0; shift < 64; shift += 8) {
      hash = (hash ^ ((number >> shift) & 0xFF)) * 1099511628211u;
    }
  }
  std::ostringstream text;
  text << std::hex << std::setfill('0') << std::setw(16) << hash;
  return text.str();
}

}  // namespace

topobag::CalibrationConditions learning_conditions(const RecognitionRun& run,
                                                   const KeyframeOptions& options) {
  topobag::CalibrationConditions conditions;
  conditions.set("clusters", options.clusters ? "yes" : "no");
  conditions.set("map", map_mark(run.map));
  conditions.set("min_confidence", short_text(options.min_confidence));
  conditions.set("unknown_scale", run.scale ? "yes" : "no");
  conditions.set("window", short_text(options.window));
  return conditions;
}

void require_conditions(const std::string& file, const topobag::Calibration& learnt,
                        const topobag::CalibrationConditions& now) {
  for (const std::string& name : learnt.conditions().differing(now)) {
    if (name == "map") continue;
    std::string option = "--" + name;
    std::replace(option.begin(), option.end(), '_', '-');
    const std::string& was = learnt.conditions().stated().at(name);
    const std::string& is = now.stated().at(name);
    const std::string how = was == "yes"  ? "with " + option + ", and this run is without"
                            : was == "no" ? "without " + option + ", and this run is with it"
                                          : "with " + option + ' ' + was + ", and here it is " + is;
    throw InputError(file, "it was learnt " + how +
                               ": false matches of other graphs reach other scores; make them as "
                               "it was learnt, or learn anew by --calibrate");
  }
}

std::optional<bool> is_of_other_map(const topobag::Calibration& learnt,
                                    const topobag::CalibrationConditions& now) {
  const auto& stated = learnt.conditions().stated();
  const auto map = stated.find("map");
  if (map == stated.end()) return std::nullopt;
  return map->second != now.stated().at("map");
}

}  // namespace program
