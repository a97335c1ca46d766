// SPDX-License-Identifier: MIT
#include "score_names.hpp"

#include <string>
#include <vector>

#include "catch.hpp"
#include "error_text.hpp"

TEST_CASE("files of scores go by their names, or by their paths where two have one", "[examples]") {
  using Names = std::vector<std::string>;
  CHECK(program::score_names({}).empty());
  CHECK(program::score_names({"a/x.csv", "a/y.csv"}) == Names{"x.csv", "y.csv"});
  CHECK(program::score_names({"a/x.csv", "y.csv", "b/x.csv"}) ==
        Names{"a/x.csv", "y.csv", "b/x.csv"});
  CHECK(error_text([] {
          program::score_names({"x.csv", "./x.csv"});
        }) == "--scores ./x.csv: it is given twice; leave one out");
}
