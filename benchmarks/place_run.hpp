// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <topobag/sensing/pinhole_camera.hpp>

#include "csv_reader.hpp"

/// What map and query have to do with each other.
enum class PlaceKind {
  same,   ///< the query comes back to the map's place
  other,  ///< they share no place: whatever is accepted is wrong
  loops,  ///< a sequence that comes back to its own places
};

inline const char* to_string(PlaceKind kind) {
  return kind == PlaceKind::same ? "same" : kind == PlaceKind::other ? "other" : "loops";
}

/// Key frames to look up, where, and how their graphs are made.
struct PlaceRun {
  std::string name;
  PlaceKind kind = PlaceKind::same;
  double min_gap = 20.0;  ///< s; of loops
  std::string map;        ///< a node table
  std::string query;      ///< the same one for loops
  topobag::PinholeCamera<> map_camera;
  topobag::PinholeCamera<> query_camera;
  double window = 0.0;                      ///< s of key frames that a graph fuses
  double interval = 0.4;                    ///< s from key frame to key frame
  double min_confidence = 0.3;              ///< least score of a detection
  std::optional<Eigen::Vector3d> world_up;  ///< of both tables; nothing: no gravity
  std::size_t stride = 1;                   ///< every so many usable queries are looked up
  std::vector<std::string> places;          ///< that the run tells of, where they are named
};

namespace place_run_fields {

/// So many numbers between blanks.
inline Eigen::VectorXd numbers_of(const program::CsvReader& csv, std::size_t column,
                                  Eigen::Index count) {
  std::istringstream words{std::string(csv.text(column))};
  Eigen::VectorXd numbers(count);
  std::string word;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto number = words >> word ? program::parse_number(word) : std::nullopt;
    if (!number) break;
    numbers[i] = *number;
    if (i + 1 == count && !(words >> word)) return numbers;
  }
  throw csv.error("'" + std::string(csv.text(column)) + "' is not " + std::to_string(count) +
                  " numbers between blanks");
}

inline topobag::PinholeCamera<> camera_of(const program::CsvReader& csv, std::size_t column) {
  const Eigen::VectorXd v = numbers_of(csv, column, 4);
  const topobag::PinholeCamera<> camera{v[0], v[1], v[2], v[3], 640, 480};
  if (!(camera.fx > 0.0 && camera.fy > 0.0)) throw csv.error("a focal length is not above 0");
  return camera;
}

inline PlaceKind kind_of(const program::CsvReader& csv, std::size_t column) {
  for (const PlaceKind kind : {PlaceKind::same, PlaceKind::other, PlaceKind::loops}) {
    if (csv.text(column) == to_string(kind)) return kind;
  }
  throw csv.error("'" + std::string(csv.text(column)) + "' is not same, other or loops");
}

}  // namespace place_run_fields

/// Reads a list of runs: a CSV file with the columns name, kind (same, other, loops), min_gap (s),
/// map, query (tables; relative ones lie beside the list), map_camera, query_camera (fx fy cx cy
/// between blanks; images of 640 x 480), window, interval (s), min_confidence, world_up (x y z, or
/// none) and, if it is there, places (names between blanks). Throws program::InputError with the
/// file and the line.
inline std::vector<PlaceRun> read_place_runs(const std::string& path) {
  program::CsvReader csv(path);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const auto name = csv.column("name"), kind = csv.column("kind"), gap = csv.column("min_gap"),
             map = csv.column("map"), query = csv.column("query"),
             map_camera = csv.column("map_camera"), query_camera = csv.column("query_camera"),
             window = csv.column("window"), interval = csv.column("interval"),
             confidence = csv.column("min_confidence"), up = csv.column("world_up");
  const auto places = csv.find_column("places");
  std::vector<PlaceRun> runs;
  while (csv.next()) {
    PlaceRun run;
    run.name = std::string(csv.text(name));
    run.kind = place_run_fields::kind_of(csv, kind);
    if (run.kind == PlaceKind::loops) run.min_gap = csv.number(gap);
    run.map = (folder / csv.text(map)).string();
    run.query = (folder / csv.text(query)).string();
    if (run.kind == PlaceKind::loops && run.map != run.query) {
      throw csv.error("loops are looked for in one table: map and query differ");
    }
    run.map_camera = place_run_fields::camera_of(csv, map_camera);
    run.query_camera = place_run_fields::camera_of(csv, query_camera);
    run.window = csv.number(window);
    run.interval = csv.number(interval);
    run.min_confidence = csv.number(confidence);
    if (csv.text(up) != "none") {
      run.world_up = place_run_fields::numbers_of(csv, up, 3);
      if (run.world_up->isZero(0.0)) throw csv.error("the world's up has no direction");
    }
    if (places) {
      std::istringstream names{std::string(csv.text(*places))};
      for (std::string place; names >> place;) run.places.push_back(place);
    }
    runs.push_back(std::move(run));
  }
  return runs;
}
