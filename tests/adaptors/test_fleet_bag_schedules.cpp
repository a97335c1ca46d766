// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/fleet_robots.hpp"
#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "long_rounds.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// Pushes whose transactions stay open: they commit after those that began later.
class LatePush {
 public:
  bool is_open() const { return open_; }
  void begin(const std::string& conninfo, const std::vector<FleetVersion>& versions) {
    try {
      connection_.value().run("BEGIN");
    } catch (const std::exception&) {  // there was none yet, or it has been cut
      connection_.emplace(conninfo, std::chrono::seconds(30));
      connection_->run("BEGIN");
    }
    connection_->run(detail::postgres_append, detail::row_parameters(versions));
    open_ = true;
  }
  /// The server or the connection may be gone: then it is rolled back.
  void end(bool commit) {
    if (!std::exchange(open_, false)) return;
    try {
      connection_->run(commit ? "COMMIT" : "ROLLBACK");
    } catch (const Error&) {
      connection_.reset();
    }
  }

 private:
  std::optional<detail::PostgresConnection> connection_;
  bool open_ = false;
};

/// Two sites, three robots, two followers, and what may happen to them.
class Schedule {
 public:
  Schedule(PostgresServer& server, const std::string& conninfo, unsigned seed)
      : server_(server), conninfo_(conninfo), random_(seed), store_(conninfo) {
    for (const char* name : {"hall ", "yard "}) {
      sites_.push_back(name + std::to_string(seed));
      store_.add_site(sites_.back(), 0);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t first_id = i == 1 ? 0xFFFFFFFC : 0;  // some go beyond 32 bits
      robots_.push_back(
          std::make_unique<SimulatedRobot>(folder_.path(), sites_[i % 2], first_id));
    }
    followers_.push_back(new_follower());
    followers_.push_back(twofold_follower());
    for (int i = 0; i < 4; ++i) graphs_.push_back(random_graph(random_, random_() % 7, 3));
  }

  void step(bool with_crash) {
    const std::size_t i = random_() % robots_.size();
    const auto event = random_() % 25;
    if (event < 8) return robots_[i]->add(random_, some_graph());
    if (event < 11) return robots_[i]->update(random_, some_graph());
    if (event < 13) return robots_[i]->erase(random_);
    if (event < 16) return send(i);
    if (event < 17) return begin_late(i);
    if (event < 19) return late_[i].end(random_() % 3 != 0);
    if (event < 22) return follow(*followers_[random_() % followers_.size()]);
    if (event < 23) return robots_[i]->restart();
    if (event < 24) {
      followers_.front() = new_follower();
    } else if (with_crash) {
      server_.crash();
      server_.start();
    } else {
      server_.sql("SELECT pg_terminate_backend(pid) FROM pg_stat_activity"
                  " WHERE pid <> pg_backend_pid() AND backend_type = 'client backend'");
    }
  }

  /// All is sent and followed, and every follower knows what one bag would.
  void finish() {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      late_[i].end(random_() % 2 == 0);
      push_all(i);
      REQUIRE(push(robots_[i]->outbox(), store_, 2) == 0);
    }
    FleetUnion all;
    for (const auto& robot : robots_) robot->tell(all);
    followers_.push_back(new_follower());
    for (auto& follower : followers_) {
      follow(*follower);
      follow(*follower);
      REQUIRE(follower->follow() == 0);
      REQUIRE(follower->refused().empty());
      require_union(*follower->view(), all, graphs_);
    }
  }

 private:
  std::unique_ptr<FleetBag> new_follower() const {
    return std::make_unique<FleetBag>(std::vector<FleetSource>{{conninfo_, sites_}});
  }
  /// Over two connections, which both have one of the sites.
  std::unique_ptr<FleetBag> twofold_follower() const {
    return std::make_unique<FleetBag>(
        std::vector<FleetSource>{{conninfo_, {sites_.back()}}, {conninfo_, sites_}});
  }
  const TopologyGraph<>& some_graph() { return graphs_[random_() % graphs_.size()]; }

  /// The connection may have been cut: the second attempt has a new one.
  void push_all(std::size_t i) {
    try {
      push(robots_[i]->outbox(), store_, 2);
    } catch (const Error&) {
      push(robots_[i]->outbox(), store_, 2);
    }
  }
  void send(std::size_t i) {
    if (late_[i].is_open()) return;  // it is about it
    push_all(i);
  }
  void follow(FleetBag& follower) {
    try {
      follower.follow();
    } catch (const Error&) {
      follower.follow();
    }
  }
  void begin_late(std::size_t i) {
    if (late_[i].is_open()) return;
    const FleetOutbox& outbox = robots_[i]->outbox();
    push_all(i);
    robots_[i]->add(random_, some_graph());
    late_[i].begin(conninfo_, outbox.after(outbox.last_seq() - 1, 10));
  }

  PostgresServer& server_;
  std::string conninfo_;
  std::mt19937 random_;
  ScratchFolder folder_;
  PostgresStore store_;
  std::vector<std::string> sites_;
  std::vector<std::unique_ptr<SimulatedRobot>> robots_;
  std::vector<std::unique_ptr<FleetBag>> followers_;
  std::vector<LatePush> late_{3};
  std::vector<TopologyGraph<>> graphs_;
};

void run_schedules(unsigned first, unsigned count) {
  PostgresServer server;
  std::string conninfo;
  for (unsigned seed = first; seed < first + count; ++seed) {
    if ((seed - first) % 50 == 0) {
      conninfo = server.new_base();
      PostgresStore(conninfo).prepare();
    }
    INFO("seed " << seed);
    Schedule schedule(server, conninfo, seed);
    for (int step = 0; step < 30; ++step) schedule.step(seed % 12 == 0);
    schedule.finish();
  }
}

}  // namespace

TEST_CASE("whatever happens, every follower answers as one bag over all maps would", "[fleet]") {
  if (PostgresServer::is_installed()) run_schedules(0, 6);
}

TEST_CASE("every follower answers as one bag, 500 schedules", "[fleet][long]") {
  if (PostgresServer::is_installed()) run_schedules(1000, long_rounds(500));
}
