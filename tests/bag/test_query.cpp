// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <vector>

#include <topobag/bag/query.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

EntryInfo at(double stamp) {
  EntryInfo info;
  info.stamp = stamp;
  return info;
}

}  // namespace

TEST_CASE("neighbours by id are those less than the gap away, on either side", "[bag]") {
  ExcludedNeighbors exclude;
  CHECK_FALSE(exclude.contains(KeyframeId{5}, {}));  // nothing is asked for
  exclude.id = KeyframeId{5};
  CHECK(exclude.contains(KeyframeId{5}, {}));  // by default the query itself
  CHECK_FALSE(exclude.contains(KeyframeId{4}, {}));
  exclude.min_id_gap = 3;
  for (std::uint64_t id = 0; id < 12; ++id) {
    CHECK(exclude.contains(KeyframeId{id}, {}) == (id >= 3 && id <= 7));
  }
  exclude.min_id_gap = 0;
  CHECK_FALSE(exclude.contains(KeyframeId{5}, {}));
}

TEST_CASE("ids at both ends of their range are far apart", "[bag]") {
  ExcludedNeighbors exclude;
  exclude.id = KeyframeId{0};
  exclude.min_id_gap = 10;
  CHECK_FALSE(exclude.contains(KeyframeId{std::numeric_limits<std::uint64_t>::max()}, {}));
}

TEST_CASE("neighbours by time are those less than the gap apart, and those without a stamp",
          "[bag]") {
  ExcludedNeighbors exclude;
  exclude.stamp = 100.0;
  exclude.min_time_gap = 20.0;
  CHECK(exclude.contains(KeyframeId{1}, {}));
  CHECK(exclude.contains(KeyframeId{1}, at(100.0)));
  CHECK(exclude.contains(KeyframeId{1}, at(80.5)));
  CHECK_FALSE(exclude.contains(KeyframeId{1}, at(80.0)));
  CHECK(exclude.contains(KeyframeId{1}, at(119.5)));
  CHECK_FALSE(exclude.contains(KeyframeId{1}, at(120.0)));
  exclude.session = 1;  // at() is of session 0, which has a clock of its own
  CHECK_FALSE(exclude.contains(KeyframeId{1}, at(100.0)));
  exclude.session = 0;
  CHECK(exclude.contains(KeyframeId{1}, at(100.0)));
}

TEST_CASE("either rule excludes", "[bag]") {
  ExcludedNeighbors exclude;
  exclude.id = KeyframeId{1};
  exclude.stamp = 0.0;
  exclude.min_time_gap = 5.0;
  CHECK(exclude.contains(KeyframeId{1}, at(50.0)));
  CHECK(exclude.contains(KeyframeId{2}, at(1.0)));
  CHECK_FALSE(exclude.contains(KeyframeId{2}, at(50.0)));
}

TEST_CASE("candidates are in order of falling score, ties by id", "[bag]") {
  std::vector<Candidate> candidates{
      {KeyframeId{3}, 0.5}, {KeyframeId{1}, 0.5}, {KeyframeId{9}, 0.7}, {KeyframeId{2}, 0.1}};
  std::sort(candidates.begin(), candidates.end());
  CHECK(candidates == std::vector<Candidate>{{KeyframeId{9}, 0.7},
                                             {KeyframeId{1}, 0.5},
                                             {KeyframeId{3}, 0.5},
                                             {KeyframeId{2}, 0.1}});
}
