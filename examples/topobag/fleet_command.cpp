// SPDX-License-Identifier: MIT
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "commands.hpp"
#include "fleet_map.hpp"
#include "number_check.hpp"
#include "object_classes.hpp"
#include "saved_map.hpp"

namespace program {
namespace {

struct FleetArguments {
  std::string address;
  std::string map, role;
  std::optional<int> seconds;
  ObjectClasses classes;
};

using Arguments = std::shared_ptr<FleetArguments>;

CLI::App& add_part(CLI::App& fleet, const Arguments& arguments, const std::string& name,
                   const std::string& description) {
  CLI::App& part = *fleet.add_subcommand(name, description);
  part.add_option(
          "address", arguments->address,
          "postgresql://HOST/BASE?site=NAME; more sites by another site=, a robot by robot=")
      ->required();
  return part;
}

/// Runs `act` with the address that was given.
template <typename Act>
void on_address(CLI::App& part, const Arguments& arguments, const Act& act) {
  part.callback([arguments, act] { act(*arguments, parse_fleet_address(arguments->address)); });
}

}  // namespace

void add_fleet_command(CLI::App& app) {
  CLI::App& fleet = *app.add_subcommand(
      "fleet", "Shares the maps of many robots through PostgreSQL servers, one for each site");
  fleet.require_subcommand(1);
  const auto arguments = std::make_shared<FleetArguments>();

  CLI::App& init = add_part(fleet, arguments, "init", "Prepares a data base and makes sites in it");
  add_classes_option(init, arguments->classes);
  on_address(init, arguments, [](const FleetArguments& given, const FleetAddress& address) {
    prepare_fleet(address, given.classes);
    std::cout << "prepared\n";
  });

  CLI::App& admit = add_part(fleet, arguments, "admit",
                             "Lets a role read the sites, and write there as robot=UUID");
  admit.add_option("--role", arguments->role, "Role of the server")->required();
  on_address(admit, arguments, [](const FleetArguments& given, const FleetAddress& address) {
    admit_to_fleet(address, given.role);
    std::cout << given.role << " admitted\n";
  });

  CLI::App& push = add_part(fleet, arguments, "push", "Sends what the server lacks of a map");
  push.add_option("--map", arguments->map, "SQLite map")->required();
  on_address(push, arguments, [](const FleetArguments& given, const FleetAddress& address) {
    require_sqlite_map(given.map);
    std::cout << push_to_fleet(address, given.map) << " versions of " << given.map << " added\n";
  });

  CLI::App& follow = add_part(fleet, arguments, "follow",
                              "Keeps the sites' key frames in memory "
                              "and tells how many there are");
  follow.add_option("--seconds", arguments->seconds, "For so long, s [for ever]")
      ->check(whole_number_from(0));
  add_classes_option(follow, arguments->classes);
  on_address(follow, arguments, [](const FleetArguments& given, const FleetAddress& address) {
    std::optional<std::chrono::seconds> time;
    if (given.seconds) time = std::chrono::seconds(*given.seconds);
    follow_fleet(address, given.classes, time,
                 {[](const std::string& text) { std::cout << text << std::endl; },
                  [](const std::string& text) { std::cerr << "topobag: " << text << std::endl; }});
  });

  CLI::App& status = add_part(fleet, arguments, "status", "Says what a server holds");
  on_address(status, arguments, [](const FleetArguments&, const FleetAddress& address) {
    for (const SiteFigures& site : fleet_status(address)) {
      std::cout << site.name << ": " << site.versions << " versions of " << site.robots
                << " robots\n";
    }
  });
}

}  // namespace program
