// SPDX-License-Identifier: MIT
#include <algorithm>

#include "catch.hpp"
#include "desk_of_objects.hpp"
#include "object_alignment.hpp"

using namespace program;

TEST_CASE("a planted alignment is proposed first, with its scale", "[examples]") {
  for (const double scale : {0.85, 1.0, 1.2}) {
    CAPTURE(scale);
    const auto query = strewn_objects(20, 3);
    auto map = mapped_elsewhere(query, some_motion(), scale, 0.005, 4);
    for (const Eigen::Vector3d& other : strewn_objects(20, 5)) {  // that no query has
      map.push_back(scale * (some_motion() * other));
    }
    const auto found = propose_alignments(map, query);
    REQUIRE_FALSE(found.empty());
    CHECK(found.front().objects == query.size());
    CHECK(found.front().scale == Approx(scale).epsilon(0.05));
    const Eigen::Isometry3d off = found.front().T_map_query.inverse() * some_motion();
    CHECK(off.translation().norm() < 0.1);
    CHECK(Eigen::AngleAxisd(off.linear()).angle() < 0.1);
  }
}

TEST_CASE("proposals count what coincides, most first", "[examples]") {
  const auto query = strewn_objects(10, 1);
  const auto map = strewn_objects(12, 2);
  AlignmentSearch search;
  search.kept = 5;
  const auto found = propose_alignments(map, query, search);
  REQUIRE(found.size() == 5);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const ScaledMotion& motion = found[i];
    if (i > 0) CHECK(motion.objects <= found[i - 1].objects);
    CHECK(motion.scale <= 1.1 * search.max_scale);
    CHECK(motion.T_map_query.linear().determinant() == Approx(1.0));
    std::size_t near = 0;
    for (const auto& object : query) {
      const Eigen::Vector3d at = motion.T_map_query * object;
      double nearest = 1e9;
      for (const auto& there : map) nearest = std::min(nearest, (there / motion.scale - at).norm());
      if (nearest <= search.tolerance) ++near;
    }
    CHECK(near == motion.objects);
  }
  CHECK(propose_alignments({}, query).empty());
  CHECK(propose_alignments(map, {query[0], query[1]}).empty());
}
