// SPDX-License-Identifier: MIT
#include "arrays.hpp"

#include <algorithm>

#include <topobag/error.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace python {
namespace {

std::string shape_text(const py::array& array) {
  return py::str(py::tuple(array.attr("shape"))).cast<std::string>();
}

std::string wanted_text(std::initializer_list<py::ssize_t> shape) {
  std::string text;
  for (const py::ssize_t size : shape) {
    text += (text.empty() ? "" : " x ") + (size == any ? "N" : std::to_string(size));
  }
  return text;
}

/// The argument as NumPy sees it, of one of `kinds` and of the shape.
py::array array_of(const ArrayLike& argument, const std::string& name, const std::string& kinds,
                   const char* wanted, std::initializer_list<py::ssize_t> shape) {
  const py::array array = py::array::ensure(argument);
  if (!array) {
    PyErr_Clear();
    throw topobag::InvalidValue(name +
                                " is no array of numbers, such as nested lists of one "
                                "length each are");
  }
  const bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size()) &&
                    std::equal(shape.begin(), shape.end(), array.shape(),
                               [](py::ssize_t a, py::ssize_t b) { return a == any || a == b; });
  if (!fits) {
    // An empty list has no columns, and no rows to have them.
    if (array.size() == 0 && array.ndim() == 1 && shape.size() > 0 && *shape.begin() == any) {
      std::vector<py::ssize_t> empty(shape);
      for (py::ssize_t& size : empty) size = size == any ? 0 : size;
      return py::array(py::dtype::of<double>(), empty);
    }
    throw topobag::InvalidValue(name + " has the shape " + shape_text(array) + "; give " +
                                wanted_text(shape));
  }
  if (array.size() > 0 && kinds.find(array.dtype().kind()) == std::string::npos) {
    throw topobag::InvalidValue(name + " has the type " +
                                py::str(array.dtype()).cast<std::string>() + "; give " + wanted);
  }
  return array;
}

}  // namespace

py::array_t<double> numbers(const ArrayLike& argument, const std::string& name,
                            std::initializer_list<py::ssize_t> shape) {
  return py::array_t<double>(array_of(argument, name, "fiub", "real numbers", shape));
}

py::array_t<std::int64_t> whole_numbers(const ArrayLike& argument, const std::string& name,
                                        std::initializer_list<py::ssize_t> shape) {
  const py::array array = array_of(argument, name, "iu", "whole numbers", shape);
  if (array.dtype().kind() == 'u' && array.itemsize() == 8 && array.size() > 0 &&
      array.attr("max")().cast<std::uint64_t>() > std::uint64_t{INT64_MAX}) {
    throw topobag::InvalidValue(name + " holds a number of 2^63 or more");
  }
  return py::array_t<std::int64_t>(array);
}

void require_rows(const py::array& array, const std::string& name, py::ssize_t rows,
                  const std::string& of) {
  if (array.shape(0) == rows) return;
  throw topobag::InvalidValue(name + " has " + std::to_string(array.shape(0)) +
                              " rows, but there are " + std::to_string(rows) + ' ' + of);
}

Eigen::Isometry3d pose_of(const ArrayLike& argument, const std::string& name) {
  const auto given = numbers(argument, name, {4, 4});
  const auto entry = given.unchecked<2>();
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) matrix(i, j) = entry(i, j);
  }
  Eigen::Isometry3d pose;
  pose.matrix() = matrix;
  topobag::require_rigid(pose, name.c_str());
  return pose;
}

py::array_t<double> matrix_of(const Eigen::Isometry3d& pose) {
  py::array_t<double> matrix({4, 4});
  auto entry = matrix.mutable_unchecked<2>();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) entry(i, j) = pose(i, j);
  }
  return matrix;
}

}  // namespace python
