// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <variant>

#include <topobag/sensing/lift_detections.hpp>

#include "depth_argument.hpp"
#include "detections.hpp"
#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using topobag::CenterDepth;
using topobag::LiftOptions;
using topobag::RobustBoxDepth;
using Camera = topobag::PinholeCamera<>;
using Lifted = topobag::LiftedNodes<double>;

Lifted lift(const ArrayLike& boxes, const ArrayLike& labels, const std::optional<ArrayLike>& scores,
            const ArrayLike& depth, const Camera& camera, const topobag::ClassCatalog& catalog,
            const LiftOptions& options, const std::optional<double>& depth_scale,
            const std::variant<RobustBoxDepth, CenterDepth>& sampling,
            const std::optional<ArrayLike>& appearances, const py::object& appearance_kind,
            const std::optional<ArrayLike>& weighted_labels,
            const std::optional<ArrayLike>& label_weights) {
  const py::array given = py::array::ensure(depth);
  const bool of_detections = given && given.ndim() == 1;
  const auto detections = detections_from(
      boxes, labels, scores, of_detections ? std::optional<ArrayLike>(depth) : std::nullopt,
      appearances, appearance_kind, weighted_labels, label_weights);
  if (of_detections) return topobag::lift_detections(detections, camera, catalog, options);
  PyErr_Clear();
  return with_depth_view(depth, depth_scale, [&](const auto& view) {
    return std::visit(
        [&](const auto& sample) {
          return topobag::lift_detections(detections, view, camera, catalog, options, sample);
        },
        sampling);
  });
}

py::array_t<double> back_projected(const Camera& camera, const ArrayLike& pixels,
                                   const ArrayLike& z) {
  const auto given = numbers(pixels, "pixels", {any, 2});
  const auto depths = numbers(z, "z", {any});
  require_rows(depths, "z", given.shape(0), "pixels");
  const auto pixel = given.unchecked<2>();
  const auto depth = depths.unchecked<1>();
  py::array_t<double> points({given.shape(0), py::ssize_t{3}});
  auto out = points.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    const Eigen::Vector3d point = camera.back_project({pixel(i, 0), pixel(i, 1)}, depth(i));
    for (int k = 0; k < 3; ++k) out(i, k) = point(k);
  }
  return points;
}

py::array_t<double> projected(const Camera& camera, const ArrayLike& points) {
  const auto given = numbers(points, "points", {any, 3});
  const auto point = given.unchecked<2>();
  py::array_t<double> pixels({given.shape(0), py::ssize_t{2}});
  auto out = pixels.mutable_unchecked<2>();
  const Eigen::Vector2d nowhere = Eigen::Vector2d::Constant(std::nan(""));
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    const Eigen::Vector2d pixel =
        camera.project({point(i, 0), point(i, 1), point(i, 2)}).value_or(nowhere);
    for (int k = 0; k < 2; ++k) out(i, k) = pixel(k);
  }
  return pixels;
}

void bind_sensor(py::module_& module) {
  using topobag::SensorProfile;
  Fields<SensorProfile>(module, "SensorProfile")
      .field("min_depth", &SensorProfile::min_depth)
      .field("max_depth", &SensorProfile::max_depth)
      .field("detection_range", &SensorProfile::detection_range)
      .field("sure_range", &SensorProfile::sure_range)
      .field("gate_deviations", &SensorProfile::gate_deviations)
      .field("gate", &SensorProfile::gate)
      .field("least_tolerance", &SensorProfile::least_tolerance)
      .field("min_spread", &SensorProfile::min_spread)
      .field("pose_resolution", &SensorProfile::pose_resolution)
      .field("place_resolution", &SensorProfile::place_resolution)
      .field("place_radius", &SensorProfile::place_radius)
      .field("place_margin", &SensorProfile::place_margin)
      .field("noise", &SensorProfile::noise)
      .def_static("hand_held_rgbd", &SensorProfile::hand_held_rgbd,
                  doc("SensorProfile.hand_held_rgbd"))
      .def_static("stereo_robot", &SensorProfile::stereo_robot, doc("SensorProfile.stereo_robot"))
      .def_static("warehouse", &SensorProfile::warehouse, doc("SensorProfile.warehouse"))
      .def_static("lidar", &SensorProfile::lidar, doc("SensorProfile.lidar"));
  module.def("lift_options", &topobag::lift_options, py::arg("sensor"),
             "The defaults of LiftOptions for a sensor.");
}

void bind_lifting(py::module_& module) {
  Fields<topobag::SameObject>(module, "SameObject")
      .field("max_distance", &topobag::SameObject::max_distance)
      .field("max_size_ratio", &topobag::SameObject::max_size_ratio);
  using topobag::NodeNoise;
  Fields<NodeNoise>(module, "NodeNoise")
      .field("depth_floor", &NodeNoise::depth_floor)
      .field("depth_quadratic", &NodeNoise::depth_quadratic)
      .field("depth_of_object", &NodeNoise::depth_of_object)
      .field("box_jitter", &NodeNoise::box_jitter)
      .field("box_floor", &NodeNoise::box_floor)
      .field("truncation", &NodeNoise::truncation);
  using topobag::Dynamics;
  Fields<LiftOptions>(module, "LiftOptions")
      .field(
          "keep",
          [](const LiftOptions& options) {
            std::vector<Dynamics> kept;
            for (const Dynamics level : {Dynamics::low, Dynamics::medium, Dynamics::high}) {
              if (options.keep.contains(level)) kept.push_back(level);
            }
            return kept;
          },
          [](LiftOptions& options, const std::vector<Dynamics>& levels) {
            const auto pick = [&](Dynamics level) {
              const bool given = std::find(levels.begin(), levels.end(), level) != levels.end();
              return given ? level : levels.front();
            };
            options.keep = levels.empty()
                               ? topobag::DynamicsSet{}
                               : topobag::DynamicsSet{pick(Dynamics::low), pick(Dynamics::medium),
                                                      pick(Dynamics::high)};
          })
      .field("min_confidence", &LiftOptions::min_confidence)
      .field("min_depth", &LiftOptions::min_depth)
      .field("max_depth", &LiftOptions::max_depth)
      .field("max_image_share", &LiftOptions::max_image_share)
      .field("duplicate", &LiftOptions::duplicate)
      .field("noise", &LiftOptions::noise);
  using topobag::DroppedDetections;
  Fields<DroppedDetections>(module, "DroppedDetections")
      .field("invalid", &DroppedDetections::invalid)
      .field("low_confidence", &DroppedDetections::low_confidence)
      .field("dynamic", &DroppedDetections::dynamic)
      .field("too_large", &DroppedDetections::too_large)
      .field("no_depth", &DroppedDetections::no_depth)
      .field("out_of_range", &DroppedDetections::out_of_range)
      .field("duplicate", &DroppedDetections::duplicate)
      .def("total", &DroppedDetections::total, doc("DroppedDetections.total"));
  py::class_<Lifted>(module, "LiftedNodes", doc("LiftedNodes"))
      .def_property_readonly(
          "nodes", [](const Lifted& lifted) { return NodeArray{lifted.nodes}; },
          doc("LiftedNodes.nodes"))
      .def_property_readonly(
          "sources", [](const Lifted& lifted) { return array_from(lifted.sources); },
          doc("LiftedNodes.sources"))
      .def_readonly("dropped", &Lifted::dropped, doc("LiftedNodes.dropped"))
      .def("__len__", [](const Lifted& lifted) { return lifted.nodes.size(); });
}

}  // namespace

void bind_sensing(py::module_& module) {
  Fields<Camera>(module, "PinholeCamera")
      .field("fx", &Camera::fx)
      .field("fy", &Camera::fy)
      .field("cx", &Camera::cx)
      .field("cy", &Camera::cy)
      .field("width", &Camera::width)
      .field("height", &Camera::height)
      .def("validate", &Camera::validate, doc("PinholeCamera.validate"))
      .def("back_project", &back_projected, py::arg("pixels"), py::arg("z"),
           "Eq. 5 for pixels (n x 2) and depths (n), m: points in the camera's frame (n x 3), m.")
      .def("project", &projected, py::arg("points"),
           "The pixels (n x 2) of points (n x 3) in the camera's frame, m; NaN of those at or "
           "behind the camera.");
  Fields<RobustBoxDepth>(module, "RobustBoxDepth")
      .field("central_share", &RobustBoxDepth::central_share)
      .field("grid", &RobustBoxDepth::grid)
      .field("min_valid_share", &RobustBoxDepth::min_valid_share)
      .field("cluster_width", &RobustBoxDepth::cluster_width)
      .field("min_cluster_share", &RobustBoxDepth::min_cluster_share);
  Fields<CenterDepth>(module, "CenterDepth");
  bind_lifting(module);
  bind_sensor(module);
  module.def("lift_detections", &lift, py::arg("boxes"), py::arg("labels"), py::arg("scores"),
             py::arg("depth"), py::arg("camera"),
             py::arg_v("catalog", topobag::ClassCatalog::coco80(), "ClassCatalog.coco80()"),
             py::arg_v("options", LiftOptions(), "LiftOptions()"), py::kw_only(),
             py::arg("depth_scale") = py::none(),
             py::arg_v("sampling", std::variant<RobustBoxDepth, CenterDepth>(), "RobustBoxDepth()"),
             py::arg("appearances") = py::none(), py::arg("appearance_kind") = "own",
             py::arg("weighted_labels") = py::none(), py::arg("label_weights") = py::none(),
             "Turns a detector's boxes and their depth into semantic nodes: eq. 1, 2 and 5.\n\n"
             "`boxes` (n x 4) are x1, y1, x2, y2, px; `labels` (n) as the catalog numbers them; "
             "`scores` (n) in [0, 1], or None. `depth` is an image (height x width) of uint16, "
             "float32 or float64, which is read in place unless it is flipped or transposed, with "
             "`depth_scale` units a metre (to be said of uint16, else 1); or the depth of each box "
             "(n), m, 0 = unknown. `weighted_labels` and `label_weights` (n x k) are as in Nodes. "
             "Raises UnknownClass with the index of the detection, "
             "InvalidValue for a bad array or camera.");
}

}  // namespace python
