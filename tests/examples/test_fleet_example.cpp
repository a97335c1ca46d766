// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "scratch.hpp"

TEST_CASE("the fleet's example runs, and everybody knows at its end what it should",
          "[examples][fleet][long]") {
  if (!PostgresServer::is_installed()) return;
  const ScratchFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0711));  // the server's user
  const std::string said = folder.path("said");
  const std::string command =
      "TOPOBAG_PROGRAM='" TOPOBAG_PROGRAM "' PGPORT=" + std::to_string(20000 + ::getpid() % 20000) +
      " bash " TOPOBAG_SOURCES "/examples/fleet/run.sh '" + folder.path("run") + "' >'" + said +
      "' 2>&1";
  const int status = std::system(command.c_str());
  const std::string text = content_of(said);
  CAPTURE(text);
  CHECK(status == 0);
  for (const char* line : {"hall: 122 versions of 2 robots", "yard: 62 versions of 1 robots",
                           "robot2: 60 key frames of its own",
                           "  follower: 184 key frames of 3 sessions", "  wrong           0 "}) {
    CHECK(text.find(line) != std::string::npos);
  }
}
