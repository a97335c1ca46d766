// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "place_run.hpp"

/// How the runs over the shared sets are made.
struct SharedRunsOptions {
  std::vector<double> windows{0.0, 3.0};     ///< s
  std::vector<double> min_confidences{0.3};  ///< least detection scores
  std::size_t rooms_stride = 1;              ///< of the queries in rooms, which are many
};

/// A table of the data folder.
struct SharedSet {
  std::string name, table, place;
  topobag::PinholeCamera<> camera;
  double interval;  // s
};

/// All runs over the sets of a data folder, each without and with gravity: `nodes/` of the TUM
/// sequences, and `rooms/`. fr3's sequences share a place.
inline std::vector<PlaceRun> shared_runs(const std::string& folder,
                                         const SharedRunsOptions& options) {
  const topobag::PinholeCamera<> fr1{517.3, 516.5, 318.6, 255.3, 640, 480},
      fr2{520.9, 521.0, 325.1, 249.7, 640, 480}, fr3{535.4, 539.2, 320.1, 247.6, 640, 480},
      rooms{525.0, 525.0, 319.5, 239.5, 640, 480};
  const auto sequence = [&](const char* name, const char* table, const char* place,
                            const topobag::PinholeCamera<>& camera) {
    return SharedSet{name, folder + "/nodes/" + table, place, camera, 0.4};
  };
  const auto room = [&](const char* name) {
    return SharedSet{std::string("rooms_") + name, folder + "/rooms/" + name, "rooms", rooms, 0.0};
  };
  const SharedSet xyz_yolox = sequence("xyz_yolox", "tum_fr1_xyz.yolox_nano_416", "fr1", fr1),
                  rpy_yolox = sequence("rpy_yolox", "tum_fr1_rpy.yolox_nano_416", "fr1", fr1),
                  xyz_pico = sequence("xyz_pico", "tum_fr1_xyz.picodet_s_416", "fr1", fr1),
                  rpy_pico = sequence("rpy_pico", "tum_fr1_rpy.picodet_s_416", "fr1", fr1),
                  office = sequence("long_office", "fr3_long_office.eao_yolo_tri", "fr3", fr3),
                  sitting = sequence("sitting", "fr3_sitting_xyz.yolov8nseg_tri", "fr3", fr3),
                  walking = sequence("walking", "fr3_walking_xyz.yolov8nseg_tri", "fr3", fr3),
                  desk = sequence("fr2_desk", "fr2_desk.oaslam_yolov5_tri", "fr2", fr2),
                  own_map = room("own_map"), other_map = room("other_map"), query = room("query"),
                  query_moved = room("query_moved");

  std::vector<PlaceRun> runs;
  for (const double min_confidence : options.min_confidences) {
    for (const double window : options.windows) {
      for (const bool gravity : {false, true}) {
        const auto add = [&](PlaceKind kind, const SharedSet& asked, const SharedSet& map) {
          PlaceRun run;
          run.name = kind == PlaceKind::loops ? asked.name : asked.name + ":" + map.name;
          run.kind = kind;
          run.map = map.table;
          run.query = asked.table;
          run.map_camera = map.camera;
          run.query_camera = asked.camera;
          run.window = window;
          run.interval = asked.interval;
          run.min_confidence = min_confidence;
          if (gravity) run.world_up = Eigen::Vector3d::UnitZ();
          run.places = {asked.place, map.place};
          if (asked.interval == 0.0) run.stride = options.rooms_stride;
          runs.push_back(run);
        };
        add(PlaceKind::same, rpy_yolox, xyz_yolox);
        add(PlaceKind::same, rpy_pico, xyz_pico);
        add(PlaceKind::same, walking, sitting);
        add(PlaceKind::same, sitting, office);
        add(PlaceKind::same, office, sitting);
        add(PlaceKind::loops, office, office);
        add(PlaceKind::loops, desk, desk);
        add(PlaceKind::same, query, own_map);
        add(PlaceKind::same, query_moved, own_map);
        add(PlaceKind::other, query, other_map);
        const std::vector<SharedSet> places{xyz_yolox, rpy_yolox, xyz_pico, rpy_pico,
                                            office,    sitting,   desk};
        for (const SharedSet& map : places) {
          for (const SharedSet& asked : places) {
            if (asked.place != map.place) add(PlaceKind::other, asked, map);
          }
        }
      }
    }
  }
  return runs;
}
