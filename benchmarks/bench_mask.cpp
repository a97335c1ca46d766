// SPDX-License-Identifier: MIT
// How much better is a camera's motion known when features on people are masked?
//
// True are the poses of fr3_walking_xyz's cameras and the boxes of its people, as a detector gave
// them. Simulated is all the rest: the features, their depths, how people stand within their boxes
// and how they walk (see simulated_features.hpp). From one frame to the next, and from key frame to
// key frame, the motion is estimated of all features, and of those that the mask leaves, once by
// boxes alone and once with the people's depth; and, to compare, of the background alone. The
// estimate is the library's own under its robust kernel. It starts from the least squares of the
// same features, or from the truth, which is what the best prediction of a tracker would give.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/class_catalog.hpp>

#include "draws.hpp"
#include "mask_gain.hpp"
#include "node_table.hpp"
#include "number_check.hpp"
#include "pair_times.hpp"
#include "simulated_features.hpp"

namespace {

using namespace bench;

const topobag::ClassCatalog coco = topobag::ClassCatalog::coco80();

/// The frames that are at least `interval` after the one before, s.
std::vector<program::FrameRow> key_frames(const std::vector<program::FrameRow>& frames,
                                          double interval) {
  std::vector<program::FrameRow> chosen;
  for (const program::FrameRow& frame : frames) {
    if (!frame.T_world_camera) continue;
    if (chosen.empty() || frame.timestamp - chosen.back().timestamp >= interval) {
      chosen.push_back(frame);
    }
  }
  return chosen;
}

std::vector<topobag::RangedDetection> people_in(const program::FrameRow& frame) {
  std::vector<topobag::RangedDetection> people;
  for (const topobag::RangedDetection& detection : frame.detections) {
    if (detection.label == coco.at("person")) people.push_back(detection);
  }
  return people;
}

/// Errors by the share that people cover, by the features kept, and by the start: of least squares,
/// then of the truth.
using Errors = std::array<std::array<std::array<MotionErrors, 2>, 4>, covered_band_ends.size()>;

Errors errors_of(const std::vector<program::FrameRow>& frames,
                 const topobag::PinholeCamera<>& camera, const FeatureSimulation& simulation,
                 std::uint32_t seed, std::uint32_t draws_of_pair) {
  Errors errors;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    const Eigen::Isometry3d &first = *frames[i].T_world_camera,
                            &second = *frames[i + 1].T_world_camera;
    const Eigen::Isometry3d truth = first.inverse() * second;
    for (std::uint32_t draw = 0; draw < draws_of_pair; ++draw) {
      program::Draws draws({seed, static_cast<std::uint32_t>(i), draw});
      const SimulatedFeatures made =
          simulate_features(people_in(frames[i]), camera, first, second,
                            frames[i + 1].timestamp - frames[i].timestamp, simulation, draws);
      auto& band = errors[covered_band(made.covered)];
      for (std::size_t k = 0; k < all_kept_features.size(); ++k) {
        const auto pairs = kept_pairs(made, all_kept_features[k], coco);
        band[k][0].add(pairs, std::nullopt, truth);
        band[k][1].add(pairs, truth, truth);
      }
    }
  }
  return errors;
}

void print(double interval, const Errors& errors) {
  if (interval > 0.0) {
    std::printf("\nkey frames every %g s\n", interval);
  } else {
    std::printf("\neach frame and the next\n");
  }
  std::printf("%-11s %-19s %6s %8s %5s | %-29s | %s\n", "", "", "", "", "", "start: least squares",
              "start: the truth");
  std::printf("%-11s %-19s %6s %8s %5s |", "covered", "motion of", "pairs", "features", "none");
  for (int i = 0; i < 2; ++i)
    std::printf(" %6s %6s %7s %7s %s", "mm", "95 %", "deg", "95 %", i ? "\n" : "|");
  for (std::size_t b = 0; b < errors.size(); ++b) {
    char name[40] = "nothing";
    if (b > 0) {
      std::snprintf(name, sizeof name, "%g-%g %%", 100.0 * covered_band_ends[b - 1],
                    100.0 * covered_band_ends[b]);
    }
    for (std::size_t k = 0; k < all_kept_features.size(); ++k) {
      const char* kept = to_string(all_kept_features[k]);
      const MotionErrors& any = errors[b][k][0];
      const std::size_t tries = any.none + any.millimetres.size();
      if (any.millimetres.empty()) continue;
      const double features = static_cast<double>(any.pairs) / static_cast<double>(tries);
      std::printf("%-11s %-19s %6zu %8.0f %5zu |", name, kept, tries, features, any.none);
      std::string json;
      for (std::size_t start = 0; start < 2; ++start) {
        const MotionErrors& e = errors[b][k][start];
        const std::array<double, 4> figures{share(e.millimetres, 0.5), share(e.millimetres, 0.95),
                                            share(e.degrees, 0.5), share(e.degrees, 0.95)};
        std::printf(" %6.2f %6.2f %7.3f %7.3f %s", figures[0], figures[1], figures[2], figures[3],
                    start ? "\n" : "|");
        char fields[160];
        std::snprintf(fields, sizeof fields,
                      ",\"%s\":{\"median_mm\":%.3f,\"p95_mm\":%.3f,\"median_deg\":%.4f,"
                      "\"p95_deg\":%.4f}",
                      start ? "from_truth" : "from_fit", figures[0], figures[1], figures[2],
                      figures[3]);
        json += fields;
      }
      std::printf(
          "{\"bench\":\"mask\",\"interval_s\":%g,\"covered\":\"%s\",\"kept\":\"%s\",\"pairs\":%zu,"
          "\"features\":%.1f,\"none\":%zu%s}\n",
          interval, name, kept, tries, features, any.none, json.c_str());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const char* const variable = std::getenv("TOPOBAG_DATA");
  std::string data = variable ? variable : "";
  std::vector<double> intervals{0.0, 0.4};
  FeatureSimulation simulation;
  std::uint32_t seed = 1, draws = 4;
  CLI::App app("What the mask does to a camera's motion where people walk; features are simulated");
  app.add_option("data", data, "folder that holds nodes/fr3_walking_xyz.yolov8nseg_tri");
  app.add_option("--interval", intervals, "s between the frames of a pair; 0: each and the next")
      ->delimiter(',');
  app.add_option("--missed", simulation.missed, "share of people whom the mask is not told of")
      ->check(program::number_within(0, 1));
  app.add_option("--speed", simulation.speed, "m/s at which people walk at most")
      ->check(program::number_within(0));
  app.add_option("--draws", draws, "how often each pair of frames is simulated");
  app.add_option("--seed", seed, "of the simulation");
  CLI11_PARSE(app, argc, argv);
  const std::string set = data + "/nodes/fr3_walking_xyz.yolov8nseg_tri";
  if (data.empty() || !std::filesystem::exists(set + ".frames.csv")) {
    std::cout << "Skips the mask: no folder with fr3_walking_xyz, given or in TOPOBAG_DATA.\n";
    return 0;
  }
  try {
    const topobag::PinholeCamera<> fr3{535.4, 539.2, 320.1, 247.6, 640, 480};
    const program::NodeTable table = program::read_node_table(set);
    for (const double interval : intervals) {
      print(interval, errors_of(key_frames(table.frames, interval), fr3, simulation, seed, draws));
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
