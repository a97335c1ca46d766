// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>

#include <topobag/types/appearance.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "random_appearance.hpp"

using namespace topobag;

TEST_CASE("a new appearance is unknown", "[types][appearance]") {
  CHECK_FALSE(Appearance{}.known());
  CHECK(Appearance{}.kind().length() == 0);
  CHECK(Appearance{} == Appearance(AppearanceKind{}, Appearance::Bytes{}));
}

TEST_CASE("a descriptor keeps its direction, whatever its norm and scalar", "[types][appearance]") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 500; ++trial) {
    const std::size_t length = 1 + random() % AppearanceKind::max_length;
    const AppearanceKind kind("random", length);
    Eigen::VectorXd a(static_cast<Eigen::Index>(length)), b(a.size());
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      a(i) = normal(random);
      b(i) = a(i) + normal(random);
    }
    const Appearance of_a(kind, a), of_b(kind, b.cast<float>());
    CHECK(of_a.known());
    CHECK(of_a.kind() == kind);
    CHECK(Appearance(kind, 1e-30 * a) == of_a);
    CHECK(Appearance(kind, 1e30 * a) == of_a);
    CHECK(Appearance(kind, of_a.bytes()) == of_a);
    CHECK(Appearance(kind, -a) != of_a);
    const auto at = [](const Appearance& x, Eigen::Index i) {
      return static_cast<double>(x.bytes()[static_cast<std::size_t>(i)]);
    };
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      CHECK(std::abs(at(of_a, i) / 127.0 - a(i) / a.cwiseAbs().maxCoeff()) <= 0.5 / 127.0 + 1e-12);
    }
    CHECK(std::abs(cosine_similarity(of_a, of_b) - a.dot(b) / (a.norm() * b.norm())) < 0.02);
    CHECK(cosine_similarity(of_a, of_a) == Approx(1.0));
    CHECK(cosine_similarity(of_a, of_b) == cosine_similarity(of_b, of_a));
    CHECK(cosine_similarity(of_a, Appearance(kind, -a)) == Approx(-1.0));
  }
}

TEST_CASE("the extreme bytes are numbers like others", "[types][appearance]") {
  const AppearanceKind kind("extremes", AppearanceKind::max_length);
  Appearance::Bytes lowest;
  lowest.fill(-128);
  const Appearance a(kind, lowest);
  CHECK(a.bytes() == lowest);
  CHECK(cosine_similarity(a, a) == 1.0);
}

TEST_CASE("bytes beyond the kind's length do not count", "[types][appearance]") {
  const AppearanceKind kind("short", 2);
  Appearance::Bytes bytes{1, 2, 3};
  const Appearance a(kind, bytes);
  CHECK(a.bytes() == Appearance::Bytes{1, 2});
}

TEST_CASE("a kind is a name and a length", "[types][appearance]") {
  constexpr AppearanceKind kind("clip", 8);
  STATIC_REQUIRE(kind == AppearanceKind(std::string_view("clip"), 8));
  STATIC_REQUIRE(kind != AppearanceKind("clip", 9));
  STATIC_REQUIRE(kind != AppearanceKind("clap", 8));
  STATIC_REQUIRE(kind != AppearanceKind{});
  CHECK(AppearanceKind(kind.number(), kind.length()) == kind);
  CHECK(AppearanceKind("", 1).number() == 0x811c9dc5);  // FNV-1a of nothing, and of "a"
  CHECK(AppearanceKind("a", 1).number() == 0xe40c292c);
}

TEST_CASE("what is no descriptor is refused", "[types][appearance]") {
  const AppearanceKind kind("three", 3);
  const auto said = [&](const Eigen::VectorXd& vector) {
    return error_text([&] { Appearance(kind, vector); });
  };
  CHECK(said(Eigen::Vector2d(1, 2)) == "a descriptor of 2 numbers; its kind has 3");
  CHECK(said(Eigen::Vector3d::Zero()) == "a descriptor of zeros has no direction");
  CHECK(error_text([&] {
          Appearance(kind, Appearance::Bytes{0, 0, 0, 1});
        }) == "a descriptor of zeros has no direction");
  for (const double x :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK(said(Eigen::Vector3d(1, x, 0)) == "a descriptor holds a number that is not finite");
  }
  for (const std::size_t length : {0U, 65U, 256U, 257U}) {
    CHECK(error_text([&] { AppearanceKind("odd", length); }) ==
          "a descriptor of " + std::to_string(length) + " numbers; it holds 1 to 64");
  }
}

TEST_CASE("kinds that stand together are one", "[types][appearance]") {
  const AppearanceKind none, a("a", 4), b("b", 4), longer("a", 5);
  CHECK(common_kind(none, none, "it") == none);
  CHECK(common_kind(none, a, "it") == a);
  CHECK(common_kind(a, none, "it") == a);
  CHECK(common_kind(a, a, "it") == a);
  CHECK_THROWS_AS(common_kind(a, b, "it"), InvalidValue);
  CHECK(error_text([&] { common_kind(a, longer, "node", 3); }) ==
        "node 3 has descriptors of another kind (5 numbers) than those before it (4): describe all "
        "objects by one method");
}
