// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/types/descriptor_kind.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

TEST_CASE("a kind goes by its name and its length", "[types]") {
  using Kind = DescriptorKind<300>;
  CHECK(Kind("a", 3) == Kind("a", 3));
  CHECK(Kind("a", 3) != Kind("b", 3));
  CHECK(Kind("a", 3) != Kind("a", 4));
  CHECK(Kind("a", 3) == Kind(Kind("a", 7).number(), 3));
  CHECK(Kind("a", 3).number() == DescriptorKind<64>("a", 3).number());
  CHECK(Kind("a", 300).length() == 300);  // more than a byte holds
  CHECK(Kind().length() == 0);
  for (const std::size_t length : {std::size_t{0}, std::size_t{301}}) {
    CHECK(error_text([&] { Kind("a", length); }) ==
          "a descriptor of " + std::to_string(length) + " numbers; it holds 1 to 300");
  }
}

TEST_CASE("a byte of a quantised direction is off by half a step at most", "[types]") {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 100; ++round) {
    Eigen::VectorXd vector(1 + round);
    for (auto& number : vector) number = 1e6 * normal(random);
    std::vector<std::int8_t> bytes(static_cast<std::size_t>(vector.size()));
    detail::quantize(vector, bytes.size(), bytes.data());
    const double greatest = vector.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < vector.size(); ++i) {
      const double step = 127.0 * vector[i] / greatest;
      CHECK(std::abs(bytes[static_cast<std::size_t>(i)] - step) <= 0.5);
    }
  }
}

TEST_CASE("what is no direction is refused, or stays zeros", "[types]") {
  std::vector<std::int8_t> bytes(2, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(detail::quantize(Eigen::Vector2d(1.0, nan), 2, bytes.data()), InvalidValue);
  CHECK_THROWS_AS(detail::quantize(Eigen::Vector3d::Ones(), 2, bytes.data()), InvalidValue);
  detail::quantize(Eigen::Vector2d::Zero(), 2, bytes.data());
  CHECK(bytes == std::vector<std::int8_t>{0, 0});
}
