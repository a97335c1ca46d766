// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <topobag/sensing/pinhole_camera.hpp>

namespace program {

/// Adds the required option `--camera fx,fy,cx,cy[,width,height]`, px, which fills `camera`.
/// Parsing throws InputError when it is not a camera.
CLI::Option* add_camera_option(CLI::App& command, topobag::PinholeCamera<>& camera);

}  // namespace program
