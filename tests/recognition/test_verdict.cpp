// SPDX-License-Identifier: MIT
#include <set>
#include <string>

#include <topobag/recognition/verdict.hpp>

#include "catch.hpp"

using topobag::Verdict;

TEST_CASE("every verdict has words of its own", "[recognition]") {
  std::set<std::string> words;
  for (const Verdict verdict : {Verdict::no_agreement, Verdict::degenerate, Verdict::insignificant,
                                Verdict::ambiguous, Verdict::not_best, Verdict::accepted}) {
    CHECK(topobag::to_string(verdict) != std::string());
    words.insert(topobag::to_string(verdict));
  }
  CHECK(words.size() == 6);
  CHECK(topobag::to_string(Verdict::accepted) == std::string("accepted"));
}
