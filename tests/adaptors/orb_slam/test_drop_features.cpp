// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam/drop_features.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

struct Feature {
  int x = 0, y = 0;
  bool operator==(const Feature& o) const { return x == o.x && y == o.y; }
};

/// Descriptors, by the names of cv::Mat.
struct DescriptorRows {
  std::vector<int> numbers;
  DescriptorRows row(int i) const { return {{numbers[static_cast<std::size_t>(i)]}}; }
  void push_back(const DescriptorRows& other) {
    numbers.insert(numbers.end(), other.numbers.begin(), other.numbers.end());
  }
};

/// A frame as ORB-SLAM constructs it: everything by the index of a feature, the grid too.
struct FeatureFrame {
  explicit FeatureFrame(const std::vector<Feature>& features)
      : N(static_cast<int>(features.size())),
        mvKeys(features),
        mvpMapPoints(features.size(), nullptr),
        mvbOutlier(features.size(), false) {
    for (std::size_t i = 0; i < features.size(); ++i) {
      const Feature& feature = features[i];
      mvKeysUn.push_back({feature.x + 1, feature.y - 1});
      mvuRight.push_back(static_cast<float>(feature.x) - 10.0f);
      mvDepth.push_back(static_cast<float>(feature.y) / 10.0f);
      mDescriptors.numbers.push_back(1000 * feature.x + feature.y);
      mGrid[feature.x / 100][feature.y / 100].push_back(i);
    }
  }

  int N;
  std::vector<Feature> mvKeys, mvKeysUn;
  std::vector<float> mvuRight, mvDepth;
  DescriptorRows mDescriptors;
  std::vector<int*> mvpMapPoints;
  std::vector<bool> mvbOutlier;
  std::vector<std::size_t> mGrid[7][5];
};

void check_same_features(const FeatureFrame& a, const FeatureFrame& b) {
  CHECK(a.N == b.N);
  CHECK(a.mvKeys == b.mvKeys);
  CHECK(a.mvKeysUn == b.mvKeysUn);
  CHECK(a.mvuRight == b.mvuRight);
  CHECK(a.mvDepth == b.mvDepth);
  CHECK(a.mDescriptors.numbers == b.mDescriptors.numbers);
  CHECK(a.mvpMapPoints == b.mvpMapPoints);
  CHECK(a.mvbOutlier == b.mvbOutlier);
  for (int x = 0; x < 7; ++x) {
    for (int y = 0; y < 5; ++y) CHECK(a.mGrid[x][y] == b.mGrid[x][y]);
  }
}

}  // namespace

TEST_CASE("a frame with features dropped is one where they were never found", "[adaptors]") {
  std::mt19937 random(1);
  for (const unsigned percent : {0u, 1u, 30u, 99u, 100u}) {
    for (const std::size_t count : {0u, 1u, 300u}) {
      std::vector<Feature> all, kept;
      std::vector<bool> drop;
      for (std::size_t i = 0; i < count; ++i) {
        all.push_back({static_cast<int>(random() % 640), static_cast<int>(random() % 480)});
        drop.push_back(random() % 100 < percent);
        if (!drop.back()) kept.push_back(all.back());
      }
      FeatureFrame frame(all);
      CHECK(drop_features(frame, drop) == all.size() - kept.size());
      check_same_features(frame, FeatureFrame(kept));
    }
  }
}
