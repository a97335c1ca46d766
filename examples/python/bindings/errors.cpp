// SPDX-License-Identifier: MIT
#include <exception>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <topobag/error.hpp>

#include "docs.hpp"
#include "rooms.hpp"

namespace python {
namespace {

namespace py = pybind11;

/// The classes of exceptions; they live as long as the interpreter.
struct ErrorTypes {
  py::handle error, invalid_value, unknown_class, invalid_id, format_error;
};

ErrorTypes& types() {
  static ErrorTypes known;
  return known;
}

py::handle add_type(py::module_& module, const char* name, const py::tuple& bases) {
  const std::string full = "topobag." + std::string(name);
  py::object type = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc(full.c_str(), doc(name), bases.ptr(), nullptr));
  if (!type) throw py::error_already_set();
  module.attr(name) = type;
  return type.release();
}

void raise(py::handle type, const topobag::Error& error) {
  py::object raised = py::reinterpret_borrow<py::object>(type)(error.what());
  raised.attr("index") = py::cast(error.index());
  PyErr_SetObject(type.ptr(), raised.ptr());
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const topobag::InvalidValue& error) {
    raise(types().invalid_value, error);
  } catch (const topobag::UnknownClass& error) {
    raise(types().unknown_class, error);
  } catch (const topobag::InvalidId& error) {
    raise(types().invalid_id, error);
  } catch (const topobag::FormatError& error) {
    raise(types().format_error, error);
  } catch (const topobag::Error& error) {
    raise(types().error, error);
  }
}

}  // namespace

void bind_errors(py::module_& module) {
  const auto builtin = [](PyObject* type) { return py::reinterpret_borrow<py::object>(type); };
  const auto below = [](py::handle type, const py::object& other) {
    return py::make_tuple(py::reinterpret_borrow<py::object>(type), other);
  };
  ErrorTypes& known = types();
  known.error = add_type(module, "Error", py::make_tuple(builtin(PyExc_Exception)));
  known.error.attr("index") = py::none();
  known.invalid_value =
      add_type(module, "InvalidValue", below(known.error, builtin(PyExc_ValueError)));
  known.unknown_class =
      add_type(module, "UnknownClass", below(known.error, builtin(PyExc_LookupError)));
  known.invalid_id = add_type(module, "InvalidId", below(known.error, builtin(PyExc_LookupError)));
  known.format_error =
      add_type(module, "FormatError", below(known.error, builtin(PyExc_ValueError)));
  py::register_exception_translator(&translate);
}

}  // namespace python
