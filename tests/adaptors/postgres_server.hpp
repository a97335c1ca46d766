// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <libpq-fe.h>

#include "scratch_folder.hpp"

/// A throw-away PostgreSQL of the test's own: a folder that goes with it, a socket in that folder,
/// no port, no root. It ends when the test does, however that ends.
class PostgresServer {
 public:
  /// Whether there is one to be run; says in one line when there is not.
  static bool is_installed() {
    const bool found = !binary("postgres").empty();
    if (!found) std::puts("skipped: no PostgreSQL server is installed (Debian: postgresql)");
    return found;
  }

  explicit PostgresServer(std::vector<std::string> settings = {}) : settings_(std::move(settings)) {
    std::filesystem::permissions(folder_.path(), std::filesystem::perms(0711));
    std::filesystem::create_directory(data());
    give(data());
    const ::pid_t initdb = run({binary("initdb"), "-D", data(), "-U", "owner", "-A", "trust", "-N",
                                "-E", "UTF8", "--locale", "C"});
    int status = 0;
    ::waitpid(initdb, &status, 0);
    if (status != 0) throw std::runtime_error("initdb failed in " + data());
    start();
  }
  ~PostgresServer() {
    if (process_ > 0) crash();
  }
  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;

  void start() {
    std::vector<std::string> words{binary("postgres"), "-D", data(), "-k", data()};
    for (const char* setting : {"listen_addresses=", "fsync=off", "shared_buffers=16MB",
                                "max_connections=60", "log_min_messages=fatal"}) {
      words.insert(words.end(), {"-c", setting});
    }
    for (const std::string& setting : settings_) words.insert(words.end(), {"-c", setting});
    process_ = run(words);
    for (int i = 0; i < 3000; ++i) {
      if (PQping(conninfo().c_str()) == PQPING_OK) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    throw std::runtime_error("the server does not answer in " + data());
  }

  /// An immediate shutdown: no checkpoint, connections cut, recovery at the next start.
  void crash() {
    ::kill(process_, SIGQUIT);
    ::waitpid(process_, nullptr, 0);
    process_ = -1;
  }

  /// Makes a file the server's own.
  static void give(const std::string& path) {
    const ::passwd* user = server_user();
    if (user != nullptr && ::chown(path.c_str(), user->pw_uid, user->pw_gid) != 0) {
      throw std::runtime_error("chown " + path);
    }
  }

  /// What the server has worked till now, s: itself, and those of its connections that have ended.
  double processor_seconds() const {
    std::ifstream file("/proc/" + std::to_string(process_) + "/stat");
    std::string text;
    std::getline(file, text);
    std::istringstream fields(text.substr(text.rfind(')') + 2));
    const std::vector<std::string> words{std::istream_iterator<std::string>(fields), {}};
    double ticks = 0.0;
    for (std::size_t i = 11; i < 15; ++i) ticks += std::stod(words.at(i));  // proc(5): utime on
    return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }

  /// The folder of its data and its socket.
  std::string data() const { return folder_.path("data"); }
  std::string conninfo(const std::string& user = "owner", const std::string& base = "postgres") const {
    return "host=" + data() + " user=" + user + " dbname=" + base;
  }

  /// A data base of its own, empty.
  std::string new_base(const std::string& user = "owner") {
    const std::string base = "base" + std::to_string(bases_++);
    sql("CREATE DATABASE " + base);
    return conninfo(user, base);
  }

  /// Runs SQL as the owner; the first field of its answer.
  std::string sql(const std::string& text, const std::string& where = {}) const {
    ::PGconn* connection = PQconnectdb((where.empty() ? conninfo() : where).c_str());
    ::PGresult* result = PQexec(connection, text.c_str());
    const std::string said = PQresultErrorMessage(result);
    const std::string value = PQntuples(result) > 0 ? PQgetvalue(result, 0, 0) : "";
    PQclear(result);
    PQfinish(connection);
    if (!said.empty()) throw std::runtime_error(said);
    return value;
  }

 private:
  static std::string binary(const std::string& name) {
    for (const char* version : {"18", "17", "16", "15"}) {
      const std::string path = "/usr/lib/postgresql/" + std::string(version) + "/bin/" + name;
      if (::access(path.c_str(), X_OK) == 0) return path;
    }
    return {};
  }

  /// PostgreSQL refuses to run as root.
  static const ::passwd* server_user() { return ::geteuid() == 0 ? ::getpwnam("nobody") : nullptr; }

  static ::pid_t run(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const ::passwd* user = server_user();
    const ::pid_t process = ::fork();
    if (process != 0) return process;
    if (user != nullptr && (::setgid(user->pw_gid) != 0 || ::setuid(user->pw_uid) != 0)) ::_exit(1);
    ::prctl(PR_SET_PDEATHSIG, SIGQUIT);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, 1);
    ::dup2(nowhere, 2);
    if (::chdir("/") == 0) ::execv(arguments[0], arguments.data());
    ::_exit(1);
  }

  ScratchFolder folder_;
  std::vector<std::string> settings_;
  ::pid_t process_ = -1;
  int bases_ = 0;
};

/// One for all tests that leave it as it is: each makes a data base of its own.
inline PostgresServer& shared_postgres() {
  static PostgresServer server;
  return server;
}
