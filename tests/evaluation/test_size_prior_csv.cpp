// SPDX-License-Identifier: MIT
#include <cmath>
#include <sstream>
#include <string>

#include <topobag/error.hpp>
#include <topobag/evaluation/size_prior_csv.hpp>

#include "../error_text.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

SizePrior sizes_from(const std::string& text) {
  std::istringstream in(text);
  return read_size_prior(in, "sizes.csv");
}

}  // namespace

TEST_CASE("what was learnt of sizes reads back as the same numbers", "[evaluation]") {
  SizePrior prior;
  prior.deviation = 0.2;
  prior.classes[ClassId{56}] = {{0.1 / 3.0, 0.33}, {1e-7, 0.0}};
  prior.classes[ClassId{-2}] = {};
  std::ostringstream out;
  write_size_prior(out, prior);
  std::istringstream in(out.str());
  const SizePrior read = read_size_prior(in, "sizes.csv", prior);
  REQUIRE(read.classes.size() == 2);
  for (const auto& [label, spread] : prior.classes) {
    CHECK(read.classes.at(label).within == spread.within);
    CHECK(read.classes.at(label).between == spread.between);
  }
  CHECK(read.deviation == prior.deviation);
  CHECK(out.precision() == 6);
}

TEST_CASE("a table of sizes needs no heading, and may have comments", "[evaluation]") {
  const SizePrior read = sizes_from("# chairs\n56 .1 .2 .3 .4\r\n");
  CHECK(read.of(ClassId{56}).between[1] == 0.4);
}

TEST_CASE("what is no table of sizes is refused with file and line", "[evaluation]") {
  const auto said = [](const std::string& text) { return error_text([&] { sizes_from(text); }); };
  CHECK(said("class_id,a\n56,.1,.2,.3\n").find("sizes.csv:2: a line has five numbers") == 0);
  CHECK(said("chair,.1,.2,.3,.4\n").find("'chair' is no number of a class") != std::string::npos);
  CHECK(said("56,.1,.2,.3,-.4\n").find("not negative") != std::string::npos);
  CHECK(said("56,.1,.2,.3,inf\n").find("finite") != std::string::npos);
  CHECK(said("56,.1,.2,.3,x\n").find("'x' is not a number") != std::string::npos);
  CHECK(said("1,0,0,0,0\n1,0,0,0,0\n").find("class 1 comes twice") != std::string::npos);
}
