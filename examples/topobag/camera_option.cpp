// SPDX-License-Identifier: MIT
#include "camera_option.hpp"

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "csv_reader.hpp"
#include "input_error.hpp"

namespace program {
namespace {

topobag::PinholeCamera<> parse_camera(const std::string& text) {
  const auto refuse = [&](const std::string& why) {
    return InputError("--camera " + text, why + "; give fx,fy,cx,cy or fx,fy,cx,cy,width,height");
  };
  std::vector<double> v;
  std::istringstream fields(text);
  for (std::string field; std::getline(fields, field, ',');) {
    const std::optional<double> number = parse_number(field);
    if (!number) throw refuse("'" + field + "' is not a number");
    v.push_back(*number);
  }
  if (v.size() != 4 && v.size() != 6) throw refuse("there are not 4 or 6 numbers");
  topobag::PinholeCamera<> camera{v[0], v[1], v[2], v[3]};
  if (v.size() == 6) {
    const double largest = 1e6;
    for (const double size : {v[4], v[5]}) {
      if (!(size >= 1.0 && size <= largest)) throw refuse("the image size is not in [1, 1e6] px");
    }
    camera.width = static_cast<int>(v[4]);
    camera.height = static_cast<int>(v[5]);
  }
  try {
    camera.validate();
  } catch (const topobag::InvalidValue& invalid) {
    throw refuse(invalid.what());
  }
  return camera;
}

}  // namespace

CLI::Option* add_camera_option(CLI::App& command, topobag::PinholeCamera<>& camera) {
  return command
      .add_option_function<std::string>(
          "--camera", [&camera](const std::string& text) { camera = parse_camera(text); },
          "Intrinsics fx,fy,cx,cy[,width,height], px")
      ->required();
}

}  // namespace program
