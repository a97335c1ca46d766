// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "arguments.hpp"

namespace semantic {

/// Makes the arguments options of the program's command line.
inline void add_options(CLI::App& app, Arguments& arguments) {
  app.add_option("VOC", arguments.vocabulary, "ORB vocabulary, text")->required();
  app.add_option("SETTINGS", arguments.settings, "The host's settings, YAML")->required();
  app.add_option("SEQUENCE", arguments.sequence, "Folder of the sequence")->required();
  app.add_option("ASSOCIATIONS", arguments.associations, "Pairs of images, or one camera's list")
      ->required();
  auto* table = app.add_option("--detections", arguments.table, "Node table of the sequence");
  app.add_option("--model", arguments.model, "YOLOX network, ONNX")->excludes(table);
  app.add_option("--sensor", arguments.sensor,
                 "The host's camera: rgbd; stereo = a rectified pair, the right images in place of "
                 "depth; mono = one image [rgbd]")
      ->check(CLI::IsMember({"rgbd", "stereo", "mono"}));
  app.add_option("--depth", arguments.depth,
                 "Of the boxes: rgbd = the table's own or the depth image; points = the host's own "
                 "features in them, or its map points for mono; stereo = disparities of the pair "
                 "[the sensor's own]")
      ->check(CLI::IsMember({"rgbd", "points", "stereo"}));
  app.add_option(
         "--still", arguments.still,
         "m, a radian counting as one: key frames whose view changed no more since the last "
         "look, up to 5 s ago, are not looked at")
      ->check(CLI::PositiveNumber);
  app.add_flag("--mask", arguments.mask, "Track without the features on what moves")->needs(table);
  app.add_flag("--stock", arguments.stock, "Without the bag");
  app.add_flag("--no-wait", arguments.no_wait, "As fast as it goes, not at the camera's pace");
  app.add_option("--window", arguments.window, "Seconds of key frames in one graph");
  app.add_option("--places", arguments.max_places, "Places offered to a lost tracker");
  app.add_option("--candidates", arguments.candidates, "Key frames whose graphs are matched [3]");
  app.add_option("--out", arguments.out, "Folder for trajectories, loops, re-localizations");
  app.add_option("--load-sightings", arguments.load_sightings, "Of the map that the host loads");
  app.add_option("--save-sightings", arguments.save_sightings, "Beside the map that it saves");
  auto* kidnap_associations =
      app.add_option("--kidnap-associations", arguments.kidnap_associations, "Its pairs of images");
  app.add_option("--kidnap", arguments.kidnap_sequence, "Then shows frames of this sequence alone")
      ->needs(kidnap_associations);
  app.add_option("--kidnap-detections", arguments.kidnap_table, "Its node table")->needs(table);
  app.add_option("--kidnap-every", arguments.kidnap_every, "Every so many of its frames")
      ->check(CLI::PositiveNumber);
  app.add_option("--kidnap-window", arguments.kidnap_window,
                 "Seconds of shown frames in one graph, joined by the true relative poses");
  app.add_flag("--kidnap-without-depth", arguments.kidnap_without_depth,
               "The shown frames come without depth: they are looked up by directions alone");
}

}  // namespace semantic
