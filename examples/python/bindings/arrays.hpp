// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Geometry>

namespace python {

namespace py = pybind11;

/// An argument of which NumPy can make an array: one, or nested lists of numbers.
class ArrayLike : public py::object {
  static bool accept(PyObject* object) { return object != nullptr; }

 public:
  PYBIND11_OBJECT_DEFAULT(ArrayLike, py::object, accept)
};

/// Any number of rows or columns in a wanted shape.
inline constexpr py::ssize_t any = -1;

/// The argument as an array of real numbers of a shape, with whatever strides; without a copy where
/// it is an array of double. Throws InvalidValue, in a sentence that begins with `name`.
py::array_t<double> numbers(const ArrayLike& argument, const std::string& name,
                            std::initializer_list<py::ssize_t> shape);

/// The same of whole numbers, that of 64-bit integers.
py::array_t<std::int64_t> whole_numbers(const ArrayLike& argument, const std::string& name,
                                        std::initializer_list<py::ssize_t> shape);

/// Throws InvalidValue unless an array has as many rows as there are `of`.
void require_rows(const py::array& array, const std::string& name, py::ssize_t rows,
                  const std::string& of);

/// The numbers as an array.
template <typename Number>
py::array_t<Number> array_from(const std::vector<Number>& values) {
  return py::array_t<Number>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// A rigid motion from its 4 × 4 matrix. Throws InvalidValue.
Eigen::Isometry3d pose_of(const ArrayLike& argument, const std::string& name);

/// Its 4 × 4 matrix.
py::array_t<double> matrix_of(const Eigen::Isometry3d& pose);

}  // namespace python

namespace pybind11::detail {

template <>
struct handle_type_name<python::ArrayLike> {
  static constexpr auto name = const_name("numpy.typing.ArrayLike");
};

}  // namespace pybind11::detail
