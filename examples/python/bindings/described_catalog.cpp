// SPDX-License-Identifier: MIT
#include "described_catalog.hpp"

#include <string>

#include <topobag/adaptors/sqlite_catalog.hpp>
#include <topobag/bag/snapshot_file.hpp>

#include "fields.hpp"
#include "rooms.hpp"

namespace python {

using topobag::DescribedCatalog;

DescribedCatalog described(const ClassesArgument& classes) {
  return std::visit([](const auto& said) { return DescribedCatalog(said); }, classes);
}

std::optional<DescribedCatalog> described(const std::optional<ClassesArgument>& classes) {
  return classes ? std::make_optional(described(*classes)) : std::nullopt;
}

program::ObjectClasses object_classes(const ClassesArgument& classes) {
  const DescribedCatalog all = described(classes);
  program::ObjectClasses known{all.catalog, topobag::lookalike_classes(all.catalog)};
  if (all.lookalikes) known.lookalikes = *all.lookalikes;
  if (all.sizes) known.sizes = *all.sizes;
  return known;
}

void bind_described_catalog(py::module_& module) {
  Fields<DescribedCatalog>(module, "DescribedCatalog")
      .field("catalog", &DescribedCatalog::catalog)
      .field("lookalikes", &DescribedCatalog::lookalikes)
      .field("sizes", &DescribedCatalog::sizes)
      .field("source", &DescribedCatalog::source);
  module.def("difference", &topobag::difference, py::arg("map"), py::arg("other"),
             doc("difference"));
  module.def(
      "saved_catalog", [](const std::string& path) { return topobag::saved_catalog(path); },
      py::arg("path"), py::call_guard<py::gil_scoped_release>(), doc("saved_catalog"));
  module.def("sqlite_catalog", &topobag::sqlite_catalog, py::arg("path"),
             py::call_guard<py::gil_scoped_release>(), doc("sqlite_catalog"));
}

}  // namespace python
