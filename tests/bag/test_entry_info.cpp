// SPDX-License-Identifier: MIT
#include <limits>

#include <topobag/bag/entry_info.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("an entry's numbers have to be finite", "[bag]") {
  EntryInfo info;
  CHECK_NOTHROW(info.validate());
  info.stamp = 1.5;
  info.T_world_camera = Eigen::Isometry3d::Identity();
  CHECK_NOTHROW(info.validate());
  info.stamp = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(info.validate(), InvalidValue);
  info.stamp = 1.5;
  info.T_world_camera->translation().y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(info.validate(), InvalidValue);
}
