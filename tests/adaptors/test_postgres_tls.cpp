// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/fleet_robots.hpp"
#include "adaptors/postgres_server.hpp"
#include "adaptors/tls_authority.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// Of the loopback net, for this process alone: so the server needs no port of its own.
std::string own_loopback() {
  const int number = static_cast<int>(::getpid());
  return "127.64." + std::to_string(number / 250 % 250) + "." + std::to_string(number % 250 + 1);
}

/// A server on the network, which takes nothing there that is not encrypted, and passwords.
class TlsServer {
 public:
  explicit TlsServer(const TlsAuthority& authority)
      : address_(own_loopback()), server_({"listen_addresses=" + address_}) {
    authority.certify("fleet.test", server_.data());
    for (const char* name : {"server.key", "server.crt"}) {
      const std::string path = server_.data() + "/" + name;
      server_.give(path);
      std::filesystem::permissions(path, std::filesystem::perms(0600));
    }
    std::ofstream(server_.data() + "/pg_hba.conf")
        << "local all owner trust\nhostssl all all 127.0.0.0/8 scram-sha-256\n";
    server_.sql("ALTER SYSTEM SET ssl = on");
    server_.crash();
    server_.start();
    base_ = server_.new_base();
    PostgresStore owner(base_);
    owner.prepare();
    owner.add_site("hall", 0);
    server_.sql("CREATE ROLE r2d2 LOGIN PASSWORD 'bleep'");
  }

  std::string sql(const std::string& text) const { return server_.sql(text, base_); }
  void admit(const Uuid& robot) const { PostgresStore(base_).admit("r2d2", "hall", robot); }

  /// As the robot says it, with more words.
  std::string conninfo(const std::string& words, const std::string& host = "fleet.test") const {
    return "host=" + host + " hostaddr=" + address_ +
           " user=r2d2 password=bleep dbname=" + base_.substr(base_.rfind('=') + 1) + " " + words;
  }

 private:
  std::string address_, base_;
  PostgresServer server_;
};

bool says(const std::string& text, const std::string& part) {
  INFO(text);
  CHECK(text.find("PostgreSQL at ") == 0);
  CHECK(text.find("bleep") == std::string::npos);
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a robot pushes through TLS to the server that it trusts, and to no other",
          "[postgres]") {
  if (!PostgresServer::is_installed() || !TlsAuthority::is_possible()) return;
  const TlsAuthority authority, stranger;
  const TlsServer server(authority);
  const ScratchFolder folder;
  std::mt19937 random(1);
  SimulatedRobot robot(folder.path(), "hall", 0);
  server.admit(robot.outbox().member().robot);
  const std::string trust = " sslrootcert=" + authority.certificate();
  const auto pushed = [&](const std::string& conninfo) {
    robot.add(random, random_graph(random, 5));
    return error_text([&] {
      PostgresStore store(conninfo);
      push(robot.outbox(), store);
    });
  };
  const auto rows = [&] { return server.sql("SELECT count(*) FROM topobag.version"); };

  // What must not be, while the server has nothing: each is a sentence, and changes nothing.
  const std::string distrust = " sslrootcert=" + stranger.certificate();
  for (const char* mode : {"sslmode=verify-full", "sslmode=verify-ca"}) {
    CHECK(says(pushed(server.conninfo(mode + distrust)), "certificate verify failed"));
  }
  CHECK(
      says(pushed(server.conninfo("sslmode=verify-full" + trust, "yard.test")), "does not match"));
  CHECK(says(pushed(server.conninfo("sslmode=disable")), "no encryption"));
  CHECK(says(pushed(server.conninfo("sslmode=verify-full sslrootcert=" + folder.path("none"))),
             "does not exist"));
  CHECK(says(pushed(server.conninfo("sslmode=verify-full password=guess" + trust)), "password"));
  CHECK(rows() == "0");
  FleetBag careful({{server.conninfo("sslmode=verify-full" + distrust), {"hall"}}});
  CHECK(says(error_text([&] { careful.follow(); }), "certificate verify failed"));
  CHECK(careful.size() == 0);

  // What must be.
  const std::string secure = server.conninfo("sslmode=verify-full" + trust);
  CHECK(pushed(secure) == "nothing was thrown");
  CHECK(rows() == std::to_string(robot.map().bag().size()));
  CHECK(pushed(server.conninfo("sslmode=verify-ca" + trust, "yard.test")) == "nothing was thrown");
  FleetBag fleet({{secure, {"hall"}}});
  CHECK(fleet.follow() == robot.map().bag().size());
  CHECK(server.sql("SELECT count(*) > 0 AND bool_and(ssl) FROM pg_stat_ssl JOIN pg_stat_activity"
                   " USING (pid) WHERE usename = 'r2d2'") == "t");
  FleetUnion all;
  robot.tell(all);
  require_union(*fleet.view(), all, {random_graph(random, 5)});
}
