// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace python {

// Each puts one room of the library into the module, after those that it builds on, in this order.
void bind_errors(pybind11::module_& module);
void bind_types(pybind11::module_& module);
void bind_nodes(pybind11::module_& module);
void bind_edges(pybind11::module_& module);
void bind_sensing(pybind11::module_& module);
void bind_graph(pybind11::module_& module);
void bind_similarity(pybind11::module_& module);
void bind_appearance(pybind11::module_& module);
void bind_match_options(pybind11::module_& module);
void bind_local_graph(pybind11::module_& module);
void bind_matching(pybind11::module_& module);
void bind_images(pybind11::module_& module);
void bind_queries(pybind11::module_& module);
void bind_described_catalog(pybind11::module_& module);
void bind_bags(pybind11::module_& module);
void bind_calibration(pybind11::module_& module);
void bind_recognition(pybind11::module_& module);
void bind_explanation(pybind11::module_& module);
void bind_relocalizer(pybind11::module_& module);
void bind_learning(pybind11::module_& module);
void bind_map_alignment(pybind11::module_& module);
void bind_trajectories(pybind11::module_& module);
void bind_evaluation(pybind11::module_& module);
void bind_tables(pybind11::module_& module);

}  // namespace python
