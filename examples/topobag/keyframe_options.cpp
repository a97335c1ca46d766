// SPDX-License-Identifier: MIT
#include "keyframe_options.hpp"

#include <algorithm>
#include <limits>

#include "fleet_address.hpp"
#include "gravity_options.hpp"
#include "input_error.hpp"
#include "number_check.hpp"
#include "object_map_options.hpp"
#include "progress.hpp"
#include "saved_map.hpp"

namespace program {

void add_keyframe_options(CLI::App& command, KeyframeOptions& options, ImageSize& image_size) {
  CLI::Option* const camera = add_camera_option(command, "--camera", options.camera,
                                                "Intrinsics fx,fy,cx,cy[,width,height], px");
  camera->required();
  command
      .add_flag_callback(
          "--clusters",
          [&options, camera] {
            options.clusters = true;
            camera->required(false);
          },
          "Instead of boxes and a camera: clusters of a LiDAR's points, SET.clusters.csv")
      ->excludes(camera);
  add_image_size_option(command, image_size);
  add_classes_option(command, options.classes);
  const auto number = [&](const char* name, double& value, const char* description, double max) {
    command.add_option(name, value, description)
        ->check(number_within(0.0, max))
        ->capture_default_str();
  };
  const double any = std::numeric_limits<double>::infinity();
  number("--keyframe-interval", options.interval, "From key frame to key frame, s; 0 = all", any);
  number("--window", options.window, "Key frames fused in one graph, s; 0 = single frames", any);
  number("--min-confidence", options.min_confidence, "Least score of a detection", 1.0);
  TableStress& stress = options.stress;
  number("--depth-noise", stress.depth_noise, "Stress: depths times 1 + this * N(0, 1)", any);
  number("--drop", stress.drop, "Stress: probability that a detection is dropped", 1.0);
  number("--flip", stress.flip, "Stress: probability that its class is another of the table's",
         1.0);
  command.add_option("--seed", stress.seed, "Of the stress and of the gravity's noise")
      ->check(whole_number_from(0))
      ->capture_default_str();
  add_gravity_options(command, options.gravity);
  command.add_option("--trajectory", options.trajectory,
                     "Poses of the frames, by their time: TUM, OpenLORIS or SET.frames.csv [the "
                     "table's]");
  add_object_map_options(command, options.objects, options.classes);
  add_progress_option(command);
}

void add_map_options(CLI::App& command, MapAndQuery& tables) {
  add_camera_option(command, "--map-camera", tables.map_camera,
                    "The map's camera, where it is another one");
  add_world_up_option(command, "--map-world-up", tables.map_world_up,
                      "Which way is up in the map's world, where it is another one");
  command.add_option("--map-trajectory", tables.map_trajectory,
                     "The same as --trajectory for the map's table");
}

namespace {

/// Throws where an option that is for tables goes with a saved map.
void require_own(const MapAndQuery& tables) {
  const bool given =
      tables.map_camera.fx > 0.0 || tables.map_world_up || !tables.map_trajectory.empty();
  if (!given || !is_saved_map(tables.map)) return;
  throw InputError(
      tables.map,
      "it is a saved map, which has its poses, cameras and vertical: --map-trajectory, "
      "--map-camera and --map-world-up are for tables");
}

}  // namespace

RecognitionRun read_map_and_query(const MapAndQuery& tables, KeyframeOptions options,
                                  const ImageSize& image_size) {
  require_own(tables);
  options.classes = classes_of_maps({tables.map}, options.classes);
  options.camera = with_size(options.camera, image_size);
  KeyframeOptions map_options = options;
  if (tables.map_camera.fx > 0.0) map_options.camera = with_size(tables.map_camera, image_size);
  map_options.size_options = "--map-camera with its width and height";
  if (tables.map_world_up) map_options.gravity.world_up = tables.map_world_up;
  map_options.trajectory = tables.map_trajectory;
  options.stress.stream = map_options.stress.stream + 1;
  RecognitionRun run;
  run.classes = options.classes;
  run.map_set = set_name(tables.map);
  run.query_set = set_name(tables.query);
  run.map = read_map(tables.map, map_options);
  run.queries = read_keyframes(tables.query, options);
  return run;
}

RecognitionRun read_sequence(const std::string& nodes, KeyframeOptions options,
                             const ImageSize& image_size) {
  options.camera = with_size(options.camera, image_size);
  if (is_fleet_address(nodes)) options.classes = classes_of_maps({nodes}, options.classes);
  RecognitionRun run;
  run.classes = options.classes;
  run.map_set = run.query_set = set_name(nodes);
  // A fleet's key frames come robot by robot; here time counts.
  run.map = is_fleet_address(nodes) ? read_map(nodes, options) : read_keyframes(nodes, options);
  std::stable_sort(run.map.begin(), run.map.end(),
                   [](const Keyframe& l, const Keyframe& r) { return l.timestamp < r.timestamp; });
  run.queries = run.map;
  return run;
}

}  // namespace program
