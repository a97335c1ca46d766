// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/types/utf8.hpp>

#include "commands.hpp"
#include "fleet_address.hpp"
#include "input_error.hpp"
#include "keyframe_options.hpp"
#include "map_kind.hpp"
#include "option_use.hpp"
#include "output_files.hpp"
#include "path_kind.hpp"
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

/// Which frames became no key frame, and which key frames nothing can be matched with; empty where
/// all did and can.
std::string left_out_text(const MapArguments& arguments, const std::vector<Keyframe>& keyframes) {
  std::ostringstream text;
  const std::size_t frames =
      is_object_map(arguments.nodes) ? 1 : read_frames(arguments.nodes).size();
  if (frames > keyframes.size()) {
    text << arguments.out << ": " << frames - keyframes.size() << " of " << frames
         << " frames left out, nearer than --keyframe-interval " << arguments.keyframes.interval
         << " s\n";
  }
  const auto unusable =
      std::count_if(keyframes.begin(), keyframes.end(),
                    [](const Keyframe& keyframe) { return !keyframe.graph.is_matchable(); });
  if (unusable > 0) {
    text << arguments.out << ": " << unusable << " of " << keyframes.size()
         << " key frames are not usable, with fewer than three objects with a position\n";
  }
  return text.str();
}

/// Throws InputError for a session's name that lists and terminals cannot show.
void require_session_name(const std::string& name) {
  constexpr std::size_t longest = 255;  // bytes, as the name of a file
  topobag::require_utf8(name, "--session");
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = static_cast<unsigned char>(name[i]);
    // From U+0080 to U+009F they are two bytes.
    const bool wide = byte == 0xC2 && static_cast<unsigned char>(name[i + 1]) < 0xA0;
    if (byte >= 0x20 && byte != 0x7F && !wide) continue;
    throw InputError("--session", "byte " + std::to_string(i + 1) +
                                      " of the name begins a control character; give a name that "
                                      "can be shown");
  }
  if (name.size() <= longest) return;
  throw InputError("--session", "the name has " + std::to_string(name.size()) +
                                    " bytes; give one of at most " + std::to_string(longest));
}

void make_map(const CLI::App& command, const MapArguments& arguments) {
  if (!is_fleet_address(arguments.out)) require_file("--out", arguments.out);
  require_session_name(arguments.session);
  KeyframeOptions options = arguments.keyframes;
  const bool goes_on = arguments.append || is_fleet_address(arguments.out);
  if (goes_on) options.classes = classes_of_maps({arguments.out}, options.classes);
  options.camera = with_size(options.camera, arguments.image_size);
  const std::vector<Keyframe> keyframes = read_keyframes(arguments.nodes, options);
  require_vertical(command, arguments.nodes, keyframes);
  const std::string session =
      arguments.session.empty() ? name_of(set_name(arguments.nodes)) : arguments.session;
  const std::string left_out = left_out_text(arguments, keyframes);
  const std::size_t known =
      write_saved_map(arguments.out, session, keyframes, options.classes, arguments.append);
  std::cout << arguments.out << ": " << keyframes.size() << " key frames of " << session
            << " added to the " << map_kind_text(arguments.out) << '\n'
            << left_out;
  if (known > 0) {
    std::cout << arguments.out << ": " << known << " of " << keyframes.size()
              << " key frames are of images that the map held a key frame of: mapped twice, a "
                 "place is found by itself\n";
  }
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
                     "Name of the run [that of the table], of at most 255 bytes; a snapshot keeps "
                     "none");
  command.add_flag("--append", arguments->append, "Go on mapping where there is a map");
  add_keyframe_options(command, arguments->keyframes, arguments->image_size);
  command.callback([arguments, &command] {
    require_object_options(command, {arguments->nodes});
    require_stress_and_gravity(command);
    make_map(command, *arguments);
  });
}

}  // namespace program
