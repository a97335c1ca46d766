// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include "catch.hpp"
#include "child_process.hpp"
#include "scratch_folder.hpp"

namespace {

/// Takes one of three steps, which last so long, with stderr going to a file or a terminal.
bool step_with_stderr_to(int file, std::chrono::milliseconds length) {
  ChildProcess child([&](const auto&) {
    ::dup2(file, STDERR_FILENO);
    program::Progress progress(3, "steps");
    std::this_thread::sleep_for(length);
    progress.step();
  });
  return child.wait();
}

/// What a terminal is told.
std::string shown_on_terminal(std::chrono::milliseconds length) {
  const int screen = ::posix_openpt(O_RDWR | O_NOCTTY);
  REQUIRE(screen >= 0);
  REQUIRE(::grantpt(screen) == 0);
  REQUIRE(::unlockpt(screen) == 0);
  const int terminal = ::open(::ptsname(screen), O_RDWR | O_NOCTTY);
  REQUIRE(terminal >= 0);
  CHECK(step_with_stderr_to(terminal, length));
  ::fcntl(screen, F_SETFL, O_NONBLOCK);
  char text[256];
  const auto read = ::read(screen, text, sizeof text);
  ::close(terminal);
  ::close(screen);
  return read > 0 ? std::string(text, static_cast<std::size_t>(read)) : "";
}

}  // namespace

TEST_CASE("long work tells a terminal how far it has come, short work nothing", "[examples]") {
  CHECK(shown_on_terminal(std::chrono::milliseconds(150)).find("1 of 3 steps") !=
        std::string::npos);
  CHECK(shown_on_terminal(std::chrono::milliseconds(0)).find("steps") == std::string::npos);
}

TEST_CASE("long work of many parts tells which part it is at", "[examples][regression]") {
  const auto told = [] { return shown_on_terminal(std::chrono::milliseconds(150)); };
  {
    const program::ProgressPart part("method", 3, 17);
    CHECK(told().find("\rmethod 3 of 17: 1 of 3 steps") != std::string::npos);
    {
      const program::ProgressPart inner("run", 1, 2);
      CHECK(told().find("\rmethod 3 of 17: run 1 of 2: 1 of 3 steps") != std::string::npos);
    }
    CHECK(told().find("\rmethod 3 of 17: 1 of 3 steps") != std::string::npos);
  }
  CHECK(told().find("\r1 of 3 steps") != std::string::npos);
}

TEST_CASE("what is no terminal is told nothing that was not asked for", "[examples]") {
  const ScratchFolder folder;
  const int file = ::open(folder.path("err").c_str(), O_CREAT | O_WRONLY, 0600);
  CHECK(step_with_stderr_to(file, std::chrono::milliseconds(150)));
  ::close(file);
  CHECK(content_of(folder.path("err")).empty());
}
