// SPDX-License-Identifier: MIT
#include <topobag/matching/learn_appearance.hpp>
#include <topobag/recognition/learn_map_appearance.hpp>

#include "fields.hpp"
#include "recognisers.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using namespace topobag;

/// The interpreter goes on meanwhile, so that others may count: what is learnt is added at the end.
void learnt_of_map(AppearanceCounts& counts, const Relocalizer& relocalizer,
                   const std::optional<std::vector<KeyframeId>>& keyframes,
                   const MapAppearanceOptions& options) {
  AppearanceCounts learnt(counts.kind());
  {
    const py::gil_scoped_release unlocked;
    learn_map_appearance(learnt, relocalizer,
                         keyframes ? *keyframes : ids_of(*relocalizer.map().view()), options);
  }
  counts += learnt;
}

void learnt_elsewhere(AppearanceCounts& counts, const Relocalizer& relocalizer,
                      const Graph& elsewhere) {
  AppearanceCounts learnt(counts.kind());
  {
    const py::gil_scoped_release unlocked;
    learn_elsewhere_appearance(learnt, relocalizer, elsewhere);
  }
  counts += learnt;
}

}  // namespace

void bind_learning(py::module_& module) {
  module.def("learn_appearance", &learn_appearance<double>, py::arg("counts"), py::arg("candidate"),
             py::arg("query"), py::arg("pose"),
             py::arg_v("options", CoincidenceOptions(), "CoincidenceOptions()"),
             doc("learn_appearance"));
  module.def("learn_other_appearance", &learn_other_appearance<double>, py::arg("counts"),
             py::arg("here"), py::arg("elsewhere"), doc("learn_other_appearance"));
  Fields<MapAppearanceOptions>(module, "MapAppearanceOptions")
      .field("right", &MapAppearanceOptions::right)
      .field("min_separation", &MapAppearanceOptions::min_separation)
      .field("apart", &MapAppearanceOptions::apart)
      .field("on_query", &MapAppearanceOptions::on_query);
  module.def("learn_map_appearance", &learnt_of_map, py::arg("counts"), py::arg("relocalizer"),
             py::arg("keyframes") = py::none(),
             py::arg_v("options", MapAppearanceOptions(), "MapAppearanceOptions()"),
             doc("learn_map_appearance"));
  module.def("learn_elsewhere_appearance", &learnt_elsewhere, py::arg("counts"),
             py::arg("relocalizer"), py::arg("elsewhere"), doc("learn_elsewhere_appearance"));
}

}  // namespace python
