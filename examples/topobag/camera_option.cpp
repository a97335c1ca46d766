// SPDX-License-Identifier: MIT
#include "camera_option.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

#include "number_list.hpp"

namespace program {
namespace {

/// A list's number that is an image's width or height, px.
int pixels(const NumberList& v, std::size_t i) {
  const double largest = 1e6;
  if (!(v[i] >= 1.0 && v[i] <= largest)) {
    throw v.error("the image size is not in [1, 1e6] px");
  }
  if (v[i] != std::floor(v[i])) throw v.error("the image size is in whole px");
  return static_cast<int>(v[i]);
}

topobag::PinholeCamera<> parse_camera(const std::string& option, const std::string& text) {
  const NumberList v(option, text, "fx,fy,cx,cy or fx,fy,cx,cy,width,height");
  if (v.size() != 4 && v.size() != 6) throw v.error("there are not 4 or 6 numbers");
  topobag::PinholeCamera<> camera{v[0], v[1], v[2], v[3]};
  if (v.size() == 6) {
    camera.width = pixels(v, 4);
    camera.height = pixels(v, 5);
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
  return {pixels(v, 0), pixels(v, 1), true};
}

}  // namespace

void require_principal_point(const topobag::PinholeCamera<>& camera) {
  // Of the size: calibrations are a few hundredths off, those of images of half the size .25.
  constexpr double farthest = 0.2;
  // Of the size: cx and cy of real cameras, which are not both off by more and right when swapped.
  constexpr double near = 0.05;
  const auto is_off = [](double center, int size, double share) {
    return std::abs(center - 0.5 * size) > share * size;
  };
  const bool swapped =
      is_off(camera.cx, camera.width, near) && is_off(camera.cy, camera.height, near) &&
      !is_off(camera.cy, camera.width, near) && !is_off(camera.cx, camera.height, near);
  if (swapped) {
    std::ostringstream why;
    why << "the principal point " << camera.cx << ", " << camera.cy << " is that of an image of "
        << camera.width << " x " << camera.height
        << " px with cx and cy swapped; the order is fx,fy,cx,cy";
    throw InputError("--camera", why.str());
  }
  if (!is_off(camera.cx, camera.width, farthest) && !is_off(camera.cy, camera.height, farthest)) {
    return;
  }
  std::ostringstream why;
  why << "the principal point " << camera.cx << ", " << camera.cy
      << " lies far from the middle of an image of " << camera.width << " x " << camera.height
      << " px; give the intrinsics for that size, or the size that they are for";
  throw InputError("--camera", why.str());
}

void require_focal_length(const topobag::PinholeCamera<>& camera) {
  // Of the size: 157 degrees wide, more than any image without distortion. Lenses in mm lie below.
  // Of the longer side: 7 degrees, as a lens of 290 mm on film has; px times ten lie beyond.
  constexpr double shortest = 0.1, longest = 8.0;
  const int longer = std::max(camera.width, camera.height);
  const auto require = [&](const char* name, double focal, int size) {
    if (focal >= shortest * size && focal <= longest * longer) return;
    const double degrees = 57.29577951308232;
    std::ostringstream why;
    why.precision(5);
    const double view = 2.0 * degrees * std::atan(0.5 * size / focal);
    why << name << ' ' << focal << " px is a field of view of " << std::round(10.0 * view) / 10.0
        << "° over " << size << " px; give the focal length in px";
    throw InputError("--camera", why.str());
  };
  require("fx", camera.fx, camera.width);
  require("fy", camera.fy, camera.height);
  // Images squeezed from 21:9 to a square have .43.
  constexpr double narrowest = 0.4;
  const double ratio = camera.fx / camera.fy;
  if (ratio >= narrowest && ratio * narrowest <= 1.0) return;
  std::ostringstream why;
  why << "fx " << camera.fx << " and fy " << camera.fy
      << " px differ by more than any image's pixels do in width and height; is there a digit too "
         "few or too many?";
  throw InputError("--camera", why.str());
}

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
  const bool other = camera.width != size.width || camera.height != size.height;
  if (camera.width > 0 && size.given && other) {
    throw InputError("--image-size", std::to_string(size.width) + " x " +
                                         std::to_string(size.height) +
                                         " px is not the size that the camera has, " +
                                         std::to_string(camera.width) + " x " +
                                         std::to_string(camera.height) + "; leave it out");
  }
  if (camera.width == 0) {
    camera.width = size.width;
    camera.height = size.height;
  }
  if (camera.fx > 0.0) {  // it was given
    require_focal_length(camera);
    require_principal_point(camera);
  }
  return camera;
}

}  // namespace program
