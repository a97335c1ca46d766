// SPDX-License-Identifier: MIT
#include <string>

#include <topobag/version.hpp>

#include "rooms.hpp"

PYBIND11_MODULE(_topobag, module) {
  module.doc() = "Semantic place recognition: the compiled part of topobag.";
  module.attr("__version__") = std::to_string(TOPOBAG_VERSION_MAJOR) + '.' +
                               std::to_string(TOPOBAG_VERSION_MINOR) + '.' +
                               std::to_string(TOPOBAG_VERSION_PATCH);
  python::bind_errors(module);
  python::bind_types(module);
  python::bind_nodes(module);
  python::bind_edges(module);
  python::bind_sensing(module);
  python::bind_graph(module);
  python::bind_similarity(module);
  python::bind_appearance(module);
  python::bind_match_options(module);
  python::bind_local_graph(module);
  python::bind_matching(module);
  python::bind_images(module);
  python::bind_queries(module);
  python::bind_described_catalog(module);
  python::bind_bags(module);
  python::bind_calibration(module);
  python::bind_recognition(module);
  python::bind_explanation(module);
  python::bind_relocalizer(module);
  python::bind_learning(module);
  python::bind_map_alignment(module);
  python::bind_trajectories(module);
  python::bind_evaluation(module);
  python::bind_tables(module);
}
