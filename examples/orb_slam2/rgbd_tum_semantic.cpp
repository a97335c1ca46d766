// SPDX-License-Identifier: MIT
// ORB-SLAM2 with a bag of topology graphs beside it, on an RGB-D sequence of the TUM benchmark.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <opencv2/core/persistence.hpp>
#include <opencv2/imgcodecs.hpp>

#include <KeyFrameDatabase.h>
#include <System.h>

#include <topobag/adaptors/opencv.hpp>
#include <topobag/evaluation/alignment.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/evaluation/trajectory_error.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>
#include <topobag/sensing/range_detections.hpp>

#include <csv_reader.hpp>
#include <node_table.hpp>
#include <stopwatch.hpp>

#include "semantic_slam.hpp"

namespace semantic {
namespace {

struct Arguments {
  std::string vocabulary, settings, sequence, associations;
  std::string table, model;
  std::string kidnap_sequence, kidnap_associations, kidnap_table;
  std::size_t kidnap_every = 12;
  double kidnap_window = 0.0;
  double window = 3.0;
  std::size_t max_places = 5;
  std::size_t candidates = 0;
  std::string out = ".";
  bool mask = false;
  bool stock = false;
  bool no_wait = false;
};

/// What the host's settings say of the camera.
struct Calibration {
  topobag::PinholeCamera<> camera;
  cv::Mat matrix, distortion;
  double depth_scale = 1.0;
};

Calibration read_calibration(const std::string& settings) {
  const cv::FileStorage file(settings, cv::FileStorage::READ);
  if (!file.isOpened()) throw topobag::Error(settings + ": the file cannot be read");
  Calibration calibration;
  auto& camera = calibration.camera;
  camera.fx = static_cast<double>(file["Camera.fx"]);
  camera.fy = static_cast<double>(file["Camera.fy"]);
  camera.cx = static_cast<double>(file["Camera.cx"]);
  camera.cy = static_cast<double>(file["Camera.cy"]);
  camera.width = static_cast<int>(file["Camera.width"]);
  camera.height = static_cast<int>(file["Camera.height"]);
  camera.validate();
  calibration.matrix = (cv::Mat_<double>(3, 3) << camera.fx, 0.0, camera.cx, 0.0, camera.fy,
                        camera.cy, 0.0, 0.0, 1.0);
  calibration.distortion = cv::Mat::zeros(5, 1, CV_64F);
  const char* const names[] = {"Camera.k1", "Camera.k2", "Camera.p1", "Camera.p2", "Camera.k3"};
  for (int i = 0; i < 5; ++i) {
    if (!file[names[i]].empty()) {
      calibration.distortion.at<double>(i) = static_cast<double>(file[names[i]]);
    }
  }
  calibration.depth_scale = static_cast<double>(file["DepthMapFactor"]);
  return calibration;
}

struct FramePaths {
  double stamp = 0.0;  ///< s
  std::string rgb, depth;
};

std::vector<FramePaths> read_associations(const std::string& sequence, const std::string& file) {
  std::vector<FramePaths> frames;
  std::istringstream lines(program::read_file(file));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    FramePaths frame;
    std::string depth_stamp;
    if (!(words >> frame.stamp >> frame.rgb >> depth_stamp >> frame.depth)) continue;
    frame.rgb = sequence + "/" + frame.rgb;
    frame.depth = sequence + "/" + frame.depth;
    frames.push_back(frame);
  }
  if (frames.empty()) throw topobag::Error(file + ": there are no images in it");
  return frames;
}

Images read_images(const FramePaths& frame) {
  Images images{cv::imread(frame.rgb, cv::IMREAD_COLOR),
                cv::imread(frame.depth, cv::IMREAD_UNCHANGED), frame.stamp};
  if (images.rgb.empty()) throw topobag::Error(frame.rgb + ": the file is not an image");
  if (images.depth.empty()) throw topobag::Error(frame.depth + ": the file is not an image");
  return images;
}

/// Detections by the stamp of their image.
using Table = std::map<double, std::vector<topobag::RangedDetection>>;

void add_table(const std::string& set, Table& table) {
  for (program::FrameRow& frame : program::read_node_table(set).frames) {
    table[frame.timestamp] = std::move(frame.detections);
  }
}

/// The detector: a table's rows, or a network with the depth image.
Detect make_detect(const Arguments& arguments, const Calibration& calibration) {
  if (arguments.model.empty()) {
    auto table = std::make_shared<Table>();
    add_table(arguments.table, *table);
    if (!arguments.kidnap_table.empty()) add_table(arguments.kidnap_table, *table);
    return [table, calibration](const Images& images) {
      const auto found = table->lower_bound(images.stamp - 1e-5);
      if (found == table->end() || found->first > images.stamp + 1e-5) {
        return std::vector<topobag::RangedDetection>{};
      }
      return topobag::undistorted(found->second, calibration.matrix, calibration.distortion);
    };
  }
  auto network = std::make_shared<topobag::YoloDetector>(arguments.model,
                                                         topobag::ClassCatalog::coco80().ids());
  return [network, calibration](const Images& images) {
    return topobag::undistorted(
        topobag::range_detections((*network)(images.rgb),
                                  topobag::DepthImage(images.depth, calibration.depth_scale),
                                  calibration.camera),
        calibration.matrix, calibration.distortion);
  };
}

/// Lines of figures: how many, median, 95th percentile, largest.
void print_times(const std::string& name, std::vector<double> ms) {
  if (ms.empty()) return;
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double share) {
    return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
  };
  std::cout << "  " << std::left << std::setw(36) << name << std::right << std::setw(6) << ms.size()
            << std::fixed << std::setprecision(2) << std::setw(9) << at(0.5) << std::setw(9)
            << at(0.95) << std::setw(9) << ms.back() << '\n';
}

Eigen::Isometry3d world_camera(const cv::Mat& Tcw) { return topobag::host_pose(Tcw).inverse(); }

/// The truth of a sequence where it is at hand.
topobag::Trajectory read_truth(const std::string& sequence) {
  const std::string path = sequence + "/groundtruth.txt";
  return std::ifstream(path) ? topobag::read_tum(path) : topobag::Trajectory{};
}

std::optional<Eigen::Isometry3d> true_pose(const topobag::Trajectory& truth, double stamp) {
  return topobag::pose_at(truth, stamp, 0.1, topobag::RotationInterpolation::slerp);
}

class Run {
 public:
  explicit Run(const Arguments& arguments)
      : arguments_(arguments),
        calibration_(read_calibration(arguments.settings)),
        slam_(arguments.vocabulary, arguments.settings, ORB_SLAM2::System::RGBD, false) {
    if (!arguments.kidnap_sequence.empty()) kidnap_truth_ = read_truth(arguments.kidnap_sequence);
    if (arguments.stock) return;
    Settings settings;
    settings.camera = calibration_.camera;
    settings.database.fusing.window = arguments.window;
    settings.database.max_relocalizations = arguments.max_places;
    if (arguments.candidates > 0) {
      settings.database.recognition.max_candidates = arguments.candidates;
    }
    settings.lost_window = arguments.kidnap_window;
    if (arguments.mask) settings.mask = topobag::DynamicFeatureOptions{};
    semantic_ = std::make_unique<SemanticSlam>(
        settings, topobag::ClassCatalog::coco80(), make_detect(arguments, calibration_),
        [this](double stamp) { return true_pose(kidnap_truth_, stamp); });
    slam_.GetKeyFrameDatabase()->semantic.SetObserver(semantic_.get());
  }

  void track() {
    const auto frames = read_associations(arguments_.sequence, arguments_.associations);
    std::vector<double> ms;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const Images images = read_images(frames[i]);
      const program::Stopwatch watch;
      const cv::Mat Tcw = track_frame(images);
      ms.push_back(watch.milliseconds());
      if (slam_.GetTrackingState() == ORB_SLAM2::Tracking::OK) {
        tracked_.push_back({images.stamp, world_camera(Tcw)});
      }
      if (!arguments_.no_wait && i + 1 < frames.size()) {
        const double left = (frames[i + 1].stamp - images.stamp) - ms.back() / 1000.0;
        if (left > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
      }
    }
    if (semantic_) semantic_->wait_idle();
    std::cout << "\nframes: " << frames.size() << ", tracked: " << tracked_.size() << '\n';
    const auto truth = read_truth(arguments_.sequence);
    const auto pairs = topobag::associate(truth, tracked_);
    alignment_ = topobag::align(pairs);
    const auto ate =
        topobag::translation_statistics(topobag::pose_errors(topobag::aligned(pairs, alignment_)));
    if (ate) std::cout << "ATE rmse: " << ate->rmse << " m\n";
    if (semantic_) report_map(truth);
    std::cout << "stage                                  calls   median      95%      max, ms\n";
    print_times("tracking: whole frame", ms);
    if (semantic_) {
      for (const auto& [name, times] : semantic_->times()) print_times(name, times);
    }
  }

  /// Shows frames of another sequence alone to the lost tracker, blank frames between.
  void kidnap() {
    slam_.ActivateLocalizationMode();
    const auto frames =
        read_associations(arguments_.kidnap_sequence, arguments_.kidnap_associations);
    std::ofstream file(arguments_.out + "/relocalizations.csv");
    file << "stamp,relocalized,error_m,error_deg\n";
    std::size_t shown = 0, found = 0;
    std::vector<topobag::PoseError> errors;
    std::set<double> relocalized;
    std::vector<double> ms;
    for (std::size_t i = 0; i < frames.size(); i += arguments_.kidnap_every) {
      const Images images = read_images(frames[i]);
      const auto truth = true_pose(kidnap_truth_, images.stamp);
      if (!truth) continue;
      for (const double before : {0.02, 0.01}) {
        track_frame({cv::Mat::zeros(images.rgb.size(), images.rgb.type()),
                     cv::Mat::zeros(images.depth.size(), images.depth.type()),
                     images.stamp - before});
      }
      const program::Stopwatch watch;
      const cv::Mat Tcw = track_frame(images);
      ms.push_back(watch.milliseconds());
      ++shown;
      file << std::setprecision(17) << images.stamp << ',';
      if (slam_.GetTrackingState() != ORB_SLAM2::Tracking::OK) {
        file << "0,,\n";
        continue;
      }
      ++found;
      relocalized.insert(images.stamp);
      errors.push_back(topobag::pose_error(*truth, alignment_ * world_camera(Tcw)));
      file << "1," << errors.back().translation_m << ',' << errors.back().rotation_deg << '\n';
    }
    std::cout << "\nkidnapped: " << found << " of " << shown << " re-localized, "
              << wrong_of(errors) << " of them not within 0.3 m and 15 degrees\n";
    if (const auto m = topobag::translation_statistics(errors)) {
      const auto degrees = topobag::rotation_statistics(errors);
      std::cout << "error: median " << m->median << " m, " << degrees->median
                << " degrees; largest " << m->max << " m, " << degrees->max << " degrees\n";
    }
    print_times("kidnapped: whole frame", ms);
    if (!semantic_) return;
    report_places(relocalized);
    for (const auto& [name, times] : semantic_->times()) {
      if (name.rfind("tracking, lost", 0) == 0) print_times(name, times);
    }
  }

  void finish() {
    if (semantic_) semantic_->stop();
    slam_.Shutdown();
    slam_.SaveTrajectoryTUM(arguments_.out + "/CameraTrajectory.txt");
    slam_.SaveKeyFrameTrajectoryTUM(arguments_.out + "/KeyFrameTrajectory.txt");
  }

 private:
  cv::Mat track_frame(const Images& images) {
    if (semantic_ && slam_.MapChanged()) semantic_->poses_corrected();
    return slam_.TrackRGBD(images.rgb, images.depth, images.stamp);
  }

  /// What the objects alone make of the frames shown, and together with the host.
  void report_places(const std::set<double>& relocalized) {
    std::size_t verified = 0, by_place = 0, guesses = 0;
    std::set<double> found = relocalized;
    std::vector<topobag::PoseError> errors;
    for (const OfferedPlaces& offered : semantic_->offered_places()) {
      const auto truth = true_pose(kidnap_truth_, offered.stamp);
      by_place += offered.accepted >= 0 ? 1 : 0;
      guesses += offered.verified == 0 && offered.guesses > 0 ? 1 : 0;
      if (!truth || !offered.T_world_camera) continue;
      ++verified;
      found.insert(offered.stamp);
      errors.push_back(topobag::pose_error(*truth, alignment_ * *offered.T_world_camera));
    }
    std::cout << "by objects alone: " << verified << " verified, " << wrong_of(errors)
              << " of them not within 0.3 m and 15 degrees; by objects or the host: "
              << found.size() << "; frames with guesses alone: " << guesses
              << "; the host took the objects' pose in " << by_place << '\n';
    if (const auto m = topobag::translation_statistics(errors)) {
      const auto degrees = topobag::rotation_statistics(errors);
      std::cout << "error of the objects' poses: median " << m->median << " m, " << degrees->median
                << " degrees; largest " << m->max << " m, " << degrees->max << " degrees\n";
    }
  }

  static std::ptrdiff_t wrong_of(const std::vector<topobag::PoseError>& errors) {
    return std::count_if(errors.begin(), errors.end(), [](const auto& error) {
      return topobag::judge(error) != topobag::PoseVerdict::correct;
    });
  }

  void report_map(const topobag::Trajectory& truth) {
    const auto counts = semantic_->counts();
    std::cout << "key frames: " << counts.pushed << " made, " << counts.processed
              << " through the topology thread, " << counts.failed << " failed, " << counts.given_up
              << " given up, " << semantic_->size() << " in the bag\n";
    if (arguments_.mask) {
      const MaskedFeatures masked = semantic_->masked_features();
      std::cout << "features masked: " << masked.dropped << " of " << masked.seen << ", in "
                << masked.frames << " frames; " << masked.failed << " frames failed\n";
    }
    std::ofstream file(arguments_.out + "/loops.csv");
    file << "query_stamp,candidate_stamp,error_m,error_deg\n" << std::setprecision(17);
    const auto offered = semantic_->offered_loops();
    std::size_t wrong = 0;
    for (const OfferedLoop& loop : offered) {
      file << loop.query_stamp << ',' << loop.candidate_stamp << ',';
      const auto query = true_pose(truth, loop.query_stamp);
      const auto candidate = true_pose(truth, loop.candidate_stamp);
      if (query && candidate) {
        const auto error =
            topobag::pose_error(candidate->inverse() * *query, loop.T_candidate_query);
        wrong += topobag::judge(error) == topobag::PoseVerdict::wrong ? 1 : 0;
        file << error.translation_m << ',' << error.rotation_deg;
      } else {
        file << ',';
      }
      file << '\n';
    }
    std::cout << "loop candidates offered: " << offered.size() << ", wrong by the truth: " << wrong
              << "; exceptions: " << semantic_->failures().first << '\n';
  }

  const Arguments& arguments_;
  const Calibration calibration_;
  topobag::Trajectory kidnap_truth_;
  ORB_SLAM2::System slam_;
  std::unique_ptr<SemanticSlam> semantic_;
  topobag::Trajectory tracked_;
  topobag::Alignment alignment_;  ///< of the map's world with the truth's
};

}  // namespace
}  // namespace semantic

int main(int argc, char** argv) {
  semantic::Arguments arguments;
  CLI::App app("ORB-SLAM2 with a bag of topology graphs, on a TUM RGB-D sequence");
  app.add_option("VOC", arguments.vocabulary, "ORB vocabulary, text")->required();
  app.add_option("SETTINGS", arguments.settings, "ORB-SLAM2's settings, YAML")->required();
  app.add_option("SEQUENCE", arguments.sequence, "Folder of the sequence")->required();
  app.add_option("ASSOCIATIONS", arguments.associations, "Pairs of images")->required();
  auto* table = app.add_option("--detections", arguments.table, "Node table of the sequence");
  app.add_option("--model", arguments.model, "YOLOX network, ONNX")->excludes(table);
  app.add_flag("--mask", arguments.mask, "Track without the features on what moves")->needs(table);
  app.add_flag("--stock", arguments.stock, "Without the bag");
  app.add_flag("--no-wait", arguments.no_wait, "As fast as it goes, not at the camera's pace");
  app.add_option("--window", arguments.window, "Seconds of key frames in one graph");
  app.add_option("--places", arguments.max_places, "Places offered to a lost tracker");
  app.add_option("--candidates", arguments.candidates, "Key frames whose graphs are matched [3]");
  app.add_option("--out", arguments.out, "Folder for trajectories, loops, re-localizations");
  app.add_option("--kidnap", arguments.kidnap_sequence, "Then shows frames of this sequence alone");
  app.add_option("--kidnap-associations", arguments.kidnap_associations, "Its pairs of images");
  app.add_option("--kidnap-detections", arguments.kidnap_table, "Its node table");
  app.add_option("--kidnap-every", arguments.kidnap_every, "Every so many of its frames");
  app.add_option("--kidnap-window", arguments.kidnap_window,
                 "Seconds of shown frames in one graph, joined by the true relative poses");
  CLI11_PARSE(app, argc, argv);
  if (!arguments.stock && arguments.table.empty() && arguments.model.empty()) {
    std::cerr << "give --detections or --model, or --stock\n";
    return 2;
  }
  try {
    semantic::Run run(arguments);
    run.track();
    if (!arguments.kidnap_sequence.empty()) run.kidnap();
    run.finish();
  } catch (const topobag::Error& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
