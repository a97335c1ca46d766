// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <topobag/types/stamp.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

TEST_CASE("a stamp is a time in seconds, and another unit is named", "[types]") {
  for (const double stamp : {0.0, -5.0, 1305031102.175304, 4e9, largest_stamp}) {
    CHECK_NOTHROW(require_seconds(stamp));
  }
  const auto complaint = [](double stamp) { return error_text([&] { require_seconds(stamp); }); };
  CHECK(complaint(1305031102175.0) ==
        "the time stamp 1305031102175.000000 is no time in seconds; is it in milliseconds? divide "
        "by 1e3");
  CHECK(complaint(1305031102175304.0).find("microseconds? divide by 1e6") != std::string::npos);
  CHECK(complaint(1305031102175304000.0).find("nanoseconds? divide by 1e9") != std::string::npos);
  CHECK(complaint(std::nan("")) == "the time stamp is not finite");
}
