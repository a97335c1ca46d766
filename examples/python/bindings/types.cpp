// SPDX-License-Identifier: MIT
#include <topobag/types/catalog_fingerprint.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/dynamics.hpp>

#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using topobag::ClassCatalog;
using topobag::ClassId;
using topobag::Dynamics;

void bind_catalog(py::module_& module) {
  py::class_<ClassCatalog>(module, "ClassCatalog", doc("ClassCatalog"))
      .def(py::init<>())
      .def_static("coco80", &ClassCatalog::coco80, doc("ClassCatalog.coco80"))
      .def_static("paper", &ClassCatalog::paper, doc("ClassCatalog.paper"))
      .def("add", &ClassCatalog::add, py::arg("id"), py::arg("name"),
           py::arg_v("dynamics", Dynamics::low, "Dynamics.low"), doc("ClassCatalog.add"))
      .def("add_alias", &ClassCatalog::add_alias, py::arg("alias"), py::arg("name"),
           doc("ClassCatalog.add_alias"))
      .def("find", &ClassCatalog::find, py::arg("name"), doc("ClassCatalog.find"))
      .def("name", &ClassCatalog::name, py::arg("id"), doc("ClassCatalog.name"))
      .def("dynamics", &ClassCatalog::dynamics, py::arg("id"), doc("ClassCatalog.dynamics"))
      .def("set_dynamics", &ClassCatalog::set_dynamics, py::arg("id"), py::arg("dynamics"),
           doc("ClassCatalog.set_dynamics"))
      .def("fingerprint", &topobag::fingerprint, doc("fingerprint"))
      .def("__getitem__", &ClassCatalog::at, py::arg("name"), doc("ClassCatalog.at"))
      .def("__contains__", &ClassCatalog::contains, py::arg("id"))
      .def(
          "__contains__",
          [](const ClassCatalog& catalog, const std::string& name) {
            return catalog.find(name).has_value();
          },
          py::arg("name"))
      .def("__len__", &ClassCatalog::size)
      .def("__iter__",
           [](const ClassCatalog& catalog) { return py::iter(py::cast(catalog.ids())); })
      .def("__repr__", [](const ClassCatalog& catalog) {
        return "<ClassCatalog of " + std::to_string(catalog.size()) + " classes>";
      });
}

}  // namespace

void bind_types(py::module_& module) {
  py::enum_<Dynamics>(module, "Dynamics", doc("Dynamics"))
      .value("low", Dynamics::low)
      .value("medium", Dynamics::medium)
      .value("high", Dynamics::high);
  bind_catalog(module);
}

}  // namespace python
