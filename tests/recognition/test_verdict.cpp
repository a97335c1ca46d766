// SPDX-License-Identifier: MIT
#include <set>
#include <string>

#include <topobag/recognition/verdict.hpp>

#include "catch.hpp"

using topobag::is_verified;
using topobag::Verdict;

TEST_CASE("every verdict has words of its own", "[recognition]") {
  std::set<std::string> words;
  for (const Verdict verdict : {Verdict::no_agreement, Verdict::degenerate, Verdict::insignificant,
                                Verdict::ambiguous, Verdict::rivalled, Verdict::not_best,
                                Verdict::accepted}) {
    CHECK(topobag::to_string(verdict) != std::string());
    words.insert(topobag::to_string(verdict));
  }
  CHECK(words.size() == 7);
  CHECK(topobag::to_string(Verdict::accepted) == std::string("accepted"));
}

TEST_CASE("a match is verified that passed every stage, the best of all or not", "[recognition]") {
  CHECK(is_verified(Verdict::accepted));
  CHECK(is_verified(Verdict::not_best));
  for (const Verdict verdict : {Verdict::no_agreement, Verdict::degenerate, Verdict::insignificant,
                                Verdict::ambiguous, Verdict::rivalled}) {
    CHECK_FALSE(is_verified(verdict));
  }
}
