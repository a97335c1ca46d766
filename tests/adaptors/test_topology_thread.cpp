// SPDX-License-Identifier: MIT
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <topobag/adaptors/topology_thread.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// Work that stands still until it is let go: a slow detector without a clock.
class Gate {
 public:
  void pass() {
    std::unique_lock<std::mutex> lock(mutex_);
    ++at_the_gate_;
    changed_.notify_all();
    changed_.wait(lock, [this] { return open_; });
  }
  void wait_for_someone() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return at_the_gate_ > 0; });
  }
  void open() {
    const std::lock_guard<std::mutex> lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int at_the_gate_ = 0;
  bool open_ = false;
};

/// Notes what was worked on and what was lost; the first piece of work waits at the gate.
struct Notes {
  Gate gate;
  std::mutex mutex;
  std::vector<int> worked;
  std::vector<std::pair<int, std::string>> lost;

  TopologyThread<int>::Work work() {
    return [this](const int& input) {
      if (input == 0) gate.pass();
      if (input < 0) throw std::runtime_error("detector " + std::to_string(input));
      const std::lock_guard<std::mutex> lock(mutex);
      worked.push_back(input);
    };
  }
  TopologyThread<int>::OnLost on_lost() {
    return [this](const int& input, const std::string& why) {
      const std::lock_guard<std::mutex> lock(mutex);
      lost.emplace_back(input, why);
    };
  }
};

using Lost = std::vector<std::pair<int, std::string>>;

}  // namespace

TEST_CASE("key frames are worked on in the order they came", "[adaptors]") {
  Notes notes;
  notes.gate.open();
  TopologyThread<int> thread(notes.work(), {100, WhenFull::refuse});
  for (int i = 0; i < 100; ++i) CHECK(thread.push(i));
  thread.wait_idle();
  std::vector<int> expected(100);
  for (int i = 0; i < 100; ++i) expected[static_cast<std::size_t>(i)] = i;
  CHECK(notes.worked == expected);
}

TEST_CASE("a detector that throws does not end the thread", "[adaptors]") {
  Notes notes;
  TopologyThread<int> thread(notes.work(), {}, notes.on_lost());
  for (const int input : {1, -5, 2}) thread.push(input);
  thread.wait_idle();
  CHECK(notes.worked == std::vector<int>{1, 2});
  CHECK(notes.lost == Lost{{-5, "detector -5"}});
  CHECK(thread.counts().failed == 1);
  CHECK(thread.counts().processed == 2);

  TopologyThread<int> odd([](const int&) { throw 7; });
  odd.push(1);
  odd.wait_idle();
  CHECK(odd.counts().failed == 1);
}

TEST_CASE("behind a slow detector the oldest is given up, and said so", "[adaptors]") {
  Notes notes;
  TopologyThread<int> thread(notes.work(), {2, WhenFull::drop_oldest}, notes.on_lost());
  thread.push(0);
  notes.gate.wait_for_someone();
  for (const int input : {1, 2, 3, 4}) CHECK(thread.push(input));
  notes.gate.open();
  thread.wait_idle();
  CHECK(notes.worked == std::vector<int>{0, 3, 4});
  CHECK(notes.lost == Lost{{1, "the queue is full"}, {2, "the queue is full"}});
  CHECK(thread.counts().pushed == 5);
  CHECK(thread.counts().given_up == 2);
}

TEST_CASE("behind a slow detector new ones are refused where that is wanted", "[adaptors]") {
  Notes notes;
  TopologyThread<int> thread(notes.work(), {1, WhenFull::refuse}, notes.on_lost());
  thread.push(0);
  notes.gate.wait_for_someone();
  CHECK(thread.push(1));
  CHECK_FALSE(thread.push(2));
  notes.gate.open();
  thread.wait_idle();
  CHECK(notes.worked == std::vector<int>{0, 1});
  CHECK(notes.lost == Lost{{2, "the queue is full"}});
}

TEST_CASE("where waiting is wanted, nothing is lost", "[adaptors]") {
  Notes notes;
  TopologyThread<int> thread(notes.work(), {1, WhenFull::wait}, notes.on_lost());
  thread.push(0);
  notes.gate.wait_for_someone();
  std::thread tracking([&] {
    for (int i = 1; i < 50; ++i) thread.push(i);
  });
  notes.gate.open();
  tracking.join();
  thread.wait_idle();
  CHECK(notes.worked.size() == 50);
  CHECK(notes.lost.empty());
}

TEST_CASE("a reset forgets what waits and waits for what is at work", "[adaptors]") {
  Notes notes;
  TopologyThread<int> thread(notes.work(), {}, notes.on_lost());
  thread.push(0);
  notes.gate.wait_for_someone();
  thread.push(1);
  std::thread detector([&] {
    while (thread.counts().given_up == 0) std::this_thread::yield();
    notes.gate.open();
  });
  thread.reset();
  CHECK(notes.worked == std::vector<int>{0});
  CHECK(notes.lost == Lost{{1, "the map was reset"}});
  detector.join();
  thread.push(2);
  thread.wait_idle();
  CHECK(notes.worked == std::vector<int>{0, 2});
}

TEST_CASE("whoever waits for an idle thread is told when its queue is forgotten", "[adaptors]") {
  // It takes a reset or stop between a push and the thread's waking: some of the rounds hit that.
  for (int round = 0; round < 1000; ++round) {
    TopologyThread<int> thread([](const int&) {});
    std::atomic<bool> waits{false}, told{false};
    std::thread waiting([&] {
      waits = true;
      for (int i = 0; i < 20; ++i) thread.wait_idle();
      told = true;
    });
    while (!waits) std::this_thread::yield();
    thread.push(1);
    round % 2 == 0 ? thread.reset() : thread.stop();
    waiting.join();
    CHECK(told);
  }
}

TEST_CASE("after a stop nothing is taken, and what waited is told", "[adaptors]") {
  Notes notes;
  TopologyThread<int> thread(notes.work(), {}, notes.on_lost());
  thread.push(0);
  notes.gate.wait_for_someone();
  thread.push(1);
  std::thread stopping([&] { thread.stop(); });
  while (thread.counts().given_up == 0) std::this_thread::yield();
  notes.gate.open();
  stopping.join();
  thread.stop();
  CHECK_FALSE(thread.push(2));
  CHECK(notes.worked == std::vector<int>{0});
  CHECK(notes.lost == Lost{{1, "the thread has stopped"}, {2, "the thread has stopped"}});
}

TEST_CASE("a queue without room is refused", "[adaptors]") {
  CHECK_THROWS_AS(TopologyThread<int>([](const int&) {}, {0, WhenFull::wait}), InvalidValue);
}

TEST_CASE("tracking, reset and stop race", "[adaptors]") {
  std::atomic<int> worked{0};
  for (int round = 0; round < 20; ++round) {
    TopologyThread<int> thread([&](const int&) { ++worked; },
                               {2, round % 2 == 0 ? WhenFull::wait : WhenFull::drop_oldest});
    std::thread tracking([&] {
      for (int i = 0; i < 200; ++i) thread.push(i);
    });
    std::thread resetting([&] {
      for (int i = 0; i < 20; ++i) thread.reset();
      if (round % 4 == 3) thread.stop();
    });
    tracking.join();
    resetting.join();
    thread.stop();
    const TopologyThreadCounts counts = thread.counts();
    CHECK(counts.pushed == counts.processed + counts.failed + counts.given_up);
    CHECK(counts.pushed == 200);
  }
  CHECK(worked > 0);
}
