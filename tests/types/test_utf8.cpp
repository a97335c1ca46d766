// SPDX-License-Identifier: MIT
#include <string>

#include <topobag/types/utf8.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

TEST_CASE("UTF-8 of one to four bytes is told from everything else", "[types]") {
  for (const std::string good :
       {"", "flat",
        "K\xC3\xBC"
        "che",
        "\xE2\x82\xAC", "\xED\x9F\xBF", "\xEE\x80\x80", "\xF0\x9F\x8F\xA0", "\xF4\x8F\xBF\xBF"}) {
    CAPTURE(good);
    CHECK(is_utf8(good));
  }
  for (const std::string bad :
       {"K\xFC"
        "che",
        "\x80", "\xC3", "\xC3(", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xE2\x82", "\xED\xA0\x80",
        "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
    CAPTURE(bad);
    CHECK_FALSE(is_utf8(bad));
  }
  CHECK(is_utf8(std::string("a\0b", 3)));
  CHECK(error_text([] { require_utf8("\xFC", "the session's name"); }) ==
        "the session's name is not UTF-8");
}
