// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/bag/snapshot_file.hpp>

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
        "a descriptor of zeros has no direction: it is damaged");
  CHECK(error_text([&] { detail::entry_of(empty); }) ==
        "a descriptor of 0 numbers; it holds 1 to 65535: it is damaged");
  CHECK_THROWS_AS(detail::entry_of(cut), FormatError);
}

TEST_CASE("the file of format 2 with images and label weights loads for ever", "[bag][snapshot]") {
  const std::string path = TOPOBAG_SOURCES "/tests/bag/frozen/v2_images.bag";
  CHECK(inspect(path).format_version == 2);
  CHECK(inspect(path).codec_version == 2);
  const BagOfTopologyGraphs<> bag = load(path);
  REQUIRE(bag.size() == 3);
  CHECK(bag.image_kind() == ImageKind("frozen", 300));
  for (const std::uint64_t k : {0U, 1U, 2U}) {
    const EntryInfo info = *bag.info(KeyframeId{10 * k});
    CHECK(info.label == "desk");
    REQUIRE(info.image.known() == (k != 1));
    for (std::size_t i = 0; i < 300 && k != 1; ++i) {
      CHECK(int{info.image.bytes()[i]} == static_cast<int>((7 * i + k) % 255) - 127);
    }
    const TopologyGraph<> graph = *bag.find(KeyframeId{10 * k});
    REQUIRE(graph.size() == 4);
    CHECK(graph.nodes()[1].label_weights.empty());
    CHECK(graph.nodes()[0].label_weights == LabelWeights({{ClassId{41}, 1.0}, {ClassId{45}, 0.5}}));
    const LabelWeights& five = graph.nodes()[2].label_weights;
    REQUIRE(five.size() == 5);
    CHECK(five.label(1) == ClassId{0});
    CHECK(int{five.byte(1)} == 204);
    CHECK(five.label(2) == ClassId{-7});
    CHECK(five.label(3) == ClassId{2000000000});
    CHECK(int{five.byte(4)} == 51);
  }
  std::ifstream stream(path, std::ios::binary);
  const std::string frozen{std::istreambuf_iterator<char>(stream), {}};
  const std::string written = saved(bag);
  CHECK(written.substr(0, 12) == frozen.substr(0, 12));  // but for the library's own version
  CHECK(written.substr(16, 24) == frozen.substr(16, 24));
  CHECK(written.substr(44) == frozen.substr(44));
}
