// SPDX-License-Identifier: MIT
#include <variant>

#include <topobag/recognition/calibrate.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "bags.hpp"
#include "fields.hpp"
#include "recognisers.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using topobag::LoopOptions;
using topobag::Recognition;
using topobag::RecognitionOptions;
using Unlocked = py::call_guard<py::gil_scoped_release>;
using Options = std::optional<RecognitionOptions>;

/// What Python gave, or a bag of the default kind.
SharedMap shared(const std::shared_ptr<Map>& map, py::handle module) {
  if (map) return SharedMap(map);
  return SharedMap(module.attr("BagOfTopologyGraphs")().cast<std::shared_ptr<Map>>());
}

using AnyBag = std::variant<std::shared_ptr<MemoryMap>, std::shared_ptr<Map>>;

/// A bag as the kind of which Python knows it.
AnyBag known_kind(const SharedMap& bag) {
  if (auto memory = std::dynamic_pointer_cast<MemoryMap>(bag.map())) return memory;
  return bag.map();
}

Recognition localized(const Relocalizer& relocalizer, const Graph& query, const Options& options) {
  return options ? relocalizer.localize(query, *options) : relocalizer.localize(query);
}

Recognition detected(const LoopDetector& loops, double stamp, const Graph& graph,
                     std::uint32_t session, const Options& options) {
  return options ? loops.detect(stamp, graph, session, *options)
                 : loops.detect(stamp, graph, session);
}

Recognition detected_and_added(LoopDetector& loops, KeyframeId id, double stamp, const Graph& graph,
                               const std::optional<Eigen::Isometry3d>& T_world_camera,
                               std::uint32_t session, std::string label,
                               topobag::ImageDescriptor image) {
  return loops.detect_and_add(
      id, stamp, graph,
      {std::nullopt, session, T_world_camera, std::move(label), std::move(image)});
}

topobag::Explanation explained(const Recognition& recognition, const Map& bag, const Graph& query,
                               const topobag::ClassCatalog& catalog,
                               const RecognitionOptions& options) {
  return topobag::explain(recognition, *bag.view(), query, catalog, options);
}

topobag::Calibration calibrated(const Relocalizer& relocalizer,
                                const std::optional<std::vector<KeyframeId>>& keyframes,
                                const topobag::OtherPlaces& other_places,
                                const topobag::CalibrateOptions& options) {
  return topobag::calibrate(relocalizer, keyframes ? *keyframes : ids_of(*relocalizer.map().view()),
                            other_places, options);
}

std::optional<Eigen::Isometry3d> world_pose(const Relocalizer& relocalizer,
                                            const Recognition& recognition) {
  const auto pose = relocalizer.T_world_query(recognition);
  if (!pose) return std::nullopt;
  return pose->T;
}

}  // namespace

void bind_relocalizer(py::module_& module) {
  const py::handle types = module;
  py::class_<Relocalizer>(module, "Relocalizer", doc("Relocalizer"))
      .def(py::init([types](const RecognitionOptions& options, const std::shared_ptr<Map>& map) {
             return Relocalizer(options, shared(map, types));
           }),
           py::arg_v("options", RecognitionOptions(), "RecognitionOptions()"),
           py::arg("map") = py::none(), "`map` is referred to: what is added to it later counts.")
      .def_property_readonly(
          "map", [](const Relocalizer& relocalizer) { return known_kind(relocalizer.map()); },
          doc("Relocalizer.map"))
      .def_property("options", &Relocalizer::options, &Relocalizer::set_options,
                    py::return_value_policy::copy, doc("Relocalizer.options"))
      .def("localize", &localized, py::arg("query"), py::arg("options") = py::none(), Unlocked(),
           doc("Relocalizer.localize"))
      .def("T_world_query", &world_pose, py::arg("recognition"), Unlocked(),
           doc("Relocalizer.T_world_query"));
  py::class_<LoopDetector>(module, "LoopDetector", doc("LoopDetector"))
      .def(py::init([types](const LoopOptions& options, const std::shared_ptr<Map>& bag) {
             return LoopDetector(options, shared(bag, types));
           }),
           py::arg_v("options", LoopOptions(), "LoopOptions()"), py::arg("bag") = py::none(),
           "`bag` is referred to: what is added to it later counts.")
      .def_property_readonly(
          "bag", [](const LoopDetector& loops) { return known_kind(loops.bag()); },
          doc("LoopDetector.bag"))
      .def_property("options", &LoopDetector::options, &LoopDetector::set_options,
                    py::return_value_policy::copy, doc("LoopDetector.options"))
      .def("detect", &detected, py::arg("stamp"), py::arg("graph"), py::arg("session") = 0,
           py::arg("options") = py::none(), Unlocked(), doc("LoopDetector.detect"))
      .def("detect_and_add", &detected_and_added, py::arg("id"), py::arg("stamp"), py::arg("graph"),
           py::kw_only(), py::arg("T_world_camera") = py::none(), py::arg("session") = 0,
           py::arg("label") = "",
           py::arg_v("image", topobag::ImageDescriptor(), "ImageDescriptor()"), Unlocked(),
           doc("LoopDetector.detect_and_add"));
  module.def("explain", &explained, py::arg("recognition"), py::arg("bag"), py::arg("query"),
             py::arg_v("catalog", topobag::ClassCatalog::coco80(), "ClassCatalog.coco80()"),
             py::arg_v("options", RecognitionOptions(), "RecognitionOptions()"), Unlocked(),
             doc("explain"));
  module.def("calibrate", &calibrated, py::arg("relocalizer"), py::arg("keyframes") = py::none(),
             py::arg("other_places") = py::none(),
             py::arg_v("options", topobag::CalibrateOptions(), "CalibrateOptions()"), Unlocked(),
             doc("calibrate"));
}

}  // namespace python
