// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include <topobag/bag/session_number.hpp>
#include <topobag/recognition/align_maps.hpp>

#include "commands.hpp"
#include "fleet_address.hpp"
#include "input_error.hpp"
#include "object_classes.hpp"
#include "output_files.hpp"
#include "progress.hpp"
#include "saved_map.hpp"

namespace program {
namespace {

struct MergeArguments {
  std::string map;
  std::string other;
  std::string out;
  bool unknown_scale = false;  ///< of the other map
  ObjectClasses classes;
};

/// The number after the last run of a map, noted or not.
std::uint32_t session_after_all(const SavedMap& map) {
  std::optional<std::uint32_t> last;
  const auto note = [&](std::uint32_t session) { last = std::max(last.value_or(0), session); };
  for (const SavedSession& session : map.sessions) note(session.id);
  map.bag.for_each([&](topobag::KeyframeId, const topobag::EntryInfo& info, const auto&) {
    note(info.session);
  });
  return topobag::next_session(last);
}

/// `tx ty tz qx qy qz qw` and how exactly that is known.
std::string in_words(const topobag::PoseWithCovariance<>& pose) {
  const Eigen::Quaterniond q(pose.T.linear());
  const auto deviation = [&](Eigen::Index first) {
    return std::sqrt(pose.covariance.diagonal().segment<3>(first).sum());
  };
  const double degrees = 57.29577951308232;
  const Eigen::Vector3d t = pose.T.translation();
  std::ostringstream text;
  for (const double number : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
    text << number << ' ';
  }
  text << "to " << deviation(0) << " m and " << degrees * deviation(3) << " degrees";
  return text.str();
}

/// ", 1 unit of b.db is 0.7102 ± 0.0031 m of a.db", where that was not known.
std::string scale_in_words(const MergeArguments& arguments,
                           const topobag::MapAlignment& alignment) {
  if (!arguments.unknown_scale) return "";
  std::ostringstream text;
  text << std::fixed << std::setprecision(4) << ", 1 unit of " << arguments.other << " is "
       << alignment.scale << " ± " << alignment.scale_deviation << " m of " << arguments.map;
  return text.str();
}

/// Throws InputError where a map has no usable key frame with a pose: it lies nowhere.
void require_place(const std::string& path, const topobag::BagOfTopologyGraphs<>& bag) {
  bool placed = false;
  bag.for_each([&](topobag::KeyframeId, const topobag::EntryInfo& info, const auto& graph) {
    placed = placed || (info.T_world_camera && graph.is_matchable());
  });
  if (!placed) throw InputError(path, why(topobag::AlignmentVerdict::no_poses));
}

void merge_maps(const MergeArguments& arguments) {
  if (is_fleet_address(arguments.out)) {
    throw InputError("--out", "merge writes a file, which `topobag fleet push` sends to a server");
  }
  require_file("--out", arguments.out);
  require_new_map(arguments.out);
  const ObjectClasses classes =
      classes_of_maps({arguments.map, arguments.other}, arguments.classes);
  SavedMap map = read_saved_map(arguments.map, classes);
  const SavedMap other = read_saved_map(arguments.other, classes);
  require_place(arguments.map, map.bag);
  require_place(arguments.other, other.bag);
  require_new(arguments.map, map.bag, other.bag);
  topobag::AlignOptions options;
  options.recognition = recognition_options_for(classes);
  if (arguments.unknown_scale) options.recognition.matching.scale = topobag::ScaleRange{};
  Progress progress(std::min(options.max_keyframes, other.bag.size()), "key frames looked up");
  options.on_query = [&] { progress.step(); };
  const topobag::MapAlignment alignment = topobag::align_maps(map.bag, other.bag, options);
  const std::string counts = std::to_string(alignment.agreeing) + " of " +
                             std::to_string(alignment.asked) + " key frames agree, " +
                             std::to_string(alignment.rivalling) + " on something else";
  if (!alignment) {
    throw InputError(arguments.other, std::string(why(alignment.verdict)) + " (" + counts + ")");
  }
  const topobag::MergeOptions how = alignment.merge_options(session_after_all(map));
  map.bag.merge(other.bag, how);
  for (const SavedSession& session : other.sessions) {
    map.sessions.push_back({topobag::session_after(session.id, how.session_offset), session.name});
  }
  write_new_map(arguments.out, map, classes);
  std::cout << arguments.out << ": " << map.bag.size() << " key frames, " << other.bag.size()
            << " of them of " << arguments.other << ", whose world lies at "
            << in_words(*alignment.T_a_b) << scale_in_words(arguments, alignment) << " (" << counts
            << ")\n";
}

}  // namespace

void add_merge_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "merge", "Lays one map over another by what both saw, and makes them one");
  const auto arguments = std::make_shared<MergeArguments>();
  command.add_option("map", arguments->map, "SQLite map or snapshot, whose world stays")
      ->required();
  command.add_option("other", arguments->other, "The same, whose poses move")->required();
  command
      .add_option("--out", arguments->out,
                  "Map to write: FILE.db for a durable one on SQLite, else a snapshot")
      ->required();
  command.add_flag("--unknown-scale", arguments->unknown_scale,
                   "The other map's lengths are in an unknown unit, of a quarter to four of the "
                   "map's metres, as of a monocular front end");
  add_classes_option(command, arguments->classes);
  add_progress_option(command);
  command.callback([arguments] { merge_maps(*arguments); });
}

}  // namespace program
