// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <topobag/bag/graph_codec.hpp>

#include "bag/realistic_graphs.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Why the bytes were refused, or nothing; anything but a FormatError goes on to the test.
std::string refusal(const Bytes& bytes) {
  try {
    decode(bytes);
    return {};
  } catch (const FormatError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("what cannot be kept is refused with its index", "[bag][codec]") {
  std::vector<SemanticNode<>> nodes(3);
  nodes[2].position = Eigen::Vector3d(0, 2e6, 0);
  try {
    encode(TopologyGraph<>(nodes));
    FAIL("a node beyond the format's reach was taken");
  } catch (const InvalidValue& error) {
    CHECK(error.index() == 2u);
    CHECK(error.what() ==
          std::string("node 2 is more than 2^20 m away: a graph is kept in metres"));
  }
  View<> far_off;
  far_off.T_graph_camera.translation().y() = -std::ldexp(1.0, 20);
  CHECK_NOTHROW(encode(TopologyGraph<>({}, {}, {far_off})));
  far_off.T_graph_camera.translation().y() -= 1.0;
  CHECK_THROWS_AS(encode(TopologyGraph<>({}, {}, {far_off})), InvalidValue);
}

TEST_CASE("what is encoded can be decoded, up to 4096 nodes", "[bag][codec]") {
  CHECK(decode(encode(TopologyGraph<>(std::vector<SemanticNode<>>(4096)))).size() == 4096);
  CHECK_THROWS_AS(encode(TopologyGraph<>(std::vector<SemanticNode<>>(4097))), InvalidValue);
}

TEST_CASE("bytes that no encoder wrote are refused or give a graph", "[bag][codec]") {
  std::mt19937 random(8);
  const Bytes good = encode(realistic_graph(random, 12));
  for (std::size_t size = 0; size < good.size(); ++size) {
    CHECK_THROWS_AS(decode(good.data(), size), FormatError);
  }
  std::size_t refused = 0;
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    Bytes flipped = good;
    flipped[bit / 8] = static_cast<std::uint8_t>(flipped[bit / 8] ^ 1u << bit % 8);
    if (!refusal(flipped).empty()) ++refused;
  }
  CHECK(refused > 100);
  for (int trial = 0; trial < 20000; ++trial) {
    Bytes noise(1 + random() % 200);
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(random());
    noise[0] = static_cast<std::uint8_t>((noise[0] & 0xF0) | (1 + random() % graph_codec_version));
    refusal(noise);
  }
  Bytes longer = good;
  longer.push_back(0);
  CHECK(refusal(longer) == "the data go on after their end: they are damaged");
  Bytes later = good;
  later[0] = static_cast<std::uint8_t>((later[0] & 0xF0) | (graph_codec_version + 1));
  CHECK(refusal(later).find("a graph of format 3; this version") == 0);
}

TEST_CASE("a graph that announces 2^59 nodes is refused before room is made", "[bag][codec]") {
  detail::BitWriter writer;
  detail::put_header(writer, {});
  writer.put_number(std::uint64_t{1} << 59);
  for (int i = 0; i < 100; ++i) writer.put(0, 64);
  CHECK_THROWS_AS(decode(writer.take()), FormatError);
}
