// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "run_program.hpp"
#include "warehouse_files.hpp"

/// Without SQLite a snapshot is all there is.
#ifdef TOPOBAG_HAS_SQLITE
inline const std::vector<std::string> own_maps = {"own.db", "own.bag"};
#else
inline const std::vector<std::string> own_maps = {"own.bag"};
#endif

/// The file of the warehouse's classes, and two drives through the same hall.
struct OwnClasses {
  ScratchFolder folder;
  std::string file = folder.write("classes.txt", warehouse_classes);
  std::string option = " --classes " + file;
  std::string options = warehouse_camera + option + ' ';
  program::ObjectClasses classes = program::read_object_classes(file);
  WarehouseFiles first{classes, 1, 0.0}, second{classes, 1, 0.07};
};

inline nlohmann::json own_json(const std::string& arguments) {
  const ProgramRun run = run_program(arguments + "--json");
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  return nlohmann::json::parse(run.out);
}
