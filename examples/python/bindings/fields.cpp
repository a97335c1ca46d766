// SPDX-License-Identifier: MIT
#include "fields.hpp"

namespace python {
namespace {

py::tuple names_of(const py::object& self) { return py::type::of(self).attr("__fields__"); }

std::string type_name(const py::object& self) {
  return py::type::of(self).attr("__name__").cast<std::string>();
}

}  // namespace

void set_fields(const py::object& self, const py::args& args, const py::kwargs& kwargs) {
  const py::tuple names = names_of(self);
  const std::string all = py::str(", ").attr("join")(names).cast<std::string>();
  if (args.size() > names.size()) {
    throw py::type_error(type_name(self) + " takes " + std::to_string(names.size()) +
                         " arguments: " + all);
  }
  for (std::size_t i = 0; i < args.size(); ++i) py::setattr(self, names[i], args[i]);
  for (const auto& [name, value] : kwargs) {
    if (!names.contains(name)) {
      throw py::type_error(type_name(self) + " has no " + py::str(name).cast<std::string>() +
                           "; it has " + all);
    }
    py::setattr(self, name, value);
  }
}

py::dict fields_of(const py::object& self) {
  py::dict fields;
  for (const py::handle name : names_of(self)) fields[name] = py::getattr(self, name);
  return fields;
}

std::string fields_text(const py::object& self) {
  std::string text;
  for (const auto& [name, value] : fields_of(self)) {
    text += (text.empty() ? "" : ", ") + py::str(name).cast<std::string>() + '=' +
            py::repr(value).cast<std::string>();
  }
  return type_name(self) + '(' + text + ')';
}

}  // namespace python
