// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "scratch_folder.hpp"

/// A certificate authority of the test's own, of OpenSSL's program, for some days.
class TlsAuthority {
 public:
  /// Whether there is what makes one; says in one line when there is not.
  static bool is_possible() {
    const bool found = std::system("openssl version > /dev/null 2>&1") == 0;
    if (!found) std::puts("skipped: openssl is not installed, so there is no TLS to be tested");
    return found;
  }

  TlsAuthority() {
    make("req -x509 -days 7 -subj /CN=authority" + new_key("authority") + " -out authority.crt");
  }

  /// What a client trusts.
  std::string certificate() const { return folder_.path("authority.crt"); }

  /// Writes `server.key` and `server.crt` into a folder: the server of that name.
  void certify(const std::string& name, const std::string& folder) const {
    std::ofstream(folder_.path("names")) << "subjectAltName = DNS:" << name << '\n';
    make("req -subj /CN=" + name + new_key("server") + " -out request");
    make(
        "x509 -req -days 7 -CA authority.crt -CAkey authority.key -CAcreateserial -extfile names"
        " -in request -out '" +
        folder + "/server.crt'");
    std::filesystem::copy(folder_.path("server.key"), folder + "/server.key");
  }

 private:
  static std::string new_key(const std::string& name) {
    return " -nodes -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -keyout " + name + ".key";
  }

  void make(const std::string& words) const {
    const std::string command = "cd '" + folder_.path() + "' && openssl " + words + " 2> said";
    if (std::system(command.c_str()) == 0) return;
    throw std::runtime_error("openssl " + words + ": " + content_of(folder_.path("said")));
  }

  ScratchFolder folder_;
};
