// SPDX-License-Identifier: MIT
#include <sstream>

#include <topobag/bag/atomic_file.hpp>
#include <topobag/evaluation/lifelong_score.hpp>
#include <topobag/evaluation/relative_pose_error.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>

#include "csv_reader.hpp"
#include "fields.hpp"
#include "pose_files.hpp"
#include "rooms.hpp"
#include "trajectory_array.hpp"

namespace python {
namespace {

using namespace topobag;

TrajectoryArray trajectory_from(const ArrayLike& stamps, const ArrayLike& poses) {
  const auto times = numbers(stamps, "stamps", {any});
  const auto motions = poses_from(poses, "poses");
  require_rows(times, "stamps", static_cast<py::ssize_t>(motions.size()), "poses");
  const auto time = times.unchecked<1>();
  TrajectoryArray trajectory;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double stamp = time(static_cast<py::ssize_t>(i));
    require_seconds(stamp);
    if (i > 0 && !(stamp > trajectory.poses.back().stamp)) {
      throw InvalidValue("stamp " + std::to_string(i) + " is not after the one before", i);
    }
    trajectory.poses.push_back({stamp, motions[i]});
  }
  return trajectory;
}

std::vector<PosePair> pairs_between(const TrajectoryArray& truth, const TrajectoryArray& estimate,
                                    AlignmentModel model, double max_gap_s) {
  auto pairs = associate(truth.poses, estimate.poses, max_gap_s);
  const Alignment alignment = align(pairs, model);
  return aligned(std::move(pairs), alignment);
}

/// Translations, m, and rotations, degrees, of the errors.
py::tuple columns_of(const std::vector<PoseError>& errors) {
  std::vector<double> translations, rotations;
  for (const PoseError& error : errors) {
    translations.push_back(error.translation_m);
    rotations.push_back(error.rotation_deg);
  }
  return py::make_tuple(array_from(translations), array_from(rotations));
}

void write(const TrajectoryArray& trajectory, const std::string& path) {
  std::ostringstream text;
  write_tum(text, trajectory.poses);
  program::write_file(path, text.str());
}

void bind_trajectory(py::module_& module) {
  py::class_<TrajectoryArray>(module, "Trajectory",
                              "Where a body was, by strictly increasing time.")
      .def(py::init(&trajectory_from), py::arg("stamps"), py::arg("poses"),
           "`stamps` (n), s; `poses` (n x 4 x 4), body to world, m.")
      .def_static(
          "read",
          [](const std::string& path, const std::string& times) {
            return TrajectoryArray{program::read_trajectory(path, times)};
          },
          py::arg("path"), py::arg("times") = "",
          "Of a file in TUM, KITTI or OpenLORIS format, or a node table's SET.frames.csv; `times`: "
          "KITTI's times.txt.")
      .def("write_tum", &write, py::arg("path"), "Complete under its name, or not at all.")
      .def_property_readonly(
          "stamps",
          [](const TrajectoryArray& trajectory) {
            std::vector<double> stamps;
            for (const StampedPose& pose : trajectory.poses) stamps.push_back(pose.stamp);
            return array_from(stamps);
          },
          "Times, s (n).")
      .def_property_readonly(
          "poses",
          [](const TrajectoryArray& trajectory) {
            std::vector<Eigen::Isometry3d> poses;
            for (const StampedPose& pose : trajectory.poses) poses.push_back(pose.T_world_body);
            return matrices_of(poses);
          },
          "Body to world, m (n x 4 x 4).")
      .def(
          "at",
          [](const TrajectoryArray& trajectory, double stamp, double max_gap_s) {
            return pose_at(trajectory.poses, stamp, max_gap_s);
          },
          py::arg("stamp"), py::arg("max_gap_s") = 0.5, doc("pose_at"))
      .def("__len__", [](const TrajectoryArray& trajectory) { return trajectory.poses.size(); })
      .def("__repr__", [](const TrajectoryArray& trajectory) {
        return "<Trajectory of " + std::to_string(trajectory.poses.size()) + " poses>";
      });
}

void bind_errors_of_poses(py::module_& module) {
  py::enum_<AlignmentModel>(module, "AlignmentModel", doc("AlignmentModel"))
      .value("none", AlignmentModel::none, doc("AlignmentModel.none"))
      .value("se3", AlignmentModel::se3, doc("AlignmentModel.se3"))
      .value("sim3", AlignmentModel::sim3, doc("AlignmentModel.sim3"));
  py::enum_<RelativeStep::Unit>(module, "StepUnit", doc("RelativeStep.Unit"))
      .value("frames", RelativeStep::Unit::frames)
      .value("seconds", RelativeStep::Unit::seconds)
      .value("metres", RelativeStep::Unit::metres);
  Fields<RelativeStep>(module, "RelativeStep")
      .field("unit", &RelativeStep::unit)
      .field("length", &RelativeStep::length)
      .field("tolerance", &RelativeStep::tolerance)
      .field("all_starts", &RelativeStep::all_starts);
  py::class_<ErrorStatistics> statistics(module, "ErrorStatistics", doc("ErrorStatistics"));
  statistics.def_readonly("count", &ErrorStatistics::count, "How many.")
      .def_readonly("rmse", &ErrorStatistics::rmse, doc("ErrorStatistics.rmse"))
      .def_readonly("mean", &ErrorStatistics::mean, "Of the errors.")
      .def_readonly("median", &ErrorStatistics::median, "Of the errors.")
      .def_readonly("max", &ErrorStatistics::max, "Of the errors.");
  module.def(
      "error_statistics",
      [](const ArrayLike& errors) {
        const auto given = numbers(errors, "errors", {any});
        const auto entry = given.unchecked<1>();
        std::vector<double> values;
        for (py::ssize_t i = 0; i < given.size(); ++i) values.push_back(entry(i));
        return error_statistics(std::move(values));
      },
      py::arg("errors"), doc("error_statistics"));
  module.def(
      "trajectory_errors",
      [](const TrajectoryArray& truth, const TrajectoryArray& estimate, AlignmentModel model,
         double max_gap_s) {
        return columns_of(pose_errors(pairs_between(truth, estimate, model, max_gap_s)));
      },
      py::arg("groundtruth"), py::arg("estimate"),
      py::arg_v("alignment", AlignmentModel::se3, "AlignmentModel.se3"), py::arg("max_gap_s") = 0.5,
      "Absolute errors of the aligned estimate: translations, m (ATE), and rotations, degrees "
      "(AOE), a pair for each pose that the truth reaches.");
  module.def(
      "relative_errors",
      [](const TrajectoryArray& truth, const TrajectoryArray& estimate, const RelativeStep& step,
         double max_gap_s) {
        return columns_of(
            relative_pose_errors(associate(truth.poses, estimate.poses, max_gap_s), step));
      },
      py::arg("groundtruth"), py::arg("estimate"),
      py::arg_v("step", RelativeStep(), "RelativeStep()"), py::arg("max_gap_s") = 0.5,
      "Errors of the steps between poses (RPE): translations, m, and rotations, degrees.");
}

void bind_lifelong(py::module_& module) {
  Fields<LifelongRules>(module, "LifelongRules")
      .field("ate_threshold_m", &LifelongRules::ate_threshold_m)
      .field("aoe_threshold_deg", &LifelongRules::aoe_threshold_deg)
      .field("max_pose_interval_s", &LifelongRules::max_pose_interval_s)
      .field("tau_s", &LifelongRules::tau_s)
      .field("max_gap_s", &LifelongRules::max_gap_s)
      .field("alignment", &LifelongRules::alignment);
  py::class_<SequenceScore> score(module, "SequenceScore", doc("SequenceScore"));
  Attributes(score, "SequenceScore")
      .attribute("poses", &SequenceScore::poses)
      .attribute("ate_m", &SequenceScore::ate_m)
      .attribute("aoe_deg", &SequenceScore::aoe_deg)
      .attribute("correct_ate_m", &SequenceScore::correct_ate_m)
      .attribute("correct_aoe_deg", &SequenceScore::correct_aoe_deg)
      .attribute("cr", &SequenceScore::cr)
      .attribute("tracking_cr", &SequenceScore::tracking_cr)
      .attribute("relocalization_time_s", &SequenceScore::relocalization_time_s)
      .attribute("cs_r", &SequenceScore::cs_r);
  module.def(
      "score_lifelong",
      [](const std::map<int, TrajectoryArray>& truths,
         const std::map<int, TrajectoryArray>& estimates, const LifelongRules& rules) {
        const auto plain = [](const std::map<int, TrajectoryArray>& arrays) {
          std::map<int, Trajectory> trajectories;
          for (const auto& [number, array] : arrays) trajectories[number] = array.poses;
          return trajectories;
        };
        return score_lifelong(plain(truths), plain(estimates), rules);
      },
      py::arg("groundtruth"), py::arg("estimates"),
      py::arg_v("rules", LifelongRules(), "LifelongRules()"), doc("score_lifelong"));
}

}  // namespace

void bind_trajectories(py::module_& module) {
  bind_trajectory(module);
  bind_errors_of_poses(module);
  bind_lifelong(module);
}

}  // namespace python
