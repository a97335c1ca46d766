// SPDX-License-Identifier: MIT
#include "table_lock.hpp"

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "catch.hpp"
#include "child_process.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

namespace {

std::string table_lock_complaint(const std::string& set) {
  return error_text([&] { const program::TableLock lock(set); });
}

}  // namespace

TEST_CASE("one run at a time makes a table", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string set = folder.path("set");
  const std::string held =
      "--out " + set +
      ": another run is making this table; wait until it is done, or give another name";
  {
    const program::TableLock lock(set);
    CHECK(table_lock_complaint(set) == held);
    CHECK(table_lock_complaint(folder.path("other")) == "nothing was thrown");
  }
  CHECK(std::filesystem::is_empty(folder.path()));
  ChildProcess run([&](const auto& tell) {
    const program::TableLock lock(set);
    tell(1);
    ::pause();
  });
  REQUIRE(run.told() == 1U);
  CHECK(table_lock_complaint(set) == held);
  run.kill();
  CHECK(table_lock_complaint(set) == "nothing was thrown");
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a table is not made where nothing can be", "[examples]") {
  const ScratchFolder folder;
  CHECK(table_lock_complaint(folder.path("no/set")) ==
        folder.path("no/set") + ".partial.lock: it cannot be written: No such file or directory");
}

TEST_CASE("of many runs for one table exactly one makes it", "[examples]") {
  const ScratchFolder folder;
  const std::string set = folder.path("set");
  // Each adds its turn to a count that only who holds the table may touch.
  folder.write("count", "0");
  const auto turns = [&](const auto& tell) {
    std::uint64_t done = 0;
    while (done < 25) {
      try {
        const program::TableLock lock(set);
        const int count = std::stoi(content_of(folder.path("count")));
        folder.write("count", std::to_string(count + 1));
        ++done;
      } catch (const topobag::Error&) {
      }
    }
    tell(done);
  };
  ChildProcess first(turns), second(turns), third(turns);
  CHECK(first.told() == 25U);
  CHECK(second.told() == 25U);
  CHECK(third.told() == 25U);
  CHECK(content_of(folder.path("count")) == "75");
}
