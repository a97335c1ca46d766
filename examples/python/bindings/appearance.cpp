// SPDX-License-Identifier: MIT
#include <topobag/matching/appearance_counts.hpp>
#include <topobag/sensing/color_descriptor.hpp>

#include "depth_argument.hpp"
#include "detections.hpp"
#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using namespace topobag;
using Image = py::array_t<std::uint8_t, py::array::c_style>;

/// An image of height x width x 3 or 4 bytes; copied unless it is whole in memory.
Image image_from(const ArrayLike& argument) {
  const py::array given = py::array::ensure(argument);
  if (!given || given.ndim() != 3 || given.shape(2) < 3 || given.shape(2) > 4 ||
      !py::isinstance<py::array_t<std::uint8_t>>(given)) {
    PyErr_Clear();
    throw InvalidValue("the image is no array of height x width x 3 (or 4) bytes (uint8)");
  }
  if (given.shape(0) > 1'000'000 || given.shape(1) > 1'000'000) {
    throw InvalidValue("the image is more than a million pixels wide or high");
  }
  return Image(given);
}

py::array_t<std::int8_t> rows_of_looks(const std::vector<Appearance>& looks) {
  constexpr auto length = static_cast<py::ssize_t>(ColorDescriptor::kind.length());
  py::array_t<std::int8_t> rows({static_cast<py::ssize_t>(looks.size()), length});
  std::int8_t* out = rows.mutable_data();
  for (const Appearance& look : looks) {
    for (std::size_t i = 0; i < ColorDescriptor::kind.length(); ++i) {
      *out++ = look.known() ? look.bytes()[i] : std::int8_t{0};
    }
  }
  return rows;
}

py::array_t<std::int8_t> color_descriptors(const ArrayLike& image, const ArrayLike& boxes,
                                           const std::optional<ArrayLike>& depth,
                                           const std::optional<ArrayLike>& z,
                                           const ColorDescriptorOptions& options, bool bgr,
                                           const std::optional<double>& depth_scale) {
  const Image pixels = image_from(image);
  const ImageView view(pixels.data(), static_cast<int>(pixels.shape(1)),
                       static_cast<int>(pixels.shape(0)), bgr ? ColorOrder::bgr : ColorOrder::rgb,
                       0, static_cast<int>(pixels.shape(2)));
  const std::vector<BoundingBox> of = boxes_from(boxes);
  const ColorDescriptor describe(view, options);
  std::vector<Appearance> looks;
  if (!depth) {
    for (const BoundingBox& box : of) looks.push_back(describe(box));
    return rows_of_looks(looks);
  }
  if (!z) throw InvalidValue("a depth image tells the background only by z, the objects' depths");
  const auto given = numbers(*z, "z", {any});
  require_rows(given, "z", static_cast<py::ssize_t>(of.size()), "boxes");
  const std::vector<double> depths(given.data(), given.data() + given.size());
  with_depth_view(*depth, depth_scale, [&](const auto& depth_of) {
    for (std::size_t i = 0; i < of.size(); ++i) {
      looks.push_back(describe(of[i], depth_of, depths[i]));
    }
    return 0;
  });
  return rows_of_looks(looks);
}

}  // namespace

void bind_appearance(py::module_& module) {
  Fields<ColorDescriptorOptions>(module, "ColorDescriptorOptions")
      .field("central_share", &ColorDescriptorOptions::central_share)
      .field("grid", &ColorDescriptorOptions::grid)
      .field("depth_tolerance", &ColorDescriptorOptions::depth_tolerance)
      .field("least_tolerance", &ColorDescriptorOptions::least_tolerance);
  module.def("color_descriptors", &color_descriptors, py::arg("image"), py::arg("boxes"),
             py::arg("depth") = py::none(), py::arg("z") = py::none(),
             py::arg_v("options", ColorDescriptorOptions(), "ColorDescriptorOptions()"),
             py::kw_only(), py::arg("bgr") = false, py::arg("depth_scale") = py::none(),
             "What each box's object looks like: rows for `appearances`, of the kind "
             "AppearanceKind.color(); "
             "zeros where no pixel is of the object. The image is height x width x 3 (or 4) bytes, "
             "the boxes N x 4 (px). With a depth image and the objects' depths z (m), pixels "
             "before or behind the object are left out.");
  Fields<AppearanceOdds>(module, "AppearanceOdds")
      .field("similarity", &AppearanceOdds::similarity)
      .field("log10_odds", &AppearanceOdds::log10_odds);
  Fields<AppearanceModel>(module, "AppearanceModel")
      .field("kind", &AppearanceModel::kind)
      .field("table", &AppearanceModel::table)
      .field("furnished_alike", &AppearanceModel::furnished_alike)
      .field("light_changed", &AppearanceModel::light_changed)
      .def("log10_odds", py::overload_cast<double>(&AppearanceModel::log10_odds, py::const_),
           py::arg("similarity"), doc("AppearanceModel.log10_odds"))
      .def("log10_odds_together", &AppearanceModel::log10_odds_together, py::arg("sum"),
           doc("AppearanceModel.log10_odds_together"))
      .def("validate", &AppearanceModel::validate, doc("AppearanceModel.validate"));
  Fields<AppearancePrior>(module, "AppearancePrior")
      .field("unlike", &AppearancePrior::unlike)
      .field("twins", &AppearancePrior::twins)
      .field("min_pairs", &AppearancePrior::min_pairs);
  py::class_<AppearanceCounts>(module, "AppearanceCounts", doc("AppearanceCounts"))
      .def(py::init<AppearanceKind>(),
           py::arg_v("kind", ColorDescriptor::kind, "AppearanceKind.color()"),
           doc("AppearanceCounts.AppearanceCounts"))
      .def_property_readonly("kind", &AppearanceCounts::kind, doc("AppearanceCounts.kind"))
      .def_property_readonly("same", &AppearanceCounts::same, doc("AppearanceCounts.same"))
      .def_property_readonly("other", &AppearanceCounts::other, doc("AppearanceCounts.other"))
      .def("model", &AppearanceCounts::model,
           py::arg_v("prior", AppearancePrior(), "AppearancePrior()"),
           doc("AppearanceCounts.model"));
}

}  // namespace python
