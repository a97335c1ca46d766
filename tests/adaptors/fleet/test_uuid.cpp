// SPDX-License-Identifier: MIT
#include <string>

#include <topobag/adaptors/fleet/uuid.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a UUID is written and read", "[fleet]") {
  const std::string text = "123e4567-e89b-42d3-a456-426614174000";
  CHECK(to_text(parse_uuid(text)) == text);
  CHECK(parse_uuid("123E4567E89B42D3A456426614174000") == parse_uuid(text));
  const Uuid drawn = random_uuid();
  CHECK(parse_uuid(to_text(drawn)) == drawn);
  CHECK(random_uuid() != drawn);
  CHECK(to_text(drawn)[14] == '4');
}

TEST_CASE("what is no UUID is refused", "[fleet]") {
  for (const char* text : {"", "123e4567", "123e4567-e89b-42d3-a456-42661417400g",
                           "123e4567-e89b-42d3-a456-4266141740001"}) {
    CHECK_THROWS_AS(parse_uuid(text), InvalidValue);
  }
}
