// SPDX-License-Identifier: MIT
#include <string_view>
#include <variant>

#include <topobag/bag/image_comparison.hpp>
#include <topobag/types/image_descriptor.hpp>

#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using topobag::ImageDescriptor;
using topobag::ImageKind;

/// Throws InvalidValue for what is no vector of the kind.
ImageDescriptor image_from(const ArrayLike& vector,
                           const std::variant<ImageKind, std::string>& kind) {
  const auto given = numbers(vector, "the image's descriptor", {any});
  const auto entry = given.unchecked<1>();
  Eigen::VectorXd x(given.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) x(i) = entry(i);
  const auto* known = std::get_if<ImageKind>(&kind);
  return ImageDescriptor(known ? *known
                               : ImageKind(std::string_view(std::get<std::string>(kind)),
                                           static_cast<std::size_t>(x.size())),
                         x);
}

py::array_t<std::int8_t> bytes_of(const ImageDescriptor& image) {
  return array_from(image.known() ? image.bytes() : ImageDescriptor::Bytes());
}

double cosine(const ImageDescriptor& a, const ImageDescriptor& b) {
  if (!a.known() || !b.known()) {
    throw topobag::InvalidValue("nothing is known of an image without a descriptor");
  }
  topobag::common_kind(a.kind(), b.kind(), "the second image");
  return topobag::cosine_similarity(a, b);
}

py::tuple state_of(const ImageDescriptor& image) {
  return py::make_tuple(image.kind().number(), bytes_of(image));
}

ImageDescriptor descriptor_of(const py::tuple& state) {
  auto bytes = state[1].cast<ImageDescriptor::Bytes>();
  if (bytes.empty()) return {};
  const ImageKind kind(state[0].cast<std::uint32_t>(), bytes.size());
  return ImageDescriptor(kind, std::move(bytes));
}

}  // namespace

void bind_images(py::module_& module) {
  py::class_<ImageKind>(module, "ImageKind", doc("ImageKind"))
      .def(py::init<std::string_view, std::size_t>(), py::arg("name"), py::arg("length"),
           doc("DescriptorKind.DescriptorKind"))
      .def_property_readonly("number", &ImageKind::number, doc("DescriptorKind.number"))
      .def_property_readonly("length", &ImageKind::length, doc("DescriptorKind.length"))
      .def("__eq__", [](const ImageKind& a, const ImageKind& b) { return a == b; })
      .def("__hash__", [](const ImageKind& kind) { return kind.number(); })
      .def("__repr__", [](const ImageKind& kind) {
        return "<ImageKind " + std::to_string(kind.number()) + " of " +
               std::to_string(kind.length()) + " numbers>";
      });
  py::class_<ImageDescriptor>(module, "ImageDescriptor", doc("ImageDescriptor"))
      .def(py::init<>(), "Unknown.")
      .def(py::init(&image_from), py::arg("vector"), py::arg("kind"),
           "`vector`: an array of 1 to 65535 numbers, of any norm, each of which is kept within "
           "1/254 of the greatest; `kind`: the name of the method that gave them, or an ImageKind "
           "of their length.")
      .def_property_readonly("known", &ImageDescriptor::known, doc("ImageDescriptor.known"))
      .def_property_readonly("kind", &ImageDescriptor::kind, doc("ImageDescriptor.kind"))
      .def_property_readonly("bytes", &bytes_of,
                             "The descriptor's numbers (int8); none where it is unknown.")
      .def(
          "__eq__", [](const ImageDescriptor& a, const ImageDescriptor& b) { return a == b; },
          py::is_operator())
      .def("__repr__",
           [](const ImageDescriptor& image) {
             return image.known() ? "<ImageDescriptor of " + std::to_string(image.kind().length()) +
                                        " numbers>"
                                  : std::string("<ImageDescriptor: unknown>");
           })
      .def(py::pickle(&state_of, &descriptor_of));
  module.def("cosine_similarity", &cosine, py::arg("a"), py::arg("b"),
             "The cosine of the angle between the descriptors of two images, in [-1, 1]. Raises "
             "InvalidValue where one is unknown, or of another kind.");
  Fields<topobag::ImageComparison>(module, "ImageComparison")
      .field("query", &topobag::ImageComparison::query)
      .field("min_similarity", &topobag::ImageComparison::min_similarity)
      .field("weight", &topobag::ImageComparison::weight);
}

}  // namespace python
