// SPDX-License-Identifier: MIT
#include "nodes_checkpoint.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "csv_reader.hpp"
#include "input_error.hpp"
#include "json_output.hpp"

namespace program {
namespace {

/// What belongs to a table so far, to tell that its files are of one moment.
Json state_of(const std::string& made_with, const DetectedNodes& detected) {
  std::size_t detections = 0;
  for (const FrameRow& frame : detected.table.frames) detections += frame.detections.size();
  return {{"made_with", made_with},
          {"frames", detected.table.frames.size()},
          {"detections", detections},
          {"outside", detected.outside}};
}

}  // namespace

FrameRow row_of(const RgbdFrame& frame, std::size_t idx) {
  FrameRow row;
  row.idx = static_cast<std::int64_t>(idx);
  row.name = std::filesystem::path(frame.rgb).filename().string();
  row.timestamp = frame.timestamp;
  row.T_world_camera = frame.T_world_camera;
  return row;
}

NodesCheckpoint::NodesCheckpoint(const std::string& set, std::string made_with,
                                 topobag::ClassCatalog catalog, Clock::duration pause)
    : set_(set_name(set) + ".partial"),
      made_with_(std::move(made_with)),
      catalog_(std::move(catalog)),
      pause_(pause) {}

DetectedNodes NodesCheckpoint::earlier(const std::vector<RgbdFrame>& frames) const {
  if (!std::filesystem::exists(set_ + ".json")) return {};
  try {
    const Json state = Json::parse(read_file(set_ + ".json"));
    DetectedNodes kept{read_node_table(set_, catalog_), state.at("outside").get<std::size_t>()};
    std::vector<FrameRow>& rows = kept.table.frames;
    if (state != state_of(made_with_, kept) || rows.size() > frames.size()) return {};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      FrameRow row = row_of(frames[i], i);  // its numbers are not rounded
      if (row.name != rows[i].name) return {};
      row.detections = std::move(rows[i].detections);
      row.depth = rows[i].depth;
      rows[i] = std::move(row);
    }
    return kept;
  } catch (const Json::exception&) {
    return {};
  } catch (const topobag::Error&) {
    return {};
  }
}

void NodesCheckpoint::require_own(const std::vector<RgbdFrame>& frames) const {
  if (!std::filesystem::exists(set_ + ".json")) return;
  std::size_t kept = 0;
  try {
    const Json state = Json::parse(read_file(set_ + ".json"));
    kept = state.at("frames").get<std::size_t>();
    if (kept == 0 || !earlier(frames).table.frames.empty()) return;
    // One that ended while it kept its table left files that are not of one moment.
    const bool own = state.at("made_with").get<std::string>() == made_with_;
    if (own && state != state_of(made_with_, {read_node_table(set_, catalog_),
                                              state.at("outside").get<std::size_t>()})) {
      return;
    }
  } catch (const Json::exception&) {
    return;
  } catch (const topobag::Error&) {
    return;
  }
  throw InputError(set_ + ".json", "an earlier run with other options, or of other images, kept " +
                                       std::to_string(kept) +
                                       " frames; give what it was given to go on, delete " + set_ +
                                       ".* to begin anew, or give another --out");
}

void NodesCheckpoint::keep(const DetectedNodes& detected) {
  if (Clock::now() - kept_ < pause_) return;
  write_node_table(set_, detected.table, catalog_);
  write_file(set_ + ".json", json_text(state_of(made_with_, detected)));
  kept_ = Clock::now();
}

void NodesCheckpoint::remove() const {
  for (const char* ending : {".json", ".nodes.csv", ".frames.csv"}) {
    std::filesystem::remove(set_ + ending);
  }
}

}  // namespace program
