// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

/// ONNX's protocol buffers, as far as a network of a few layers needs them.
namespace onnx_text {

inline std::string varint(std::uint64_t number) {
  std::string bytes;
  for (; number > 0x7F; number >>= 7) bytes += static_cast<char>(number | 0x80);
  return bytes + static_cast<char>(number);
}
inline std::string number_field(unsigned field, std::uint64_t number) {
  return varint(field << 3) + varint(number);
}
inline std::string bytes_field(unsigned field, const std::string& bytes) {
  return varint(field << 3 | 2) + varint(bytes.size()) + bytes;
}

/// An input or an output: floats of these dimensions.
inline std::string value_info(const std::string& name, const std::vector<std::uint64_t>& shape) {
  std::string dimensions;
  for (const std::uint64_t size : shape) {
    dimensions += bytes_field(1, number_field(1, size));
  }
  const std::string tensor = number_field(1, 1) + bytes_field(2, dimensions);
  return bytes_field(1, name) + bytes_field(2, bytes_field(1, tensor));
}

/// Floats (type 1) or whole numbers of 64 bits (type 7) that the network knows.
template <typename Number>
std::string tensor(const std::string& name, std::uint64_t type,
                   const std::vector<std::uint64_t>& shape, const std::vector<Number>& numbers) {
  std::string text, raw(numbers.size() * sizeof(Number), '\0');
  std::memcpy(raw.data(), numbers.data(), raw.size());
  for (const std::uint64_t size : shape) text += number_field(1, size);
  return text + number_field(2, type) + bytes_field(8, name) + bytes_field(9, raw);
}

/// An attribute of whole numbers.
inline std::string numbers_attribute(const std::string& name,
                                     const std::vector<std::uint64_t>& numbers) {
  std::string text = bytes_field(1, name);
  for (const std::uint64_t number : numbers) text += number_field(8, number);
  return text + number_field(20, 7);
}

inline std::string node(const std::string& type, const std::vector<std::string>& inputs,
                        const std::string& output,
                        const std::vector<std::string>& attributes = {}) {
  std::string text;
  for (const std::string& input : inputs) text += bytes_field(1, input);
  text += bytes_field(2, output) + bytes_field(3, output) + bytes_field(4, type);
  for (const std::string& attribute : attributes) text += bytes_field(5, attribute);
  return text;
}

}  // namespace onnx_text

/// A YOLOv5 network of one class for images of side 32 that always sees the same box, whose middle
/// and size are given, px of its input; its layer "features" holds the three colours' means over
/// cells of 8 × 8 px, as ONNX.
inline std::string tiny_yolov5(float x, float y, float width, float height) {
  using namespace onnx_text;
  std::vector<float> means(3 * 3 * 8 * 8, 0.0F);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < 64; ++i) means[(c * 3 + c) * 64 + i] = 1.0F / 64.0F;
  }
  const std::string features =
      node("Conv", {"image", "means", "zeros"}, "features",
           {numbers_attribute("kernel_shape", {8, 8}), numbers_attribute("strides", {8, 8})});
  const std::string seen = node("Conv", {"features", "nothing", "box"}, "seen",
                                {numbers_attribute("kernel_shape", {4, 4})});
  const std::string row = node("Reshape", {"seen", "shape"}, "boxes");
  std::string graph;
  for (const std::string& layer : {features, seen, row}) graph += bytes_field(1, layer);
  graph += bytes_field(2, "tiny");
  const auto known = [&](const std::string& tensor_text) { graph += bytes_field(5, tensor_text); };
  known(tensor<float>("means", 1, {3, 3, 8, 8}, means));
  known(tensor<float>("zeros", 1, {3}, {0, 0, 0}));
  known(tensor<float>("nothing", 1, {6, 3, 4, 4}, std::vector<float>(6 * 3 * 16, 0.0F)));
  known(tensor<float>("box", 1, {6}, {x, y, width, height, 1.0F, 0.9F}));
  known(tensor<std::int64_t>("shape", 7, {3}, {1, 1, 6}));
  graph += bytes_field(11, value_info("image", {1, 3, 32, 32}));
  graph += bytes_field(12, value_info("boxes", {1, 1, 6}));
  const std::string opset = bytes_field(1, "") + number_field(2, 11);
  return number_field(1, 6) + bytes_field(7, graph) + bytes_field(8, opset);
}
