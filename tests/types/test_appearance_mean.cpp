// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>

#include <topobag/types/appearance_mean.hpp>

#include "catch.hpp"
#include "random_appearance.hpp"

using namespace topobag;

TEST_CASE("the mean of one descriptor is that one", "[types][appearance]") {
  std::mt19937 random(1);
  CHECK_FALSE(AppearanceMean{}.mean().known());
  for (std::size_t length = 1; length <= AppearanceKind::max_length; ++length) {
    const Appearance a = random_appearance(random, {"random", length});
    AppearanceMean mean;
    mean.add({});
    mean.add(a);
    mean.add({});
    CHECK(mean.mean() == a);
    mean.add(a);
    CHECK(mean.mean() == a);
  }
}

TEST_CASE("every descriptor counts alike in the mean, however large its bytes",
          "[types][appearance]") {
  const AppearanceKind kind("plane", 2);
  AppearanceMean mean;
  mean.add(Appearance(kind, Appearance::Bytes{100, 0}));
  mean.add(Appearance(kind, Appearance::Bytes{0, 1}));
  CHECK(mean.mean() == Appearance(kind, Appearance::Bytes{127, 127}));
  mean.add(Appearance(kind, Appearance::Bytes{0, 30}));
  CHECK(mean.mean() == Appearance(kind, Appearance::Bytes{64, 127}));
}

TEST_CASE("opposite descriptors have no mean", "[types][appearance]") {
  const AppearanceKind kind("line", 1);
  AppearanceMean mean;
  mean.add(Appearance(kind, Appearance::Bytes{5}));
  mean.add(Appearance(kind, Appearance::Bytes{-9}));
  CHECK_FALSE(mean.mean().known());
}
