// SPDX-License-Identifier: MIT
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <topobag/adaptors/orb_slam/call_guard.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a guarded call says nothing where it throws, and that is counted", "[adaptors]") {
  CallGuard guard;
  CHECK(guard([] { return std::string("fine"); }) == "fine");
  CHECK(guard.failures().first == 0);
  CHECK(guard([]() -> std::string { throw std::runtime_error("no map"); }).empty());
  CHECK(guard.failures().second == "no map");
  CHECK(guard([]() -> int { throw 7; }) == 0);
  guard([]() -> bool { throw std::logic_error("last"); });
  CHECK(guard.failures().first == 3);
  CHECK(guard.failures().second == "last");
}

TEST_CASE("failures of several threads are all counted", "[adaptors]") {
  CallGuard guard;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int call = 0; call < 500; ++call)
        guard([]() -> bool { throw std::runtime_error("no"); });
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(guard.failures().first == 2000);
}

TEST_CASE("all are called, whatever one throws, and the first error comes out", "[adaptors]") {
  std::set<int> called;
  const auto call = [&](int each) {
    called.insert(each);
    if (each > 2) throw std::runtime_error(std::to_string(each));
  };
  CHECK_THROWS_WITH(detail::call_for_all(std::vector<int>{1, 3, 2, 4}, call), "3");
  CHECK(called == std::set<int>{1, 2, 3, 4});
  CHECK_NOTHROW(detail::call_for_all(std::vector<int>{1, 2}, call));
}
