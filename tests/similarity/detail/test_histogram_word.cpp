// SPDX-License-Identifier: MIT
#include <cstdint>
#include <set>

#include <topobag/similarity/detail/histogram_word.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("words of different sequences differ", "[similarity]") {
  std::set<std::uint64_t> words;
  std::size_t sequences = 0;
  for (int a = -2; a < 40; ++a) {
    words.insert(detail::histogram_word(ClassId{a}));
    ++sequences;
    for (int b = -2; b < 40; ++b) {
      words.insert(detail::histogram_word(ClassId{a}, ClassId{b}));
      ++sequences;
      for (std::uint64_t bin = 0; bin < 20; ++bin) {
        words.insert(detail::histogram_word(ClassId{a}, ClassId{b}, bin));
        ++sequences;
      }
    }
  }
  CHECK(words.size() == sequences);
}

TEST_CASE("words are the same on every machine", "[similarity]") {
  // SplitMix64's first output from the state 0, Vigna's reference.
  STATIC_REQUIRE(detail::scatter(0) == 0xE220A8397B1DCDAFU);
}
