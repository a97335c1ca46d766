// SPDX-License-Identifier: MIT
#pragma once

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "scratch_folder.hpp"

/// The link between a client and a server, in a test's hands: after so many bytes of the server's
/// it is cut, falls silent, or says something else.
class PostgresProxy {
 public:
  enum class Fault { cut, silence, garbage };
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

  /// @param server  folder of the server's socket
  explicit PostgresProxy(const std::string& server) : server_(server + "/.s.PGSQL.5432") {
    std::filesystem::permissions(folder_.path(), std::filesystem::perms(0711));
    const std::string path = folder_.path(".s.PGSQL.5432");
    ear_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    const ::sockaddr_un address = address_of(path);
    ::bind(ear_, reinterpret_cast<const ::sockaddr*>(&address), sizeof address);
    ::chmod(path.c_str(), 0777);
    ::listen(ear_, 16);
    thread_ = std::thread([this] { run(); });
  }
  ~PostgresProxy() {
    stop_ = true;
    thread_.join();
    ::close(ear_);
  }

  /// To be named as the host.
  std::string folder() const { return folder_.path(); }

  /// From now on, each connection has the fault after so many bytes; those that are there at once.
  void set(Fault fault, std::size_t after) {
    fault_ = fault;
    after_ = after;
  }

 private:
  struct Link {
    int client, server;
    std::size_t passed = 0;
    bool dead = false;
  };

  static ::sockaddr_un address_of(const std::string& path) {
    ::sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    return address;
  }

  void run() {
    std::vector<Link> links;
    while (!stop_) {
      std::vector<::pollfd> sockets{{ear_, POLLIN, 0}};
      for (const Link& link : links) {
        sockets.push_back({link.client, POLLIN, 0});
        sockets.push_back({link.server, POLLIN, 0});
      }
      ::poll(sockets.data(), sockets.size(), 5);
      for (std::size_t i = 0; i < links.size(); ++i) {
        if (sockets[1 + 2 * i].revents != 0) from_client(links[i]);
        if (sockets[2 + 2 * i].revents != 0) from_server(links[i]);
        if (fault_ == Fault::cut && links[i].passed >= after_) links[i].dead = true;
      }
      for (const Link& link : links) {
        if (link.dead) close(link);
      }
      links.erase(std::remove_if(links.begin(), links.end(), [](auto& link) { return link.dead; }),
                  links.end());
      if ((sockets[0].revents & POLLIN) != 0) accept(links);
    }
    for (const Link& link : links) close(link);
  }

  static void close(const Link& link) {
    ::close(link.client);
    ::close(link.server);
  }

  void accept(std::vector<Link>& links) const {
    Link link{::accept(ear_, nullptr, nullptr), ::socket(AF_UNIX, SOCK_STREAM, 0)};
    const ::sockaddr_un address = address_of(server_);
    link.dead = ::connect(link.server, reinterpret_cast<const ::sockaddr*>(&address),
                          sizeof address) != 0;
    links.push_back(link);
  }

  static void from_client(Link& link) {
    char bytes[65536];
    const ::ssize_t size = ::read(link.client, bytes, sizeof bytes);
    link.dead = link.dead || size <= 0 || ::send(link.server, bytes, static_cast<std::size_t>(size), MSG_NOSIGNAL) != size;
  }

  void from_server(Link& link) const {
    char bytes[65536];
    const ::ssize_t size = ::read(link.server, bytes, sizeof bytes);
    if (size <= 0) {
      link.dead = true;
      return;
    }
    const auto count = static_cast<std::size_t>(size);
    const std::size_t sound = std::min(count, after_ - std::min(after_.load(), link.passed));
    link.passed += count;
    if (fault_ == Fault::garbage) {
      for (std::size_t i = sound; i < count; ++i) bytes[i] = static_cast<char>(bytes[i] * 7 + 91);
    }
    const std::size_t passed_on = fault_ == Fault::garbage ? count : sound;
    if (::send(link.client, bytes, passed_on, MSG_NOSIGNAL) < 0) link.dead = true;
  }

  ScratchFolder folder_;
  std::string server_;
  std::atomic<Fault> fault_{Fault::cut};
  std::atomic<std::size_t> after_{never};
  std::atomic<bool> stop_{false};
  int ear_ = -1;
  std::thread thread_;
};
