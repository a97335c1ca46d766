// SPDX-License-Identifier: MIT
#include "gravity_options.hpp"

#include "number_check.hpp"
#include "number_list.hpp"

namespace program {
namespace {

Eigen::Vector3d parse_direction(const std::string& option, const std::string& text) {
  const NumberList v(option, text, "the axis that points up, such as 0,0,1");
  if (v.size() != 3) throw v.error("there are not 3 numbers");
  const Eigen::Vector3d direction(v[0], v[1], v[2]);
  if (direction.isZero(0.0)) throw v.error("it has no direction");
  return direction;
}

}  // namespace

void add_world_up_option(CLI::App& command, const std::string& name,
                         std::optional<Eigen::Vector3d>& up, const std::string& description) {
  command.add_option_function<std::string>(
      name, [&up, name](const std::string& text) { up = parse_direction(name, text); },
      description);
}

void add_gravity_options(CLI::App& command, TableGravity& gravity) {
  add_world_up_option(command, "--world-up", gravity.world_up,
                      "x,y,z: which way is up in the tables' world; graphs then know which way is "
                      "down, as an accelerometer would tell");
  command
      .add_option("--gravity-noise", gravity.noise,
                  "Of that direction: its standard deviation, degrees")
      ->check(number_within(0.0, 45.0))
      ->capture_default_str();
}

}  // namespace program
