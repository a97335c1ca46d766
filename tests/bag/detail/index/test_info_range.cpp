// SPDX-License-Identifier: MIT
#include <topobag/bag/detail/index/info_range.hpp>

#include <random>
#include <utility>
#include <vector>

#include "catch.hpp"

using namespace topobag;

namespace {

std::uint32_t below(std::mt19937& random, std::uint32_t n) {
  return static_cast<std::uint32_t>(random()) % n;
}

using Entry = std::pair<KeyframeId, EntryInfo>;

Entry random_entry(std::mt19937& random) {
  Entry entry{KeyframeId{below(random, 10)}, {}};
  if (below(random, 4) != 0) entry.second.stamp = static_cast<double>(below(random, 10));
  entry.second.session = below(random, 10);
  if (below(random, 4) != 0) {
    auto& T = entry.second.T_world_camera.emplace(Eigen::Isometry3d::Identity());
    for (int k = 0; k < 3; ++k) T.translation()[k] = static_cast<double>(below(random, 10));
  }
  return entry;
}

EntryFilter random_filter(std::mt19937& random) {
  EntryFilter filter;
  const auto number = [&] { return static_cast<double>(below(random, 12)) - 1.0; };
  switch (below(random, 6)) {
    case 0:
      filter.min_id = KeyframeId{below(random, 12)};
      break;
    case 1:
      filter.max_id = KeyframeId{below(random, 12)};
      break;
    case 2:
      filter.min_stamp = number();
      break;
    case 3:
      filter.max_stamp = number();
      break;
    case 4:
      filter.not_of = PresentVisit{below(random, 10), number()};
      break;
    default:
      filter.region = MapRegion{{number(), number(), number()}, number() / 3.0};
  }
  if (below(random, 3) == 0) filter.sessions = {below(random, 12), below(random, 12)};
  return filter;
}

}  // namespace

TEST_CASE("a range rules out only what holds no entry that passes", "[bag][index]") {
  std::mt19937 random(1);
  int ruled_out = 0, passed = 0;
  for (int round = 0; round < 20000; ++round) {
    std::vector<Entry> entries(below(random, 4));
    detail::InfoRange range;
    for (Entry& entry : entries) {
      entry = random_entry(random);
      range.extend(entry.first, entry.second);
    }
    const EntryFilter filter = random_filter(random);
    bool any = false;
    for (const auto& [id, info] : entries) {
      any = any || filter.contains(id, info);
      REQUIRE(range.may_contain(id));
    }
    if (any) REQUIRE(range.may_pass(filter));
    passed += any ? 1 : 0;
    ruled_out += range.may_pass(filter) ? 0 : 1;
    if (entries.empty()) CHECK_FALSE(range.may_contain(KeyframeId{below(random, 10)}));
  }
  CHECK(passed > 2000);
  CHECK(ruled_out > 6000);
}

TEST_CASE("one entry's range says what its filter says", "[bag][index]") {
  std::mt19937 random(2);
  for (int round = 0; round < 5000; ++round) {
    const auto [id, info] = random_entry(random);
    detail::InfoRange range;
    range.extend(id, info);
    const EntryFilter filter = random_filter(random);
    REQUIRE(range.may_pass(filter) == filter.contains(id, info));
  }
}
