// SPDX-License-Identifier: MIT
#include "node_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "csv_reader.hpp"

namespace program {
namespace {

std::string frames_file(const std::string& set) { return set + ".frames.csv"; }
std::string nodes_file(const std::string& set) { return set + ".nodes.csv"; }

/// The columns of a pose, or nothing when the table has none of them.
std::optional<std::array<std::size_t, 7>> pose_columns(const CsvReader& csv) {
  const std::array<const char*, 7> names{"tx", "ty", "tz", "qx", "qy", "qz", "qw"};
  const bool any = std::any_of(names.begin(), names.end(),
                               [&](const char* name) { return csv.find_column(name).has_value(); });
  if (!any) return std::nullopt;
  std::array<std::size_t, 7> columns{};
  for (std::size_t i = 0; i < names.size(); ++i) columns[i] = csv.column(names[i]);
  return columns;
}

std::optional<Eigen::Isometry3d> read_pose(const CsvReader& csv,
                                           const std::array<std::size_t, 7>& columns) {
  const bool absent = std::all_of(columns.begin(), columns.end(),
                                  [&](std::size_t column) { return csv.text(column).empty(); });
  if (absent) return std::nullopt;
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = csv.number(columns[i]);
  const Eigen::Quaterniond rotation(v[6], v[3], v[4], v[5]);
  if (std::abs(rotation.norm() - 1.0) > 0.01) {
    throw csv.error("the quaternion qx qy qz qw has norm " + std::to_string(rotation.norm()) +
                    ", not 1");
  }
  return Eigen::Translation3d(v[0], v[1], v[2]) * rotation.normalized();
}

std::vector<FrameRow> read_frames(const std::string& path) {
  CsvReader csv(path);
  const std::size_t idx = csv.column("idx");
  const std::size_t frame = csv.column("frame");
  const std::size_t timestamp = csv.column("timestamp");
  const auto pose = pose_columns(csv);
  std::vector<FrameRow> frames;
  std::set<std::int64_t> known;
  while (csv.next()) {
    FrameRow row;
    row.idx = csv.integer(idx);
    if (!known.insert(row.idx).second) {
      throw csv.error("idx " + std::to_string(row.idx) + " is there twice");
    }
    row.name = csv.text(frame);
    row.timestamp = csv.number(timestamp);
    if (!frames.empty() && row.timestamp < frames.back().timestamp) {
      throw csv.error("the timestamp is before that of the row above; sort the frames by time");
    }
    if (pose) row.T_world_camera = read_pose(csv, *pose);
    frames.push_back(std::move(row));
  }
  if (frames.empty()) throw InputError(path, "the table holds no frame");
  return frames;
}

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
      throw csv_.error("conf has to lie in [0, 1]");
    }
    const double w = csv_.number(w_);
    const double h = csv_.number(h_);
    if (w <= 0.0 || h <= 0.0) throw csv_.error("w and h, the size of the box, have to be positive");
    detection.box = topobag::box_around({csv_.number(u_), csv_.number(v_)}, w, h);
    detection.z = csv_.number(z_);
    if (detection.z < 0.0) throw csv_.error("z has to be positive, or 0 where it is not known");
    return detection;
  }

 private:
  topobag::ClassId read_label() const {
    const topobag::ClassId label = named_label();
    if (class_id_ && !csv_.text(*class_id_).empty() &&
        csv_.integer(*class_id_) != topobag::value(label)) {
      throw csv_.error("class_id " + std::string(csv_.text(*class_id_)) + " does not go with '" +
                       std::string(csv_.text(class_)) + "', which is number " +
                       std::to_string(topobag::value(label)));
    }
    return label;
  }

  topobag::ClassId named_label() const {
    try {
      return catalog_.at(csv_.text(class_));
    } catch (const topobag::UnknownClass& unknown) {
      throw csv_.error(unknown.what());
    }
  }

  const CsvReader& csv_;
  const topobag::ClassCatalog& catalog_;
  std::size_t class_ = csv_.column("class");
  std::optional<std::size_t> class_id_ = csv_.find_column("class_id");
  std::size_t conf_ = csv_.column("conf");
  std::size_t u_ = csv_.column("u");
  std::size_t v_ = csv_.column("v");
  std::size_t w_ = csv_.column("w");
  std::size_t h_ = csv_.column("h");
  std::size_t z_ = csv_.column("z");
};

/// Gives each row of the detections to its frame.
void read_detections(const std::string& path, const topobag::ClassCatalog& catalog,
                     std::vector<FrameRow>& frames) {
  std::map<std::int64_t, FrameRow*> by_idx;
  for (FrameRow& frame : frames) by_idx.emplace(frame.idx, &frame);
  CsvReader csv(path);
  const std::size_t idx = csv.column("idx");
  const DetectionRows rows(csv, catalog);
  while (csv.next()) {
    const auto frame = by_idx.find(csv.integer(idx));
    if (frame == by_idx.end()) {
      throw csv.error("idx " + std::string(csv.text(idx)) + " is not among the frames");
    }
    frame->second->detections.push_back(rows.read());
  }
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

NodeTable read_node_table(const std::string& set, const topobag::ClassCatalog& catalog) {
  NodeTable table{read_frames(frames_file(set))};
  read_detections(nodes_file(set), catalog, table.frames);
  return table;
}

void write_node_table(const std::string& set, const NodeTable& table,
                      const topobag::ClassCatalog& catalog) {
  std::ostringstream frames;
  std::ostringstream nodes;
  frames << std::fixed << "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw\n";
  nodes << std::fixed << "idx,class_id,class,conf,u,v,w,h,z\n";
  for (const FrameRow& frame : table.frames) {
    if (frame.name.find_first_of(",\"\r\n") != std::string::npos) {
      throw InputError(frames_file(set), "the name of frame " + std::to_string(frame.idx) +
                                             " holds a comma, a quote or a line break");
    }
    frames << frame.idx << ',' << frame.name << ',' << std::setprecision(6) << frame.timestamp
           << std::setprecision(5);
    write_pose(frames, frame.T_world_camera);
    frames << '\n';
    for (const topobag::RangedDetection& detection : frame.detections) {
      const Eigen::Vector2d center = detection.box.center();
      nodes << frame.idx << ',' << topobag::value(detection.label) << ','
            << catalog.name(detection.label) << ',' << std::setprecision(3) << detection.confidence
            << std::setprecision(1) << ',' << center.x() << ',' << center.y() << ','
            << detection.box.width() << ',' << detection.box.height() << std::setprecision(3) << ','
            << detection.z << '\n';
    }
  }
  write_file(frames_file(set), frames.str());
  write_file(nodes_file(set), nodes.str());
}

}  // namespace program
