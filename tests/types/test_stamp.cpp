// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

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

TEST_CASE("the middle step is that of the sorted steps", "[types]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> wait(0.0, 10.0);
  const auto itself = [](double stamp) { return stamp; };
  CHECK_FALSE(middle_step(std::vector<double>{}, itself));
  CHECK_FALSE(middle_step(std::vector<double>{5.0}, itself));
  for (int count = 2; count < 40; ++count) {
    std::vector<double> stamps{1e3}, steps;
    while (static_cast<int>(stamps.size()) < count) {
      stamps.push_back(stamps.back() + wait(random));
      steps.push_back(stamps.back() - stamps[stamps.size() - 2]);
    }
    std::sort(steps.begin(), steps.end());
    CHECK(middle_step(stamps, itself) == steps[steps.size() / 2]);
  }
}

TEST_CASE("a recording's stamps are seconds, wherever they count from", "[types]") {
  const auto complaint = [](double first, double step) {
    std::vector<double> stamps;
    for (int i = 0; i < 60; ++i) stamps.push_back(first + i * step);
    return error_text([&] { require_recording(stamps, [](double stamp) { return stamp; }); });
  };
  for (const double first : {0.0, 1305031102.175304}) {
    for (const double seconds : {1e-3, 1.0 / 30.0, 33.3, 3600.0}) {
      CHECK(complaint(first, seconds) == "nothing was thrown");
    }
    for (const double frames_a_second : {5.0, 30.0, 100.0}) {
      CAPTURE(first, frames_a_second);
      CHECK(complaint(first, 1e6 / frames_a_second)
                .find("longer than any recording waits; are they in microseconds? divide by 1e6") !=
            std::string::npos);
      CHECK(complaint(first, 1e9 / frames_a_second).find("in nanoseconds? divide by 1e9") !=
            std::string::npos);
    }
  }
}

TEST_CASE("one stamp of another clock is told by how far the recording reaches", "[types]") {
  std::vector<double> stamps{0.0};
  for (int i = 0; i < 60; ++i) stamps.push_back(1305031102.0 + i / 30.0);
  const auto itself = [](double stamp) { return stamp; };
  CHECK(error_text([&] {
          require_recording(stamps, itself);
        }).find("the time stamps reach from 0.000000 to 1305031103.9") == 0);
  stamps.erase(stamps.begin());
  CHECK_NOTHROW(require_recording(stamps, itself));
}
