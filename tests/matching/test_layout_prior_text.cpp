// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

#include <topobag/matching/layout_prior_text.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

const std::string one_layout = [] {
  LayoutPrior prior;
  DistanceCounts level{}, spatial{};
  level[2] = 1.5;
  spatial[3] = 0.25;
  prior.add(ClassId{56}, ClassId{-3}, level, spatial);
  return to_string(prior);
}();

/// How `one_layout` with one thing replaced is refused.
std::string layout_refusal(const std::string& from, const std::string& to) {
  std::string text = one_layout;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
  CHECK_THROWS_AS(parse_layout_prior(text), FormatError);
  return error_text([&] { parse_layout_prior(text); });
}

}  // namespace

TEST_CASE("what layouts say comes back from its text", "[matching]") {
  std::mt19937 random(23);
  std::exponential_distribution<double> count(1.0);
  for (int round = 0; round < 20; ++round) {
    LayoutPrior was;
    was.even = 0.01 + 0.04 * round;
    for (int i = 0; i < round; ++i) {
      DistanceCounts level{}, spatial{};
      for (double& n : level) n = count(random);
      for (double& n : spatial) n = count(random);
      was.add(ClassId{static_cast<int>(random() % 9)}, ClassId{static_cast<int>(random() % 9)},
              level, spatial);
    }
    const LayoutPrior is = parse_layout_prior(to_string(was));
    CHECK(to_string(is) == to_string(was));
    CHECK(is.density(ClassId{1}, ClassId{2}, 0.7, 2.0, true) ==
          Approx(was.density(ClassId{1}, ClassId{2}, 0.7, 2.0, true)));
  }
}

TEST_CASE("a text of layouts that is not right is refused with its line", "[matching]") {
  CHECK(layout_refusal("topobag", "topobug") == "layout prior, line 1: this is no layout prior.");
  CHECK(layout_refusal("even 0.5", "even 0") ==
        "layout prior, line 2: the share of what stands anywhere is not in (0, 1].");
  CHECK(layout_refusal("pooled 3", "pooled -3") ==
        "layout prior, line 3: the number of pooled places is no number above 0.");
  CHECK(layout_refusal("-3 56", "-3 56 7") == "layout prior, line 5: a pair has two classes.");
  CHECK(layout_refusal("1.5", "-1.5") == "layout prior, line 6: a count is no number from 0 on.");
  CHECK(layout_refusal(" 0.25", "") == "layout prior, line 7: '' is not a number that fits here.");
  CHECK(layout_refusal("0.25", "0.25 0.25") ==
        "layout prior, line 7: there are more counts than distances.");
  CHECK(layout_refusal("end", "ends") == "layout prior, line 8: 'end' is missing.");
  for (std::size_t length = 0; length < one_layout.size(); ++length) {
    CHECK_THROWS_AS(parse_layout_prior(one_layout.substr(0, length)), FormatError);
  }
}
