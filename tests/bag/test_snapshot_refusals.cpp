// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/bag/snapshot.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

#include "bag/saved_bags.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

using Bag = BagOfTopologyGraphs<>;

/// Why the bytes were refused, or nothing; anything but a FormatError goes on to the test.
std::string refusal(const std::string& bytes, std::uint64_t catalog_fingerprint = 0) {
  try {
    loaded(bytes, catalog_fingerprint);
    return {};
  } catch (const FormatError& error) {
    return error.what();
  }
}

std::string sealed(std::string header) {
  detail::BitWriter writer;
  const std::vector<std::uint8_t> bytes(header.begin(), header.begin() + 40);
  writer.put(detail::crc32(bytes.data(), bytes.size()), 32);
  const std::vector<std::uint8_t> sum = writer.take();
  std::copy(sum.begin(), sum.end(), header.begin() + 40);
  return header;
}

}  // namespace

TEST_CASE("every flipped bit and every truncation of a saved bag is refused", "[bag][snapshot]") {
  std::mt19937 random(5);
  const std::string good = saved(random_bag(random, 4));
  REQUIRE(refusal(good).empty());
  for (std::size_t size = 0; size < good.size(); ++size) {
    CHECK_FALSE(refusal(good.substr(0, size)).empty());
  }
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::string flipped = good;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    CHECK_FALSE(refusal(flipped).empty());
  }
}

TEST_CASE("a refusal says what is wrong and what to do", "[bag][snapshot]") {
  std::mt19937 random(6);
  const std::string good = saved(random_bag(random, 3));
  CHECK(refusal("") == "it is cut off; take a complete copy");
  CHECK(refusal("CREATE TABLE bag;") ==
        "it is not a bag saved by topobag, or a copy as text has damaged it");
  CHECK(refusal("hello") == "it is not a bag saved by topobag, or a copy as text has damaged it");
  CHECK(refusal(good.substr(0, 5)) == "it is cut off; take a complete copy");
  CHECK(refusal(good.substr(0, 30)) == "it is cut off; take a complete copy");
  CHECK(refusal(good.substr(0, good.size() - 1)) ==
        "entry 2 of 3 cannot be read: it is cut off; take a complete copy");
  std::string damaged = good;
  damaged[44 + 4 + 20] ^= 1;
  CHECK(refusal(damaged) ==
        "entry 0 of 3 cannot be read: its checksum does not fit: it is damaged; take another copy");
  damaged = good;
  damaged[30] ^= 1;
  CHECK(refusal(damaged) == "its header is damaged; take another copy");
  std::string later = good;
  later[8] = 3;
  CHECK(refusal(sealed(later)) ==
        "it was saved by a later version of topobag (format 3): update topobag");
  std::string wide = good;
  wide[20] = 16;
  CHECK(refusal(sealed(wide)) == "its ids or classes are of another size than topobag's");
}

TEST_CASE("numbers that no file can hold make no room", "[bag][snapshot]") {
  std::mt19937 random(7);
  std::string many = saved(random_bag(random, 1));
  many[24 + 7] = 0x10;  // 2^60 + 1 entries
  CHECK(
      refusal(sealed(many)).find("entry 1 of 1152921504606846977 cannot be read: it is cut off") ==
      0);
  std::string longer = saved(random_bag(random, 1));
  longer[44 + 3] = static_cast<char>(0xFF);  // an entry of 4 GB
  CHECK(refusal(longer) == "entry 0 of 1 cannot be read: it is cut off; take a complete copy");
}

TEST_CASE("a small file of many nodes makes no room for their pairs", "[bag][snapshot]") {
  detail::BitWriter graph;  // 3.6 kB: without the limit n², for any n
  detail::put_header(graph, {});
  const std::size_t nodes = 4097;
  graph.put_number(nodes);
  detail::put_column(graph, detail::Column(nodes, 127), detail::vouching_width);
  detail::put_column(graph, detail::Column(nodes, 0));  // class
  detail::put_column(graph, detail::Column(nodes, 127));
  detail::put_column(graph, detail::Column(nodes, detail::has_position));
  for (int column = 0; column < 5; ++column) {  // size and position
    detail::put_column(graph, detail::Column(nodes, 0));
  }
  detail::put_edges(graph, {}, nodes);
  std::ostringstream stream;
  SnapshotHeader header;
  header.scalar_bytes = 8;
  header.entries = 1;
  detail::write_bytes(stream, to_bytes(header));
  detail::write_record(stream, detail::to_bytes({KeyframeId{1}, {}, graph.take()}));
  CHECK(refusal(stream.str()) ==
        "entry 0 of 1 cannot be read: a graph of more than 4096 nodes: the data are damaged");
}

TEST_CASE("a bag made with other classes is refused", "[bag][snapshot]") {
  std::mt19937 random(8);
  const Bag bag = random_bag(random, 2);
  const std::uint64_t coco = fingerprint(ClassCatalog::coco80());
  const std::uint64_t paper = fingerprint(ClassCatalog::paper());
  SaveOptions options;
  options.catalog_fingerprint = coco;
  CHECK(refusal(saved(bag, options), paper) ==
        "its class numbers mean other names than yours; load it with the catalog that it was saved "
        "with");
  CHECK(refusal(saved(bag, options), coco).empty());
  CHECK(refusal(saved(bag, options)).empty());
  CHECK(refusal(saved(bag), paper).empty());
}

namespace {

/// A bag that visits its entries by falling id.
struct Backwards {
  using Graph = Bag::Graph;
  Bag bag;

  std::size_t size() const { return bag.size(); }
  template <typename Visit>
  void for_each(const Visit& visit) const {
    std::vector<KeyframeId> ids;
    bag.for_each([&](KeyframeId id, const EntryInfo&, const Graph&) { ids.push_back(id); });
    std::for_each(ids.rbegin(), ids.rend(),
                  [&](KeyframeId id) { visit(id, *bag.info(id), *bag.find(id)); });
  }
};

}  // namespace

TEST_CASE("entries that are not in the order of their ids are refused", "[bag][snapshot]") {
  std::mt19937 random(11);
  CHECK(refusal(saved(Backwards{random_bag(random, 2)})) ==
        "entry 1 of 2 cannot be read: its id is not above the one before");
}
