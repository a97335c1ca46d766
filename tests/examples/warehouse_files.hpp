// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/sensing/pinhole_camera.hpp>

#include "node_table.hpp"
#include "object_classes.hpp"
#include "scratch_folder.hpp"

/// 20 classes of a warehouse, none of them COCO's.
inline const std::string warehouse_classes =
    "# name, dynamics, look-alikes\n"
    "forklift, high\npallet jack, high\npicker, high\n\n"
    "pallet, low, loaded pallet | crate\nloaded pallet\ncrate, medium, , 0.3 x 0.3\n"
    "carton, medium\ntote, medium, carton\ndrum, medium\nroll cage, medium\n"
    "rack upright\nrack label\naisle sign\nfire extinguisher\nfire hose\nexit sign\ndock door\n"
    "charging station\nwrapping machine\nsafety mirror, low\n";

inline const std::string warehouse_camera = " --camera 260,260,159.5,119.5,320,240 ";

/// A hall of seeded objects, driven past to and fro by a camera that looks into it. What stands
/// there is the seed's alone; files are as a detector and an RGB-D camera write them.
class WarehouseFiles {
 public:
  /// @param offset  m, from one drive to the next
  WarehouseFiles(const program::ObjectClasses& classes, unsigned seed, double offset)
      : classes_(classes) {
    std::mt19937 random(seed);
    const auto within = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    std::vector<Object> objects;
    for (int i = 0; i < 24; ++i) {
      const double x = -2.8 + 0.24 * i;
      objects.push_back({topobag::ClassId{i % static_cast<int>(classes.catalog.size())},
                         {x, within(-1.0, 1.0), within(3.0, 6.0)},
                         within(0.2, 0.4)});
    }
    for (int k = 0; k < frame_count; ++k) {
      const double along = std::abs(k - frame_count / 2) * 0.2 - 1.2;
      table_.frames.push_back(seen(k, {along + offset, 0.0, offset}, objects));
    }
  }

  /// As a node table; returns its name.
  std::string write_table(const ScratchFolder& folder, const std::string& set) const {
    program::write_node_table(folder.path(set), table_, classes_.catalog);
    return folder.path(set);
  }

  /// The images of an RGB-D camera in TUM's layout.
  void write_images(const ScratchFolder& folder) const {
    std::ostringstream pairs, poses;
    for (const program::FrameRow& frame : table_.frames) {
      const std::string name = frame.name.substr(0, frame.name.find('.'));
      folder.write(frame.name, "P6\n320 240\n255\n" + std::string(3 * width * height, '\0'));
      folder.write(name + ".pgm", depth_image(frame));
      pairs << frame.timestamp << ' ' << frame.name << ' ' << frame.timestamp << ' ' << name
            << ".pgm\n";
      const Eigen::Vector3d t = frame.T_world_camera->translation();
      poses << frame.timestamp << ' ' << t.x() << ' ' << t.y() << ' ' << t.z() << " 0 0 0 1\n";
    }
    folder.write("associations.txt", pairs.str());
    folder.write("groundtruth.txt", poses.str());
  }

  /// COCO's list of results, its categories by their numbers.
  std::string coco_results() const {
    std::ostringstream json;
    for (const program::FrameRow& frame : table_.frames) {
      for (const topobag::RangedDetection& seen : frame.detections) {
        json << (json.tellp() > 0 ? "," : "[") << R"({"image_id": ")" << frame.name
             << R"(", "category_id": )" << topobag::value(seen.label) << R"(, "bbox": [)"
             << seen.box.x1 + 0.5 << ',' << seen.box.y1 + 0.5 << ',' << seen.box.width() << ','
             << seen.box.height() << R"(], "score": 0.9})";
      }
    }
    return json.str() + "]";
  }

  /// A text file of YOLO an image.
  void write_yolo(const ScratchFolder& folder) const {
    for (const program::FrameRow& frame : table_.frames) {
      std::ostringstream text;
      for (const topobag::RangedDetection& seen : frame.detections) {
        const Eigen::Vector2d center = seen.box.center();
        text << topobag::value(seen.label) << ' ' << (center.x() + 0.5) / width << ' '
             << (center.y() + 0.5) / height << ' ' << seen.box.width() / width << ' '
             << seen.box.height() / height << " 0.9\n";
      }
      folder.write(frame.name.substr(0, frame.name.find('.')) + ".txt", text.str());
    }
  }

 private:
  struct Object {
    topobag::ClassId label;
    Eigen::Vector3d position;  ///< m
    double size;               ///< m
  };

  static constexpr int frame_count = 25, width = 320, height = 240;

  static program::FrameRow seen(int k, const Eigen::Vector3d& camera,
                                const std::vector<Object>& objects) {
    program::FrameRow row;
    row.idx = k;
    row.name = "f" + std::to_string(100 + k) + ".ppm";
    row.timestamp = k;
    row.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(camera));
    const topobag::PinholeCamera<> lens{260.0, 260.0, 159.5, 119.5, width, height};
    for (const Object& object : objects) {
      const Eigen::Vector3d p = object.position - camera;
      const double half = lens.fx * object.size / p.z() / 2.0;
      const Eigen::Vector2d center(lens.fx * p.x() / p.z() + lens.cx,
                                   lens.fy * p.y() / p.z() + lens.cy);
      if (!lens.in_image(center, half)) continue;
      topobag::RangedDetection detection;
      detection.label = object.label;
      detection.confidence = 0.9;
      detection.box = topobag::box_around(center, 2.0 * half, 2.0 * half);
      detection.z = p.z();
      row.detections.push_back(detection);
    }
    return row;
  }

  /// A wall 8 m away and the objects before it, the nearest on top, in 1/1000 m.
  static std::string depth_image(const program::FrameRow& frame) {
    std::vector<double> depth(static_cast<std::size_t>(width * height), 8.0);
    for (const topobag::RangedDetection& seen : frame.detections) {
      for (int v = static_cast<int>(seen.box.y1); v <= static_cast<int>(seen.box.y2); ++v) {
        for (int u = static_cast<int>(seen.box.x1); u <= static_cast<int>(seen.box.x2); ++u) {
          double& z = depth.at(static_cast<std::size_t>(v * width + u));
          z = std::min(z, seen.z);
        }
      }
    }
    std::string image = "P5\n320 240\n65535\n";
    for (const double z : depth) {
      const int value = static_cast<int>(1000.0 * z);
      image += {static_cast<char>(value / 256), static_cast<char>(value % 256)};
    }
    return image;
  }

  program::ObjectClasses classes_;
  program::NodeTable table_;
};
