// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/dnn/dnn.hpp>

#include <topobag/adaptors/layer_features.hpp>
#include <topobag/adaptors/opencv/letterbox.hpp>
#include <topobag/adaptors/yolo_heads.hpp>
#include <topobag/bag/detail/storage/crc32.hpp>
#include <topobag/error.hpp>
#include <topobag/sensing/non_maximum_suppression.hpp>
#include <topobag/types/ranged_detection.hpp>

namespace topobag {
inline namespace v0 {

/// A YOLO network that OpenCV runs. Not for two threads at a time.
class YoloDetector {
 public:
  /// @param model    ONNX file
  /// @param classes  the class behind each score of the network
  /// Throws Error, which names the file.
  YoloDetector(std::string model, std::vector<ClassId> classes, const YoloOptions& options = {})
      : model_(std::move(model)), classes_(std::move(classes)), options_(options) {
    std::ifstream file(model_, std::ios::binary);
    if (!file) throw Error(model_ + ": the file cannot be read");
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    try {
      net_ = cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
    } catch (const cv::Exception&) {
      throw Error(model_ + ": the file is not an ONNX network that OpenCV can read");
    }
    checksum_ = detail::crc32(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }

  /// The objects in a colour image (8-bit BGR), most confident first; boxes lie in the image and
  /// span a pixel at least. Throws InvalidValue for an empty image, Error when the network and the
  /// options do not fit.
  std::vector<Detection> operator()(const cv::Mat& image) {
    const Letterbox letterbox = letterbox_of(image);
    std::vector<Detection> detections;
    for_each_seen(letterbox, forward(letterbox, ""),
                  [&](const Detection& seen, const BoundingBox&) { detections.push_back(seen); });
    return detections;
  }

  /// The same, each with what `layer` of the network says of its box (`LayerFeatures`) and without
  /// a depth. Throws Error as well where the network has no such layer, or it puts out no map of
  /// features over the image.
  std::vector<RangedDetection> described(const cv::Mat& image, const std::string& layer) {
    const std::string name = layer_named(layer);
    const Letterbox letterbox = letterbox_of(image);
    const std::vector<cv::Mat> outputs = forward(letterbox, name);
    const cv::Mat& features = outputs.back();
    if (features.dims != 4 || features.size[0] != 1 || features.type() != CV_32F) {
      throw Error(model_ + ": the layer '" + layer + "' puts out no map of features");
    }
    const LayerOutput map{features.ptr<float>(), static_cast<std::size_t>(features.size[1]),
                          static_cast<std::size_t>(features.size[2]),
                          static_cast<std::size_t>(features.size[3])};
    const AppearanceKind kind(appearance_name(layer), LayerFeatures::length_for(map.channels));
    const LayerFeatures describe(map, kind, options_.input_size);
    std::vector<RangedDetection> detections;
    for_each_seen(letterbox, outputs, [&](const Detection& seen, const BoundingBox& in_input) {
      detections.push_back({seen.box, seen.label, seen.confidence, 0.0, describe(in_input)});
    });
    return detections;
  }

  /// The name of the kind of these descriptors: the layer, and the network by its bytes, since two
  /// networks name their layers alike and mean other things.
  std::string appearance_name(const std::string& layer) const {
    std::array<char, 9> digits{};
    std::snprintf(digits.data(), digits.size(), "%08x", static_cast<unsigned>(checksum_));
    return "layer:" + layer + "@" + digits.data();
  }

 private:
  /// A layer's name as OpenCV has it, which puts what kind of thing it is before a name of the
  /// file's: "onnx_node!Concat_66".
  std::string layer_named(const std::string& layer) const {
    const std::vector<cv::String> names = net_.getLayerNames();
    const auto is_it = [&](const std::string& name) {
      const std::size_t mark = name.find('!');
      return name == layer || (mark != name.npos && name.substr(mark + 1) == layer);
    };
    const auto found = std::find_if(names.begin(), names.end(), is_it);
    if (found != names.end()) return *found;
    throw Error(model_ + ": the network has no layer '" + layer + "' among its " +
                std::to_string(names.size()) + (names.empty() ? "" : "; the last is '") +
                (names.empty() ? "" : std::string(names.back()) + "'"));
  }

  Letterbox letterbox_of(const cv::Mat& image) const {
    return Letterbox(
        image, options_.input_size,
        options_.head == YoloHead::yolox ? Letterbox::Place::upper_left : Letterbox::Place::center);
  }

  /// What the network puts out, and the layer where one is named.
  std::vector<cv::Mat> forward(const Letterbox& letterbox, const std::string& layer) {
    const bool yolox = options_.head == YoloHead::yolox;
    try {
      // YOLOX takes BGR, 0 to 255, the others RGB, 0 to 1.
      net_.setInput(cv::dnn::blobFromImage(letterbox.input(), yolox ? 1.0 : 1.0 / 255.0, cv::Size(),
                                           cv::Scalar(), !yolox));
      if (layer.empty()) return {net_.forward()};
      std::vector<cv::Mat> outputs;
      net_.forward(outputs, std::vector<cv::String>{net_.getLayerNames().back(), layer});
      return outputs;
    } catch (const cv::Exception& error) {
      throw Error(model_ + ": OpenCV cannot run the network on an image of side " +
                  std::to_string(options_.input_size) + ": " + error.err);
    }
  }

  /// Calls `found(detection in the image, box in the network's input)`.
  template <typename Found>
  void for_each_seen(const Letterbox& letterbox, const std::vector<cv::Mat>& outputs,
                     const Found& found) const {
    const auto seen = suppress_non_maxima(detections_in(outputs.front()), options_.max_iou);
    for (Detection detection : seen) {
      const BoundingBox in_input = detection.box;
      detection.box = letterbox.in_image(in_input);
      const bool a_pixel_left = detection.box.width() >= 1.0 && detection.box.height() >= 1.0;
      if (a_pixel_left) found(detection, in_input);
    }
  }

  /// Throws Error, which names the file, when the output is not the head's.
  std::vector<Detection> detections_in(const cv::Mat& output) const {
    try {
      return decoded(output);
    } catch (const InvalidValue& why) {
      throw Error(model_ + ": " + why.what());
    }
  }

  std::vector<Detection> decoded(const cv::Mat& output) const {
    if (output.dims != 3 || output.type() != CV_32F) {
      throw Error(model_ + ": the network does not put out one table of numbers");
    }
    const NetworkOutput table{output.ptr<float>(), static_cast<std::size_t>(output.size[1]),
                              static_cast<std::size_t>(output.size[2])};
    switch (options_.head) {
      case YoloHead::yolov5:
        return decode_yolov5(table, classes_, options_.min_confidence);
      case YoloHead::yolov8:
        return decode_yolov8(table, classes_, options_.min_confidence);
      case YoloHead::yolox:
        break;
    }
    return decode_yolox(table, classes_, options_.input_size, options_.min_confidence);
  }

  std::string model_;
  cv::dnn::Net net_;
  std::vector<ClassId> classes_;
  YoloOptions options_;
  std::uint32_t checksum_ = 0;  ///< of the model's bytes
};

}  // namespace v0
}  // namespace topobag
