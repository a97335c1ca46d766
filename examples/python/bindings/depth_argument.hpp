// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <topobag/sensing/depth_view.hpp>

#include "arrays.hpp"

namespace python {

/// An image whose rows are whole in memory; of one that is flipped or transposed, a copy.
template <typename Pixel>
py::array_t<Pixel> with_whole_rows(const py::array& image) {
  const bool whole = image.strides(1) == image.itemsize() && image.strides(0) > 0 &&
                     image.strides(0) % image.itemsize() == 0 &&
                     image.strides(0) >= image.shape(1) * image.itemsize();
  if (whole) return py::array_t<Pixel>(image);
  return py::array_t<Pixel, py::array::c_style | py::array::forcecast>(image);
}

/// A `DepthView` over the array's memory. The array has to stay.
template <typename Pixel>
topobag::DepthView<Pixel> view_of(const py::array_t<Pixel>& image, double depth_scale) {
  return {image.data(), static_cast<int>(image.shape(1)), static_cast<int>(image.shape(0)),
          depth_scale, image.shape(0) > 1 ? image.strides(0) / image.itemsize() : 0};
}

/// What `use(depth view)` gives for a depth image of 16-bit or floating-point pixels, which is not
/// copied. Throws InvalidValue for another type or shape, and for 16 bits without a scale.
template <typename Use>
auto with_depth_view(const ArrayLike& depth, const std::optional<double>& depth_scale,
                     const Use& use) {
  const py::array image = py::array::ensure(depth);
  if (!image || image.ndim() != 2) {
    PyErr_Clear();
    throw topobag::InvalidValue("the depth image is no array of height x width");
  }
  if (image.shape(0) > 1'000'000 || image.shape(1) > 1'000'000) {
    throw topobag::InvalidValue("the depth image is more than a million pixels wide or high");
  }
  const auto over = [&](auto pixel, double scale) {
    const auto rows = with_whole_rows<decltype(pixel)>(image);
    const auto view = view_of(rows, scale);
    const py::gil_scoped_release unlocked;
    return use(view);
  };
  if (py::isinstance<py::array_t<std::uint16_t>>(image)) {
    if (!depth_scale) {
      throw topobag::InvalidValue(
          "say by depth_scale how many units of the 16-bit depth image are a metre: 5000 in TUM "
          "RGB-D, 1000 in most");
    }
    return over(std::uint16_t{}, *depth_scale);
  }
  if (py::isinstance<py::array_t<float>>(image)) return over(float{}, depth_scale.value_or(1.0));
  if (py::isinstance<py::array_t<double>>(image)) return over(double{}, depth_scale.value_or(1.0));
  throw topobag::InvalidValue("the depth image has the type " +
                              py::str(image.dtype()).cast<std::string>() +
                              "; give uint16, float32 or float64");
}

}  // namespace python
