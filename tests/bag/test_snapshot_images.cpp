// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/bag/snapshot.hpp>

#include "bag/described_images.hpp"
#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

BagOfTopologyGraphs<> bag_with_known_images(unsigned seed) {
  std::mt19937 random(seed);
  BagOfTopologyGraphs<> bag = random_bag(random, 12);
  bag.for_each([&](KeyframeId id, EntryInfo info, const TopologyGraph<>& graph) {
    info.image = random_image(random);
    bag.update(id, graph, info);
  });
  return bag;
}

std::uint32_t format_of(const std::string& bytes) {
  std::istringstream stream(bytes);
  return inspect(stream).format_version;
}

}  // namespace

TEST_CASE("a saved bag keeps its images, in version 2; without any it is one of version 1",
          "[bag]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    BagOfTopologyGraphs<> bag = bag_with_known_images(seed);
    const std::string bytes = saved(bag);
    CHECK(format_of(bytes) == 2);
    const BagOfTopologyGraphs<> back = loaded(bytes);
    CHECK(back.image_kind() == test_image_kind());
    bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>&) {
      CHECK(back.info(id)->image == info.image);
    });
    CHECK(saved(back) == bytes);
    std::size_t described = 0;
    bag.for_each([&](KeyframeId id, EntryInfo info, const TopologyGraph<>& graph) {
      described += info.image.known() ? 1U : 0U;
      info.image = {};
      bag.update(id, graph, info);
    });
    const std::string plain = saved(bag);
    CHECK(format_of(plain) == 1);
    CHECK(bytes.size() == plain.size() + described * (4 + 2 + 24));
  }
}

TEST_CASE("a bag with images that is cut off or changed anywhere is refused", "[bag]") {
  const std::string bytes = saved(bag_with_known_images(3));
  for (std::size_t size = 0; size < bytes.size(); size += 3) {
    CHECK_THROWS_AS(loaded(bytes.substr(0, size)), FormatError);
  }
  for (std::size_t i = 0; i < bytes.size(); i += 5) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 4);
    CHECK_THROWS_AS(loaded(changed), FormatError);
  }
}

TEST_CASE("an entry whose image is damaged is refused in a sentence", "[bag]") {
  detail::EntryRecord entry;
  entry.info.image = {test_image_kind(), Eigen::VectorXd::Ones(24)};
  const std::vector<std::uint8_t> bytes = detail::to_bytes(entry);
  CHECK(detail::entry_of(bytes).info.image == entry.info.image);
  const std::size_t begin = 8 + 4 + 1;
  std::vector<std::uint8_t> zeros = bytes, empty = bytes, cut(bytes.begin(), bytes.end() - 1);
  std::fill(zeros.begin() + begin + 6, zeros.end(), std::uint8_t{0});
  empty[begin + 4] = empty[begin + 5] = 0;
  CHECK(error_text([&] { detail::entry_of(zeros); }) ==
        "an image's descriptor of zeros has no direction: it is damaged");
  CHECK(error_text([&] { detail::entry_of(empty); }) ==
        "an image's descriptor of 0 numbers; it holds 1 to 65535: it is damaged");
  CHECK_THROWS_AS(detail::entry_of(cut), FormatError);
}
