// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>
#include <string>

#include <topobag/types/utf8.hpp>

#include "commands.hpp"
#include "fleet_address.hpp"
#include "keyframe_options.hpp"
#include "output_files.hpp"
#include "saved_map.hpp"

namespace program {
namespace {

struct MapArguments {
  std::string nodes;
  std::string out;
  std::string session;
  bool append = false;
  KeyframeOptions keyframes;
  ImageSize image_size;
};

void make_map(const MapArguments& arguments) {
  if (!is_fleet_address(arguments.out)) require_folder("--out", arguments.out);
  topobag::require_utf8(arguments.session, "--session");
  KeyframeOptions options = arguments.keyframes;
  const bool goes_on = arguments.append || is_fleet_address(arguments.out);
  if (goes_on) options.classes = classes_of_maps({arguments.out}, options.classes);
  options.camera = with_size(options.camera, arguments.image_size);
  const std::vector<Keyframe> keyframes = read_keyframes(arguments.nodes, options);
  const std::string session =
      arguments.session.empty() ? name_of(set_name(arguments.nodes)) : arguments.session;
  write_saved_map(arguments.out, session, keyframes, options.classes, arguments.append);
  std::cout << arguments.out << ": " << keyframes.size() << " key frames of " << session
            << " added\n";
  if (!arguments.session.empty() && !keeps_session_names(arguments.out)) {
    std::cout << arguments.out << ": a snapshot keeps no names of sessions, and so not "
              << arguments.session << "; a map FILE.db does\n";
  }
}

}  // namespace

void add_map_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "map", "Makes the key frames of a node table a map that `localize` looks key frames up in");
  const auto arguments = std::make_shared<MapArguments>();
  command.add_option("--nodes", arguments->nodes, "Table: NODES.frames.csv, NODES.nodes.csv")
      ->required();
  command
      .add_option(
          "--out", arguments->out,
          "Map to write: FILE.db for a durable one on SQLite, postgresql://…?site=NAME for a "
          "fleet's, else a snapshot")
      ->required();
  command.add_option("--session", arguments->session,
                     "Name of the run [that of the table]; a snapshot keeps none");
  command.add_flag("--append", arguments->append, "Go on mapping where there is a map");
  add_keyframe_options(command, arguments->keyframes, arguments->image_size);
  command.callback([arguments] { make_map(*arguments); });
}

}  // namespace program
