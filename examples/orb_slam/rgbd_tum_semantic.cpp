// SPDX-License-Identifier: MIT
// ORB-SLAM2 or 3 with a bag of topology graphs beside it, on a sequence in the form of the TUM
// RGB-D benchmark.
#include <chrono>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include <host.hpp>

#include <topobag/evaluation/alignment.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/evaluation/trajectory_error.hpp>

#include <stopwatch.hpp>

#include "inputs.hpp"
#include "options.hpp"
#include "reports.hpp"
#include "semantic_slam.hpp"
#include "tum_sequence.hpp"

namespace semantic {
namespace {

template <typename Pose>
Eigen::Isometry3d world_camera(const Pose& Tcw) {
  return topobag::host_pose(Tcw).inverse();
}

host::System::eSensor sensor_of_host(Sensor sensor) {
  switch (sensor) {
    case Sensor::stereo:
      return host::System::STEREO;
    case Sensor::mono:
      return host::System::MONOCULAR;
    default:
      return host::System::RGBD;
  }
}

class Run {
 public:
  explicit Run(const Arguments& arguments)
      : arguments_(arguments),
        inputs_(arguments),
        slam_(arguments.vocabulary, arguments.settings, sensor_of_host(inputs_.sensor), false) {
    if (arguments.stock) return;
    semantic_ = std::make_unique<SemanticSlam>(
        inputs_.settings(arguments), topobag::ClassCatalog::coco80(), inputs_.detect,
        [this](double stamp) { return true_pose(inputs_.kidnap_truth, stamp); });
    host::hold_poses(*semantic_, slam_);
    if (!arguments.load_sightings.empty()) {
      std::cout << semantic_->load(arguments.load_sightings) << " sightings restored\n";
    }
    slam_.GetKeyFrameDatabase()->semantic.SetObserver(semantic_.get());
  }

  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  ~Run() { stop(); }

  void track() {
    std::vector<double> ms;
    const std::vector<FramePaths>& frames = inputs_.frames;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const Images images = read_images(frames[i], inputs_.sensor);
      const program::Stopwatch watch;
      const auto Tcw = track_frame(images);
      ms.push_back(watch.milliseconds());
      if (host::is_tracking(slam_)) {
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
    const bool is_mono = inputs_.sensor == Sensor::mono;
    alignment_ = topobag::align(
        pairs, is_mono ? topobag::AlignmentModel::sim3 : topobag::AlignmentModel::se3);
    if (is_mono) std::cout << "metres in a unit of the host: " << alignment_.scale << '\n';
    const auto ate =
        topobag::translation_statistics(topobag::pose_errors(topobag::aligned(pairs, alignment_)));
    if (ate) std::cout << "ATE rmse: " << ate->rmse << " m\n";
    if (semantic_) {
      report_map(*semantic_, arguments_.mask);
      report_offers("loop", semantic_->offered_loops(), truth, alignment_.scale,
                    arguments_.out + "/loops.csv");
      if constexpr (topobag::has_maps_v<host::KeyFrame>) {
        report_offers("merge", semantic_->offered_merges(), truth, alignment_.scale,
                      arguments_.out + "/merges.csv");
        report_merges(semantic_->merge_queries());
        std::cout << "merges begun from object poses: " << semantic_->merges_begun() << '\n';
      }
    }
    std::cout << "stage                                  calls   median      95%      max, ms\n";
    print_times("tracking: whole frame", ms);
    if (semantic_) {
      for (const auto& [name, times] : semantic_->times()) print_times(name, times);
    }
  }

  /// Shows frames of another sequence alone to the lost tracker, blank frames between.
  void kidnap() {
    host::stop_mapping(slam_);
    // What a tracker was offered that lost its way before is no answer to these frames.
    const std::size_t offered_before = semantic_ ? semantic_->offered_places().size() : 0;
    std::ofstream file(arguments_.out + "/relocalizations.csv");
    file << "stamp,relocalized,error_m,error_deg\n";
    std::size_t shown = 0, found = 0;
    std::vector<topobag::PoseError> errors;
    std::set<double> relocalized;
    std::vector<double> ms;
    for (std::size_t i = 0; i < inputs_.kidnap_frames.size(); i += arguments_.kidnap_every) {
      Images images = read_images(inputs_.kidnap_frames[i], inputs_.sensor);
      if (arguments_.kidnap_without_depth) images.depth.setTo(0.0);
      const auto truth = true_pose(inputs_.kidnap_truth, images.stamp);
      if (!truth) continue;
      for (const double before : {0.02, 0.01}) {
        track_frame({cv::Mat::zeros(images.rgb.size(), images.rgb.type()),
                     cv::Mat::zeros(images.depth.size(), images.depth.type()),
                     images.stamp - before});
      }
      const program::Stopwatch watch;
      const auto Tcw = track_frame(images);
      ms.push_back(watch.milliseconds());
      ++shown;
      file << std::setprecision(17) << images.stamp << ',';
      if (!host::is_tracking(slam_)) {
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
    print_errors("error", errors);
    print_times("kidnapped: whole frame", ms);
    if (!semantic_) return;
    auto offered = semantic_->offered_places();
    offered.erase(offered.begin(), offered.begin() + static_cast<std::ptrdiff_t>(offered_before));
    report_places(offered, relocalized, inputs_.kidnap_truth, alignment_);
    for (const auto& [name, times] : semantic_->times()) {
      if (name.rfind("tracking, lost", 0) == 0) print_times(name, times);
    }
  }

  void finish() {
    stop();
    if (semantic_ && !arguments_.save_sightings.empty()) semantic_->save(arguments_.save_sightings);
    // Of one camera the host has those of its key frames alone.
    if (inputs_.sensor != Sensor::mono) {
      slam_.SaveTrajectoryTUM(arguments_.out + "/CameraTrajectory.txt");
    }
    slam_.SaveKeyFrameTrajectoryTUM(arguments_.out + "/KeyFrameTrajectory.txt");
  }

 private:
  /// Afterwards no thread calls the observer: ORB-SLAM3's threads go on for a while after its
  /// `Shutdown`, which saves its map and is therefore called once.
  void stop() {
    if (std::exchange(stopped_, true)) return;
    if (semantic_) semantic_->stop();
    slam_.Shutdown();
    slam_.GetKeyFrameDatabase()->semantic.SetObserver(nullptr);
  }

  host::Pose track_frame(const Images& images) {
    switch (inputs_.sensor) {
      case Sensor::stereo:
        return slam_.TrackStereo(images.rgb, images.depth, images.stamp);
      case Sensor::mono:
        return slam_.TrackMonocular(images.rgb, images.stamp);
      default:
        return slam_.TrackRGBD(images.rgb, images.depth, images.stamp);
    }
  }

  const Arguments& arguments_;
  const Inputs inputs_;
  host::System slam_;
  std::unique_ptr<SemanticSlam> semantic_;
  topobag::Trajectory tracked_;
  topobag::Alignment alignment_;  ///< of the map's world with the truth's
  bool stopped_ = false;
};

}  // namespace
}  // namespace semantic

int main(int argc, char** argv) {
  semantic::Arguments arguments;
  CLI::App app(std::string(host::name) + " with a bag of topology graphs, on a TUM RGB-D sequence");
  add_options(app, arguments);
  CLI11_PARSE(app, argc, argv);
  if (!arguments.stock && arguments.table.empty() && arguments.model.empty()) {
    std::cerr << "give --detections or --model, or --stock\n";
    return 2;
  }
  try {
    std::filesystem::create_directories(arguments.out);
    semantic::Run run(arguments);
    run.track();
    if (!arguments.kidnap_sequence.empty()) run.kidnap();
    run.finish();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
