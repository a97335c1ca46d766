// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include <topobag/sensing/pinhole_camera.hpp>

namespace program {

/// Adds an option such as `--camera fx,fy,cx,cy[,width,height]`, px, which fills `camera`.
/// Parsing throws InputError when it is not a camera.
CLI::Option* add_camera_option(CLI::App& command, const std::string& name,
                               topobag::PinholeCamera<>& camera, const std::string& description);

struct ImageSize {
  int width = 640;   ///< px
  int height = 480;  ///< px
  bool given = false;
};

/// Adds the option `--image-size width,height`, for a camera that was given without.
CLI::Option* add_image_size_option(CLI::App& command, ImageSize& size);

/// The camera, with `size` where it has none. Throws InputError where it has another than was
/// given.
topobag::PinholeCamera<> with_size(topobag::PinholeCamera<> camera, const ImageSize& size);

/// Throws InputError where a focal length is that of no lens over the image, whose size is known,
/// or the two are of no image's pixels: they are not in px, or a digit is missing.
void require_focal_length(const topobag::PinholeCamera<>& camera);

/// Throws InputError where the principal point lies far from the middle of the image, whose size is
/// known, or would lie in it with cx and cy the other way round: the intrinsics are of another
/// image size, or in another order.
void require_principal_point(const topobag::PinholeCamera<>& camera);

}  // namespace program
