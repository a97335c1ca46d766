// SPDX-License-Identifier: MIT
#include "node_table.hpp"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "appearance_columns.hpp"
#include "csv_pose.hpp"
#include "csv_reader.hpp"
#include "depth_column.hpp"
#include "label_column.hpp"
#include "path_kind.hpp"
#include "recorded.hpp"

namespace program {
namespace {

std::string frames_file(const std::string& set) { return set_name(set) + ".frames.csv"; }
std::string nodes_file(const std::string& set) { return set_name(set) + ".nodes.csv"; }

/// Reads the rows of the detections one by one.
class DetectionRows {
 public:
  DetectionRows(const CsvReader& csv, const topobag::ClassCatalog& catalog)
      : csv_(csv), catalog_(catalog) {}

  topobag::RangedDetection read() const {
    topobag::RangedDetection detection;
    detection.label = read_label();
    detection.confidence = csv_.number(conf_);
    if (detection.confidence < 0.0 || detection.confidence > 1.0) {
      throw csv_.error("conf has to lie in [0, 1], not " + std::string(csv_.text(conf_)));
    }
    const double w = csv_.number(w_);
    const double h = csv_.number(h_);
    if (w <= 0.0 || h <= 0.0) throw csv_.error("w and h, the size of the box, have to be positive");
    detection.box = topobag::box_around({csv_.number(u_), csv_.number(v_)}, w, h);
    const bool known = !says_nan(csv_.text(z_));
    detection.z = known ? csv_.number(z_) : -1.0;
    if (detection.z < 0.0) {
      throw csv_.error("z is " + std::string(csv_.text(z_)) +
                       "; it has to be positive, or 0 where it is not known");
    }
    detection.label_weights = read_labels(csv_, labels_, detection.label, catalog_);
    return detection;
  }

 private:
  topobag::ClassId read_label() const {
    if (!class_) return numbered_label();
    const topobag::ClassId label = named_label();
    if (class_id_ && !csv_.text(*class_id_).empty() &&
        csv_.integer(*class_id_) != topobag::value(label)) {
      throw csv_.error("class_id " + std::string(csv_.text(*class_id_)) + " does not go with '" +
                       std::string(csv_.text(*class_)) + "', which is number " +
                       std::to_string(topobag::value(label)));
    }
    return label;
  }

  topobag::ClassId named_label() const {
    return csv_.located([&] { return catalog_.at(csv_.text(*class_)); });
  }

  topobag::ClassId numbered_label() const {
    const std::int64_t number = csv_.integer(*class_id_);
    const bool is_class = number >= 0 && number <= std::numeric_limits<std::int32_t>::max() &&
                          catalog_.contains(topobag::ClassId{static_cast<std::int32_t>(number)});
    if (!is_class) {
      throw csv_.error("class_id " + std::to_string(number) +
                       " is the number of no class; give the table's classes by --classes");
    }
    return topobag::ClassId{static_cast<std::int32_t>(number)};
  }

  /// Numbers alone will do.
  static std::optional<std::size_t> class_column(const CsvReader& csv) {
    return csv.find_column("class_id") ? csv.find_column("class") : csv.column("class");
  }

  const CsvReader& csv_;
  const topobag::ClassCatalog& catalog_;
  std::optional<std::size_t> class_ = class_column(csv_);
  std::optional<std::size_t> class_id_ = csv_.find_column("class_id");
  std::size_t conf_ = csv_.column("conf");
  std::size_t u_ = csv_.column("u");
  std::size_t v_ = csv_.column("v");
  std::size_t w_ = csv_.column("w");
  std::size_t h_ = csv_.column("h");
  std::size_t z_ = csv_.column("z");
  std::optional<std::size_t> labels_ = csv_.find_column("labels");
};

/// Gives each row of the detections to its frame.
void read_detections(const std::string& path, const topobag::ClassCatalog& catalog,
                     NodeTable& table) {
  std::map<std::int64_t, FrameRow*> by_idx;
  for (FrameRow& frame : table.frames) by_idx.emplace(frame.idx, &frame);
  CsvReader csv(path);
  const std::size_t idx = csv.column("idx");
  const DetectionRows rows(csv, catalog);
  AppearanceColumns appearance(csv);
  while (csv.next()) {
    const auto frame = by_idx.find(csv.integer(idx));
    if (frame == by_idx.end()) {
      throw csv.error("idx " + std::string(csv.text(idx)) + " is not among the frames, from " +
                      std::to_string(by_idx.begin()->first) + " to " +
                      std::to_string(by_idx.rbegin()->first) + "; are both files of one table?");
    }
    frame->second->detections.push_back(rows.read());
    frame->second->detections.back().appearance = appearance.read();
  }
  table.appearance = appearance.name();
}

bool any_label_weights(const NodeTable& table) {
  return std::any_of(table.frames.begin(), table.frames.end(), [](const FrameRow& frame) {
    return std::any_of(frame.detections.begin(), frame.detections.end(),
                       [](const auto& detection) { return !detection.label_weights.empty(); });
  });
}

/// Numbers in the descriptors of the table; 0 where there are none.
std::size_t descriptor_length(const NodeTable& table) {
  topobag::AppearanceKind kind;
  for (const FrameRow& frame : table.frames) {
    for (const topobag::RangedDetection& detection : frame.detections) {
      kind = topobag::common_kind(kind, detection.appearance.kind(), "a detection");
    }
  }
  return kind.length();
}

void write_pose(std::ostream& out, const std::optional<Eigen::Isometry3d>& T_world_camera) {
  if (!T_world_camera) {
    out << ",,,,,,,";
    return;
  }
  const Eigen::Vector3d t = T_world_camera->translation();
  const Eigen::Quaterniond q(T_world_camera->linear());
  for (const double x : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) out << ',' << x;
}

}  // namespace

std::string set_name(const std::string& path) {
  for (const std::string ending : {".frames.csv", ".nodes.csv", ".clusters.csv"}) {
    const bool ends = path.size() > ending.size() &&
                      path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
    if (ends) return path.substr(0, path.size() - ending.size());
  }
  return path;
}

std::vector<FrameRow> read_frames(const std::string& set) {
  const std::string path = frames_file(set);
  const PathKind kind = path_kind(set);
  if (kind == PathKind::folder) {
    throw InputError(set, "it is a folder; name SET of SET.frames.csv and SET.nodes.csv in it");
  }
  if (kind != PathKind::table && kind != PathKind::nothing && kind != PathKind::unreadable) {
    throw InputError(set,
                     "it is no table, which is two files; name SET of SET.frames.csv and "
                     "SET.nodes.csv");
  }
  CsvReader csv(path);
  const std::size_t idx = csv.column("idx");
  const std::size_t frame = csv.column("frame");
  const std::size_t timestamp = csv.column("timestamp");
  const std::optional<std::size_t> depth = csv.find_column("depth");
  const CsvPose pose(csv);
  std::vector<FrameRow> frames;
  std::set<std::int64_t> known;
  while (csv.next()) {
    FrameRow row;
    row.idx = csv.integer(idx);
    if (!known.insert(row.idx).second) {
      throw csv.error("idx " + std::to_string(row.idx) + " is there twice");
    }
    row.name = csv.text(frame);
    row.timestamp = csv.seconds(timestamp);
    if (!frames.empty() && row.timestamp < frames.back().timestamp) {
      throw csv.error("the timestamp is before that of the row above; sort the frames by time");
    }
    if (!frames.empty() && row.timestamp == frames.back().timestamp) {
      throw csv.error(
          "the timestamp is that of the row above; write stamps with their fractions of a second, "
          "and each image once");
    }
    row.T_world_camera = pose.read();
    row.depth = read_depth(csv, depth);
    frames.push_back(std::move(row));
  }
  if (frames.empty()) throw InputError(path, "the table holds no frame");
  require_recorded(path, frames, [](const FrameRow& one) { return one.timestamp; });
  return frames;
}

NodeTable read_node_table(const std::string& set, const topobag::ClassCatalog& catalog) {
  NodeTable table{read_frames(set)};
  read_detections(nodes_file(set), catalog, table);
  return table;
}

void write_node_table(const std::string& set, const NodeTable& table,
                      const topobag::ClassCatalog& catalog) {
  std::ostringstream frames;
  std::ostringstream nodes;
  const bool depth = std::any_of(table.frames.begin(), table.frames.end(),
                                 [](const FrameRow& frame) { return frame.depth.has_value(); });
  frames << std::fixed << "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw" << (depth ? ",depth\n" : "\n");
  nodes << std::fixed << "idx,class_id,class,conf,u,v,w,h,z";
  const bool labels = any_label_weights(table);
  if (labels) nodes << ",labels";
  const std::size_t length = descriptor_length(table);
  AppearanceColumns::write_header(nodes, length);
  nodes << '\n';
  for (const FrameRow& frame : table.frames) {
    if (frame.name.find_first_of(",\"\r\n") != std::string::npos) {
      throw InputError(frames_file(set), "the name of frame " + std::to_string(frame.idx) +
                                             " holds a comma, a quote or a line break");
    }
    frames << frame.idx << ',' << frame.name << ',' << std::setprecision(6) << frame.timestamp
           << std::setprecision(5);
    write_pose(frames, frame.T_world_camera);
    if (depth) frames << ',' << (frame.depth ? depth_text(*frame.depth) : "");
    frames << '\n';
    for (const topobag::RangedDetection& detection : frame.detections) {
      const Eigen::Vector2d center = detection.box.center();
      nodes << frame.idx << ',' << topobag::value(detection.label) << ','
            << catalog.name(detection.label) << ',' << std::setprecision(3) << detection.confidence
            << std::setprecision(1) << ',' << center.x() << ',' << center.y() << ','
            << detection.box.width() << ',' << detection.box.height() << std::setprecision(3) << ','
            << detection.z;
      if (labels) nodes << ',' << labels_text(detection.label_weights, catalog);
      AppearanceColumns::write(nodes, detection.appearance, table.appearance, length);
      nodes << '\n';
    }
  }
  write_files({{frames_file(set), frames.str()}, {nodes_file(set), nodes.str()}});
}

}  // namespace program
