// SPDX-License-Identifier: MIT
#include "report/score_image.hpp"

#include "catch.hpp"
#include "report/html_text.hpp"

using program::Json;
using program::Outcome;
using program::ScoreImage;

TEST_CASE("a small matrix keeps every pair", "[examples][report]") {
  ScoreImage image(2, 3);
  image.add(0, 1, 0.25);
  image.add(1, 2, 0.75);
  image.mark_true(1, 2);
  image.mark_answer(1, 2, Outcome::correct);
  image.hint(1, 2, "here");
  const Json drawn = image.figure({"m", "M", "score", {5, 6}, {7, 8, 9}}).drawn;
  CHECK(drawn.at("block") == 1);
  CHECK(drawn.at("rows") == 2);
  CHECK(drawn.at("columns") == 3);
  CHECK(drawn.at("low") == 0.25);
  CHECK(drawn.at("high") == 0.75);
  CHECK(drawn.at("flags") == program::base64(std::string("\0\0\0\0\0\3", 6)));
  CHECK(drawn.at("hints").at("5") == "here");
}

TEST_CASE("a large matrix shows the best of each block", "[examples][report]") {
  ScoreImage image(10, 7, 4);
  REQUIRE(image.block() == 3);
  for (std::size_t row = 0; row < 10; ++row) {
    for (std::size_t column = 0; column < 7; ++column) {
      image.add(row, column, -static_cast<double>(row + column));
    }
  }
  image.mark_true(9, 6);
  image.hint(0, 0, "not told");
  const Json drawn = image.figure({"m", "M", "score"}).drawn;
  CHECK(drawn.at("rows") == 4);
  CHECK(drawn.at("columns") == 3);
  CHECK(drawn.at("high") == 0.0);
  CHECK(drawn.at("low") == -15.0);  // of the last block, which is the pair (9, 6)
  CHECK(drawn.at("hints").empty());
  CHECK(drawn.at("flags") == program::base64(std::string("\0\0\0\0\0\0\0\0\0\0\0\1", 12)));
}

TEST_CASE("a matrix without a score is drawn all the same", "[examples][report]") {
  const Json drawn = ScoreImage(2, 2).figure({"m", "M", "score"}).drawn;
  CHECK(drawn.at("low") == 0.0);
  CHECK(drawn.at("high") == 0.0);
}
