// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>

#include "arrays.hpp"

namespace pybind11::detail {

/// Ids are whole numbers in Python. One that is out of range is told so.
template <typename Id>
class IdCaster {
  using Number = std::underlying_type_t<Id>;

 public:
  PYBIND11_TYPE_CASTER(Id, const_name("int"));

  bool load(handle source, bool) {
    if (!source || PyIndex_Check(source.ptr()) == 0) return false;
    const auto number = reinterpret_steal<object>(PyNumber_Index(source.ptr()));
    if (!number) throw error_already_set();
    make_caster<Number> caster;
    if (!caster.load(number, false)) {
      throw topobag::InvalidValue("an id of " + str(number).cast<std::string>() +
                                  "; ids here are whole numbers from " +
                                  std::to_string(std::numeric_limits<Number>::min()) + " to " +
                                  std::to_string(std::numeric_limits<Number>::max()));
    }
    value = static_cast<Id>(cast_op<Number>(caster));
    return true;
  }

  static handle cast(Id id, return_value_policy policy, handle parent) {
    return make_caster<Number>::cast(static_cast<Number>(id), policy, parent);
  }
};

template <>
struct type_caster<topobag::ClassId> : IdCaster<topobag::ClassId> {};
template <>
struct type_caster<topobag::KeyframeId> : IdCaster<topobag::KeyframeId> {};
template <>
struct type_caster<topobag::NodeIndex> : IdCaster<topobag::NodeIndex> {};

/// Poses are 4 × 4 arrays in Python.
template <>
class type_caster<Eigen::Isometry3d> {
 public:
  PYBIND11_TYPE_CASTER(Eigen::Isometry3d, const_name("numpy.typing.NDArray[numpy.float64]"));

  bool load(handle source, bool) {
    if (!source || source.is_none()) return false;
    value = python::pose_of(reinterpret_borrow<python::ArrayLike>(source), "a pose");
    return true;
  }

  static handle cast(const Eigen::Isometry3d& pose, return_value_policy, handle) {
    return python::matrix_of(pose).release();
  }
};

}  // namespace pybind11::detail
