// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "run_program.hpp"

/// A data base of its own on the tests' server, and its address for the program.
class FleetBase {
 public:
  FleetBase() : conninfo_(shared_postgres().new_base()) {}

  /// Quoted for the shell.
  std::string address(const std::string& settings = {}, const std::string& user = "owner") const {
    return "'" + plain_address(settings, user) + "'";
  }
  std::string plain_address(const std::string& settings = {},
                            const std::string& user = "owner") const {
    const std::string base = conninfo_.substr(conninfo_.find("dbname=") + 7);
    return "postgresql://" + user + "@/" + base + "?host=" + shared_postgres().data() +
           (settings.empty() ? "" : "&" + settings);
  }
  /// How errors of its server begin.
  std::string name() const {
    return "PostgreSQL at " + shared_postgres().data() + ", port 5432, data base " +
           conninfo_.substr(conninfo_.find("dbname=") + 7) + ": ";
  }
  std::string sql(const std::string& text) const { return shared_postgres().sql(text, conninfo_); }

 private:
  std::string conninfo_;
};

/// What a command says that does what it was asked for.
inline std::string fleet_output(const std::string& arguments) {
  const ProgramRun run = run_program(arguments);
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty());
  return run.out;
}
