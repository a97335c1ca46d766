// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "catch.hpp"
#include "scratch.hpp"

/// How a run of the program ended and what it said.
struct ProgramRun {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs the built program; `arguments` as in a shell.
inline ProgramRun run_program(const std::string& arguments) {
  const ScratchFolder folder;
  const std::string command = std::string("'") + TOPOBAG_PROGRAM + "' " + arguments + " >'" +
                              folder.path("out") + "' 2>'" + folder.path("err") + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, program::read_file(folder.path("out")),
          program::read_file(folder.path("err"))};
}

/// Exit code 2, nothing on stdout and one line on stderr, which is returned without "topobag: ".
inline std::string refusal(const std::string& arguments) {
  CAPTURE(arguments);
  const ProgramRun run = run_program(arguments);
  CHECK(run.exit_code == 2);
  CHECK(run.out.empty());
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  REQUIRE(run.err.find("topobag: ") == 0);
  return run.err.substr(9, run.err.size() - 10);
}
