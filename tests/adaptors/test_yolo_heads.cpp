// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include <topobag/adaptors/yolo_heads.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const std::vector<ClassId> classes{ClassId{5}, ClassId{9}};
constexpr std::size_t columns = 7;  // cx, cy, w, h, objectness, two scores

/// An input of side 32 has grids of 4 × 4, 2 × 2 and 1 × 1 cells.
struct Output {
  std::vector<float> numbers = std::vector<float>(21 * columns, 0.0F);

  float* row(std::size_t i) { return numbers.data() + i * columns; }
  std::vector<Detection> decode() const {
    return decode_yolox({numbers.data(), 21, columns}, classes, 32, 0.1);
  }
};

}  // namespace

TEST_CASE("YOLOX cells of every stride decode to hand-computed boxes", "[adaptors]") {
  Output output;
  const float first[] = {0.5F, 0.25F, std::log(2.0F), 0.0F, 0.8F, 0.1F, 0.5F};
  std::copy(std::begin(first), std::end(first), output.row(6));  // stride 8, column 2, row 1
  const float second[] = {0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.9F, 0.1F};
  std::copy(std::begin(second), std::end(second),
            output.row(16 + 2));                                    // stride 16, column 0, row 1
  std::copy(std::begin(second), std::end(second), output.row(20));  // stride 32
  const std::vector<Detection> found = output.decode();
  REQUIRE(found.size() == 3);
  CHECK(found[0].box.center().isApprox(Eigen::Vector2d(20.0, 10.0), 1e-6));
  CHECK(found[0].box.width() == Approx(16.0));
  CHECK(found[0].box.height() == Approx(8.0));
  CHECK(found[0].label == ClassId{9});
  CHECK(found[0].confidence == Approx(0.4));
  CHECK(found[1].box.center() == Eigen::Vector2d(0.0, 16.0));
  CHECK(found[1].box.width() == Approx(16.0));
  CHECK(found[1].label == ClassId{5});
  CHECK(found[2].box.width() == Approx(32.0));
}

TEST_CASE("weak and broken YOLOX cells are left out", "[adaptors]") {
  Output output;
  output.row(0)[4] = 0.3F;
  output.row(0)[5] = 0.3F;  // 0.09
  output.row(1)[2] = 1000.0F;
  output.row(1)[4] = output.row(1)[5] = 1.0F;  // of infinite width
  output.row(2)[4] = std::numeric_limits<float>::quiet_NaN();
  output.row(2)[5] = 1.0F;
  CHECK(output.decode().empty());
}

TEST_CASE("a network of another shape is refused", "[adaptors]") {
  const Output output;
  CHECK_THROWS_AS(decode_yolox({output.numbers.data(), 20, columns}, classes, 32, 0.1),
                  InvalidValue);
  CHECK_THROWS_AS(decode_yolox({output.numbers.data(), 21, columns}, {ClassId{1}}, 32, 0.1),
                  InvalidValue);
}

TEST_CASE("YOLOv5 rows and YOLOv8 columns give the same boxes", "[adaptors]") {
  // cx, cy, w, h, objectness, scores; the second is too weak, the third is not a number.
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> rows{20, 10, 8,     4,  1,   0.2F, 0.5F, 5, 5,    2, 2,
                                1,  0,  0.05F, 30, nan, 8,    4,    1, 0.9F, 0};
  const auto five = decode_yolov5({rows.data(), 3, columns}, classes, 0.1);
  std::vector<float> turned;
  for (const std::size_t column : {0U, 1U, 2U, 3U, 5U, 6U}) {
    for (std::size_t row = 0; row < 3; ++row) turned.push_back(rows[row * columns + column]);
  }
  const auto eight = decode_yolov8({turned.data(), 6, 3}, classes, 0.1);
  for (const auto& found : {five, eight}) {
    REQUIRE(found.size() == 1);
    CHECK(found[0].box.center() == Eigen::Vector2d(20.0, 10.0));
    CHECK(found[0].box.width() == 8.0);
    CHECK(found[0].box.height() == 4.0);
    CHECK(found[0].label == ClassId{9});
    CHECK(found[0].confidence == Approx(0.5));
  }
  CHECK_THROWS_AS(decode_yolov5({rows.data(), 3, columns}, {ClassId{1}}, 0.1), InvalidValue);
  CHECK_THROWS_AS(decode_yolov8({turned.data(), 3, 6}, classes, 0.1), InvalidValue);
}

TEST_CASE("scores that are no probabilities are refused", "[adaptors]") {
  const auto five = [](float objectness, float score) {
    const float row[] = {20, 10, 8, 4, objectness, score, score - 0.5F};
    return decode_yolov5({row, 1, columns}, classes, 0.1);
  };
  CHECK(five(1.0005F, 0.5F).at(0).confidence <= 1.0);  // rounding
  CHECK_THROWS_AS(five(95.2F, 0.5F), InvalidValue);    // percent
  CHECK_THROWS_AS(five(1.0F, 1.2F), InvalidValue);
  CHECK_THROWS_AS(five(-6.0F, -7.0F), InvalidValue);  // logits, whose product is 42
  const float logits[] = {20, 10, 8, 4, -7, -8};
  CHECK_THROWS_AS(decode_yolov8({logits, 6, 1}, classes, 0.1), InvalidValue);
}

TEST_CASE("boxes as shares of the input are refused", "[adaptors]") {
  const float shares[] = {0.5F, 0.4F, 0.2F, 0.1F, 0.9F, 0.1F};
  CHECK_THROWS_AS(decode_yolov8({shares, 6, 1}, classes, 0.1), InvalidValue);
  const float weak[] = {0.5F, 0.4F, 0.2F, 0.1F, 0.05F, 0.01F};
  CHECK(decode_yolov8({weak, 6, 1}, classes, 0.1).empty());
}

TEST_CASE("a network without classes is refused, whatever its columns", "[adaptors][regression]") {
  const std::vector<float> numbers(21 * 5, 0.5F);
  CHECK_THROWS_AS(decode_yolox({numbers.data(), 21, 5}, {}, 32, 0.1), InvalidValue);
  CHECK_THROWS_AS(decode_yolov5({numbers.data(), 21, 5}, {}, 0.1), InvalidValue);
  CHECK_THROWS_AS(decode_yolov8({numbers.data(), 4, 21}, {}, 0.1), InvalidValue);
}
