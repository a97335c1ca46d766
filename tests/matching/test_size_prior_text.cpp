// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <locale>
#include <random>
#include <string>

#include <topobag/matching/size_prior_text.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

SizePrior drawn_size_prior(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  SizePrior prior;
  prior.deviation = unit(random) + 1e-9;
  prior.outliers = unit(random);
  prior.spread = {{unit(random), unit(random)}, {unit(random), 1e-300 * unit(random)}};
  for (std::uint32_t i = 0; i < seed; ++i) {
    prior.classes[static_cast<ClassId>(random() % 1000)] = {{unit(random), unit(random)},
                                                            {unit(random), 0.0}};
  }
  return prior;
}

const std::string two_classes =
    "topobag size prior 1\n"
    "deviation 0.15\n"
    "outliers 0.1\n"
    "spread 0.14 0.14 0.2 0.25\n"
    "classes 2\n"
    "-3 0.1 0.2 0.3 0.4\n"
    "56 0 0 0.5 0.5\n"
    "end\n";

/// How `two_classes` with one thing replaced is refused.
std::string size_prior_refusal(const std::string& from, const std::string& to) {
  std::string text = two_classes;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
  CHECK_THROWS_AS(parse_size_prior(text), FormatError);
  return error_text([&] { parse_size_prior(text); });
}

struct CommaDecimals : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

}  // namespace

TEST_CASE("what sizes say comes back from its text to the last bit, in any locale", "[matching]") {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    const SizePrior was = drawn_size_prior(seed);
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaDecimals));
    const std::string text = to_string(was);
    const SizePrior is = parse_size_prior(text);
    std::locale::global(before);
    CHECK(is.deviation == was.deviation);
    CHECK(is.outliers == was.outliers);
    CHECK(is.spread.within == was.spread.within);
    CHECK(is.spread.between == was.spread.between);
    REQUIRE(is.classes.size() == was.classes.size());
    for (const auto& [label, spread] : was.classes) {
      CHECK(is.of(label).within == spread.within);
      CHECK(is.of(label).between == spread.between);
    }
    CHECK(to_string(is) == text);
  }
}

TEST_CASE("the text of sizes is read as written by hand", "[matching]") {
  const SizePrior prior = parse_size_prior(two_classes);
  CHECK(prior.of(ClassId{56}).within[0] == 0.0);
  CHECK(prior.of(ClassId{56}).between[1] == 0.5);
  CHECK(prior.of(ClassId{-3}).within[1] == 0.2);
  CHECK(prior.of(ClassId{4}).between[1] == 0.25);
  CHECK(to_string(prior) == two_classes);
}

TEST_CASE("a text of sizes that is cut off anywhere is refused", "[matching]") {
  for (std::size_t size = 0; size < two_classes.size(); ++size) {
    CAPTURE(size);
    CHECK_THROWS_AS(parse_size_prior(two_classes.substr(0, size)), FormatError);
  }
}

TEST_CASE("sizes out of their range are refused with the line and a sentence", "[matching]") {
  CHECK(size_prior_refusal("prior 1", "prior 2").find("later than this library's") !=
        std::string::npos);
  CHECK(size_prior_refusal("0.15", "0") ==
        "size prior, line 2: the deviation is no number above 0.");
  CHECK(size_prior_refusal("0.15", "inf") ==
        "size prior, line 2: the deviation is no number above 0.");
  CHECK(size_prior_refusal("outliers 0.1", "outliers 1.1") ==
        "size prior, line 3: the share of outliers is not in [0, 1].");
  CHECK(size_prior_refusal("outliers 0.1", "outliers nan") ==
        "size prior, line 3: the share of outliers is not in [0, 1].");
  CHECK(size_prior_refusal("0.14 0.14", "-0.14 0.14") ==
        "size prior, line 4: a deviation is no number from 0 on.");
  CHECK(size_prior_refusal("0.4", "0.4 1") == "size prior, line 6: a spread has four numbers.");
  CHECK(size_prior_refusal("0.3 0.4", "0.3") ==
        "size prior, line 6: '' is not a number that fits here.");
  CHECK(size_prior_refusal("56", "-3") == "size prior, line 7: class -3 is there already.");
  CHECK(size_prior_refusal("classes 2", "classes 1") == "size prior, line 7: 'end' is missing.");
  CHECK(size_prior_refusal("end\n", "end\n\n") ==
        "size prior, line 9: something stands behind the end.");
}
