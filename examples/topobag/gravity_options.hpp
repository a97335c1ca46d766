// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <Eigen/Core>

#include "table_gravity.hpp"

namespace program {

/// Adds an option such as `--world-up x,y,z`, which fills `up`. Parsing throws InputError when it
/// is no direction.
void add_world_up_option(CLI::App& command, const std::string& name,
                         std::optional<Eigen::Vector3d>& up, const std::string& description);

/// Adds `--world-up` and `--gravity-noise`.
void add_gravity_options(CLI::App& command, TableGravity& gravity);

}  // namespace program
