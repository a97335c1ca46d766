// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/bag/snapshot_file.hpp>

#include "bag/saved_bags.hpp"
#include "bag/warehouse_catalogs.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

std::string saved_in_the_warehouse(std::size_t entries) {
  std::mt19937 random(5);
  SaveOptions options;
  options.catalog = warehouse();
  return saved(random_bag(random, entries), options);
}

BagOfTopologyGraphs<> loaded_with(const std::string& bytes, const DescribedCatalog& classes) {
  std::istringstream stream(bytes);
  return load<BagOfTopologyGraphs<>>(stream, classes);
}

std::optional<DescribedCatalog> catalog_in(const std::string& bytes) {
  std::istringstream stream(bytes);
  return saved_catalog(stream);
}

}  // namespace

TEST_CASE("a saved bag keeps all that is said of its classes", "[bag][snapshot]") {
  const std::string bytes = saved_in_the_warehouse(6);
  const auto kept = catalog_in(bytes);
  REQUIRE(kept);
  CHECK_FALSE(difference(*kept, warehouse()));
  CHECK(kept->catalog.ids() == warehouse().catalog.ids());
  CHECK(kept->catalog.name(ClassId{2000000000}) == "safety mirror");
  CHECK(*kept->sizes == *warehouse().sizes);
  std::istringstream stream(bytes);
  const SnapshotHeader header = inspect(stream);
  CHECK(header.catalog);
  CHECK(header.format_version == 2);
  CHECK(header.catalog_fingerprint == fingerprint(warehouse().catalog));

  SaveOptions options;
  options.catalog = kept;
  CHECK(saved(loaded(bytes), options) == bytes);
  CHECK(saved(loaded_with(bytes, warehouse()), options) == bytes);
  CHECK(saved(loaded(bytes, fingerprint(warehouse().catalog)), options) == bytes);
}

TEST_CASE("what was not said of classes is not kept", "[bag][snapshot]") {
  std::mt19937 random(6);
  const BagOfTopologyGraphs<> bag = random_bag(random, 3);
  SaveOptions options;
  options.catalog = warehouse().catalog;
  const auto names = catalog_in(saved(bag, options));
  REQUIRE(names);
  CHECK_FALSE(names->lookalikes);
  CHECK_FALSE(names->sizes);
  options.catalog->sizes.emplace();
  const auto sizes = catalog_in(saved(bag, options));
  REQUIRE(sizes);
  REQUIRE(sizes->sizes);
  CHECK(sizes->sizes->empty());
  CHECK_FALSE(catalog_in(saved(bag)));
}

TEST_CASE("a bag of classes of which something else is said is refused", "[bag][snapshot]") {
  const ScratchFolder folder;
  const std::string bytes = saved_in_the_warehouse(2);
  const std::string path = folder.write("hall.bag", bytes);
  for (const auto& [other, sentence] : other_warehouses()) {
    const DescribedCatalog& classes = other;
    CHECK(error_text([&] { load(path, classes); }) ==
          path + ": " + sentence + "; open it with the classes that it was made with");
  }
  CHECK(load(path, warehouse()).size() == 2);
  CHECK(load(path, warehouse().catalog).size() == 2);
  CHECK(saved_catalog(path)->catalog.size() == 5);
  CHECK(error_text([&] {
          load(path, ClassCatalog::coco80());
        }).find(path + ": its class numbers mean other names than yours") == 0);
}

TEST_CASE("a size that could not be read again is not written", "[bag][snapshot]") {
  const ScratchFolder folder;
  const std::string path = folder.path("hall.bag");
  const auto refusal_of = [&](const std::array<double, 2>& size) {
    SaveOptions options;
    options.catalog = warehouse();
    (*options.catalog->sizes)[ClassId{2}] = size;
    return error_text([&] { save(BagOfTopologyGraphs<>(), path, options); });
  };
  const std::string end = " m; give a width and a height above 0, or leave its size out";
  CHECK(refusal_of({-1.0, 0.3}) == "class 'crate' is said to be -1 x 0.3" + end);
  CHECK(refusal_of({0.0, 0.3}) == "class 'crate' is said to be 0 x 0.3" + end);
  CHECK(refusal_of({0.3, std::nan("")}) == "class 'crate' is said to be 0.3 x nan" + end);
  CHECK(refusal_of({HUGE_VAL, 1.0}) == "class 'crate' is said to be inf x 1" + end);
  CHECK_FALSE(std::filesystem::exists(path));
  CHECK(refusal_of({0.0, 0.0}) == "nothing was thrown");
  CHECK(saved_catalog(path)->sizes->count(ClassId{2}) == 0);
}

TEST_CASE("a bag that keeps no classes is not asked what they are", "[bag][snapshot]") {
  std::mt19937 random(7);
  const BagOfTopologyGraphs<> bag = random_bag(random, 3);
  SaveOptions options;
  options.catalog_fingerprint = fingerprint(warehouse().catalog);
  const std::string bytes = saved(bag, options);
  for (const auto& [other, sentence] : other_warehouses()) {
    CHECK(saved(loaded_with(bytes, other)) == saved(bag));
  }
  const std::string frozen = TOPOBAG_SOURCES "/tests/bag/frozen/v1.bag";
  DescribedCatalog coco(ClassCatalog::coco80());
  coco.catalog.set_dynamics(ClassId{62}, Dynamics::high);
  CHECK_FALSE(saved_catalog(frozen));
  CHECK(load(frozen, coco).size() == load(frozen).size());
}

TEST_CASE("a bag whose classes are cut off or changed anywhere is refused", "[bag][snapshot]") {
  const std::string bytes = saved_in_the_warehouse(1);
  for (std::size_t size = 0; size < bytes.size(); size += 3) {
    CHECK_THROWS_AS(loaded(bytes.substr(0, size)), FormatError);
  }
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 8);
    CHECK_THROWS_AS(loaded(changed), FormatError);
  }
}

TEST_CASE("classes that no catalog holds are refused in a sentence", "[bag][snapshot]") {
  const std::vector<std::uint8_t> bytes = detail::to_bytes(warehouse());
  CHECK(detail::to_bytes(detail::catalog_of(bytes)) == bytes);
  const auto refusal_with = [&](std::size_t at, std::uint8_t byte) {
    std::vector<std::uint8_t> changed = bytes;
    changed.at(at) = byte;
    return error_text([&] { detail::catalog_of(changed); });
  };
  const std::size_t first = 1 + 4, letters = first + 4 + 4, dynamics = letters + 8;
  CHECK(refusal_with(0, 4) == "it says what no catalog does");
  CHECK(refusal_with(1, 4) == "it goes on after its last class");
  CHECK(refusal_with(1, 6) == "the data end too early: they are cut off");
  CHECK(refusal_with(first + 6, 1) == "a class's name is cut off");
  CHECK(refusal_with(dynamics, 3) == "its classes' dynamics are damaged");
  CHECK(refusal_with(dynamics + 1, 9) == "its classes' look-alikes are damaged");
  CHECK(refusal_with(dynamics + 5 + 7, 0x3F) == "its classes' typical sizes are damaged");
  std::vector<std::uint8_t> cut(bytes.begin(), bytes.end() - 1);
  CHECK_THROWS_AS(detail::catalog_of(cut), FormatError);
}
