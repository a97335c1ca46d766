// SPDX-License-Identifier: MIT
#include <functional>

#include <topobag/bag/entry_filter.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("each test of a filter lets in what it says", "[bag]") {
  EntryInfo info;
  info.stamp = 10.0;
  info.session = 3;
  info.label = "kitchen";
  info.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(1.0, 2.0, 3.0));
  const auto passes = [&](const std::function<void(EntryFilter&)>& set) {
    EntryFilter filter;
    set(filter);
    CHECK(filter.restricts());
    return filter.contains(KeyframeId{5}, info);
  };
  CHECK_FALSE(EntryFilter{}.restricts());
  CHECK(EntryFilter{}.contains(KeyframeId{5}, {}));
  CHECK(passes([](EntryFilter& f) { f.min_id = KeyframeId{5}; }));
  CHECK_FALSE(passes([](EntryFilter& f) { f.min_id = KeyframeId{6}; }));
  CHECK(passes([](EntryFilter& f) { f.max_id = KeyframeId{5}; }));
  CHECK_FALSE(passes([](EntryFilter& f) { f.max_id = KeyframeId{4}; }));
  CHECK(passes([](EntryFilter& f) { f.min_stamp = 10.0; }));
  CHECK_FALSE(passes([](EntryFilter& f) { f.min_stamp = 10.5; }));
  CHECK(passes([](EntryFilter& f) { f.max_stamp = 10.0; }));
  CHECK_FALSE(passes([](EntryFilter& f) { f.max_stamp = 9.5; }));
  CHECK(passes([](EntryFilter& f) { f.sessions = {1, 3}; }));
  CHECK_FALSE(passes([](EntryFilter& f) { f.sessions = {1, 2}; }));
  CHECK(passes([](EntryFilter& f) { f.labels = {"hall", "kitchen"}; }));
  CHECK_FALSE(passes([](EntryFilter& f) { f.labels = {"hall"}; }));
  CHECK(passes([](EntryFilter& f) { f.not_of = PresentVisit{3, 10.0}; }));
  CHECK_FALSE(passes([](EntryFilter& f) { f.not_of = PresentVisit{3, 9.5}; }));
  CHECK(passes([](EntryFilter& f) { f.not_of = PresentVisit{2, -1e300}; }));
  CHECK(passes([](EntryFilter& f) { f.region = MapRegion{{1.0, 2.0, 0.0}, 3.0}; }));
  CHECK_FALSE(passes([](EntryFilter& f) { f.region = MapRegion{{1.0, 2.0, 0.0}, 2.9}; }));
}

TEST_CASE("a filter by time or place leaves out what has none", "[bag]") {
  EntryFilter since, until, near;
  since.min_stamp = -1e300;
  until.max_stamp = 1e300;
  near.region = MapRegion{{0.0, 0.0, 0.0}, 1e300};
  for (const EntryFilter& filter : {since, until, near}) {
    CHECK_FALSE(filter.contains(KeyframeId{5}, {}));
  }
}

TEST_CASE("what has no time belongs to the visit of its session", "[bag]") {
  EntryFilter earlier;
  earlier.not_of = PresentVisit{0, 1e300};
  EntryInfo info;
  CHECK_FALSE(earlier.contains(KeyframeId{5}, info));
  info.session = 1;
  CHECK(earlier.contains(KeyframeId{5}, info));
}
