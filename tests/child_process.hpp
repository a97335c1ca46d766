// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

/// A process that runs `work(tell)` beside the test and may be killed at any moment; `tell(number)`
/// reports a number to the test.
class ChildProcess {
 public:
  template <typename Work>
  explicit ChildProcess(const Work& work) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ < 0) throw std::runtime_error("no process");
    if (process_ == 0) {
      ::close(ends[0]);
      int status = 0;
      try {
        work([&](std::uint64_t number) {
          if (::write(ends[1], &number, sizeof number) != sizeof number) ::_exit(3);
        });
      } catch (...) {
        status = 4;
      }
      ::_exit(status);  // neither the test's output nor its destructors a second time
    }
    ::close(ends[1]);
    pipe_ = ends[0];
  }

  ~ChildProcess() {
    if (process_ > 0) kill();
    ::close(pipe_);
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  void kill() {
    ::kill(process_, SIGKILL);
    wait();
  }

  /// Whether it came to its end without an exception or a signal.
  bool wait() {
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  /// The next number it told; nothing after the last one of a process that ended.
  std::optional<std::uint64_t> told() {
    std::uint64_t number = 0;
    if (::read(pipe_, &number, sizeof number) != sizeof number) return std::nullopt;
    return number;
  }

 private:
  ::pid_t process_ = -1;
  int pipe_ = -1;
};

/// The text that `call` returns, run in a process of its own.
template <typename Call>
std::string text_from_child(const Call& call) {
  ChildProcess child([&](const auto& tell) {
    for (const char letter : std::string(call())) tell(static_cast<unsigned char>(letter));
  });
  std::string text;
  while (const auto letter = child.told()) text += static_cast<char>(*letter);
  return child.wait() ? text : "the process failed";
}
