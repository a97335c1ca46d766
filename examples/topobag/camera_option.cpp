// SPDX-License-Identifier: MIT
#include "camera_option.hpp"

#include <optional>
#include <sstream>
#include <vector>

#include "csv_reader.hpp"
#include "input_error.hpp"

namespace program {
namespace {

/// An option's text, read as numbers between commas.
class NumberList {
 public:
  /// @param form  what is asked for, to be said when it is not there
  NumberList(const std::string& option, const std::string& text, const char* form)
      : place_(option + ' ' + text), form_(form) {
    std::istringstream fields(text);
    for (std::string field; std::getline(fields, field, ',');) {
      const std::optional<double> number = parse_number(field);
      if (!number) throw error("'" + field + "' is not a number");
      numbers_.push_back(*number);
    }
  }

  std::size_t size() const { return numbers_.size(); }
  double operator[](std::size_t i) const { return numbers_[i]; }

  /// An image's width or height, px.
  int pixels(std::size_t i) const {
    const double largest = 1e6;
    if (!(numbers_[i] >= 1.0 && numbers_[i] <= largest)) {
      throw error("the image size is not in [1, 1e6] px");
    }
    return static_cast<int>(numbers_[i]);
  }

  InputError error(const std::string& why) const { return {place_, why + "; give " + form_}; }

 private:
  std::string place_;
  const char* form_;
  std::vector<double> numbers_;
};

topobag::PinholeCamera<> parse_camera(const std::string& option, const std::string& text) {
  const NumberList v(option, text, "fx,fy,cx,cy or fx,fy,cx,cy,width,height");
  if (v.size() != 4 && v.size() != 6) throw v.error("there are not 4 or 6 numbers");
  topobag::PinholeCamera<> camera{v[0], v[1], v[2], v[3]};
  if (v.size() == 6) {
    camera.width = v.pixels(4);
    camera.height = v.pixels(5);
  }
  try {
    camera.validate();
  } catch (const topobag::InvalidValue& invalid) {
    throw v.error(invalid.what());
  }
  return camera;
}

ImageSize parse_image_size(const std::string& text) {
  const NumberList v("--image-size", text, "width,height");
  if (v.size() != 2) throw v.error("there are not 2 numbers");
  return {v.pixels(0), v.pixels(1)};
}

}  // namespace

CLI::Option* add_camera_option(CLI::App& command, const std::string& name,
                               topobag::PinholeCamera<>& camera, const std::string& description) {
  return command.add_option_function<std::string>(
      name, [&camera, name](const std::string& text) { camera = parse_camera(name, text); },
      description);
}

CLI::Option* add_image_size_option(CLI::App& command, ImageSize& size) {
  return command
      .add_option_function<std::string>(
          "--image-size", [&size](const std::string& text) { size = parse_image_size(text); },
          "Size of the images where the camera does not tell it, px")
      ->default_str(std::to_string(size.width) + ',' + std::to_string(size.height));
}

topobag::PinholeCamera<> with_size(topobag::PinholeCamera<> camera, const ImageSize& size) {
  if (camera.width == 0) {
    camera.width = size.width;
    camera.height = size.height;
  }
  return camera;
}

}  // namespace program
