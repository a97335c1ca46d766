// SPDX-License-Identifier: MIT
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <topobag/bag/snapshot_file.hpp>
#include <topobag/sensing/color_descriptor.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

#include "bag/careless_bag.hpp"
#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "child_process.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

using Bag = BagOfTopologyGraphs<>;

std::size_t files_in(const ScratchFolder& folder) {
  const std::filesystem::directory_iterator begin(folder.path()), end;
  return static_cast<std::size_t>(std::distance(begin, end));
}

}  // namespace

TEST_CASE("a bag comes back from a file as it was", "[bag][snapshot]") {
  const ScratchFolder folder;
  std::mt19937 random(1);
  const std::string path = folder.path("room.bag");
  for (const std::size_t count : {0u, 1u, 40u, 3u}) {
    const Bag bag = random_bag(random, count);
    save(bag, path);
    CHECK(saved(load(path)) == saved(bag));
    CHECK(content_of(path) == saved(bag));
    CHECK(inspect(path).entries == count);
  }
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a file longer than the writer's buffer holds every byte", "[bag][snapshot]") {
  const ScratchFolder folder;
  std::mt19937 random(12);
  const std::string path = folder.path("building.bag");
  const Bag bag = random_bag(random, 2000);
  save(bag, path);
  REQUIRE(saved(bag).size() > 2 * 65536);
  CHECK(content_of(path) == saved(bag));
}

TEST_CASE("a bag in memory stays as it was when a file is refused", "[bag][snapshot]") {
  const ScratchFolder folder;
  std::mt19937 random(2);
  Bag bag = random_bag(random, 5);
  const std::string before = saved(bag);
  const std::string path = folder.write("cut.bag", before.substr(0, 200));
  CHECK_THROWS_AS(bag = load(path), FormatError);
  CHECK(saved(bag) == before);
  CHECK(error_text([&] { load(path); }).find(path + ": entry ") == 0);
  folder.write("long.bag", before + '\0');
  CHECK(error_text([&] { load(folder.path("long.bag")); }) ==
        folder.path("long.bag") +
            ": it goes on after its last entry: it is damaged; take another copy");
  CHECK(error_text([&] { load(folder.path("none.bag")); }) ==
        folder.path("none.bag") + " cannot be opened: No such file or directory");
  CHECK(error_text([&] { inspect(folder.path()); }) ==
        folder.path() + ": it is cut off; take a complete copy");
}

TEST_CASE("the file of format 1 loads for ever", "[bag][snapshot]") {
  const Bag bag =
      load(TOPOBAG_SOURCES "/tests/bag/frozen/v1.bag", fingerprint(ClassCatalog::coco80()));
  REQUIRE(bag.size() == 3);
  const TopologyGraph<> desk = *bag.find(KeyframeId{7});
  REQUIRE(desk.size() == 3);
  const SemanticNode<>& tv = desk.nodes()[0];
  CHECK(tv.label == ClassId{62});
  CHECK(*tv.position == Eigen::Vector3d(-0.5, 0.25, 1.75));
  CHECK(*tv.pixel == Eigen::Vector2d(171.0, 329.0));
  CHECK(tv.z == 1.75);
  CHECK(tv.size == Eigen::Vector2d(0.5, 0.375));
  CHECK(tv.confidence == Approx(0.9).margin(0.004));
  CHECK(tv.existence == 1.0);
  CHECK(tv.covariance.trace() == Approx(0.00406).epsilon(0.1));
  CHECK_FALSE(desk.nodes()[2].position);
  CHECK(desk.nodes()[1].covariance.isZero(0.0));
  CHECK(desk.edges() == EdgeList{{NodeIndex{0}, NodeIndex{1}}});
  REQUIRE(desk.views().size() == 1);
  CHECK(desk.views()[0].camera.fx == 517.25);
  CHECK(desk.views()[0].camera.width == 640);
  REQUIRE(desk.views()[0].occluders.size() == 1);
  CHECK(desk.views()[0].occluders[0].box.x2 == 301.0);
  CHECK(desk.views()[0].T_graph_camera.translation() == Eigen::Vector3d(0.125, 0.0, -1.0));
  CHECK(*bag.info(KeyframeId{7})->stamp == 1305031102.175304);
  CHECK(bag.info(KeyframeId{7})->session == 2);
  CHECK(bag.info(KeyframeId{7})->label == "desk");
  CHECK(bag.info(KeyframeId{7})->T_world_camera->translation() == Eigen::Vector3d(1.1, 2.2, 3.3));
  CHECK(bag.find(KeyframeId{8})->empty());
  CHECK_FALSE(bag.info(KeyframeId{8})->stamp);
  CHECK(bag.contains(KeyframeId{~std::uint64_t{0}}));
}

TEST_CASE("the file of format 2 loads for ever, and is written again byte for byte",
          "[bag][snapshot]") {
  const std::string path = TOPOBAG_SOURCES "/tests/bag/frozen/v2.bag";
  CHECK(inspect(path).codec_version == 2);
  const Bag bag = load(path, fingerprint(ClassCatalog::coco80()));
  REQUIRE(bag.size() == 4);
  std::size_t described = 0;
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    REQUIRE(graph.gravity());
    // The world's z is up, and the deviation is that of an accelerometer.
    const Eigen::Vector3d down = info.T_world_camera->linear() * graph.gravity()->down;
    CHECK(down.z() < -0.999);
    CHECK(graph.gravity()->deviation == Approx(0.0175).epsilon(0.05));
    CHECK(graph.appearance_kind() == ColorDescriptor::kind);
    REQUIRE(graph.views().size() == 1);
    REQUIRE(graph.views()[0].depth);
    const auto& levels = graph.views()[0].depth->levels();
    for (std::size_t i = 0; i < levels.size(); ++i) CHECK(levels[i] == (7 * i + value(id)) % 40);
    for (const auto& node : graph.nodes()) described += node.appearance.known() ? 1U : 0U;
  });
  CHECK(described == 18);
  SaveOptions options;
  options.catalog_fingerprint = fingerprint(ClassCatalog::coco80());
  const std::string written = saved(bag, options), frozen = content_of(path);
  CHECK(written.substr(16, 24) == frozen.substr(16, 24));  // beside the library's own version
  CHECK(written.substr(44) == frozen.substr(44));
}

TEST_CASE("a bag without gravity is written as format 1 was, byte for byte",
          "[bag][snapshot][gravity]") {
  const std::string path = TOPOBAG_SOURCES "/tests/bag/frozen/v1.bag";
  SaveOptions options;
  options.catalog_fingerprint = fingerprint(ClassCatalog::coco80());
  const std::string written = saved(load(path), options), frozen = content_of(path);
  CHECK(inspect(path).codec_version == 1);
  CHECK(written.substr(16, 24) == frozen.substr(16, 24));  // beside the library's own version
  CHECK(written.substr(44) == frozen.substr(44));
}

TEST_CASE("a link's file is replaced, not the link, and keeps its permissions", "[bag][snapshot]") {
  const ScratchFolder folder;
  std::mt19937 random(3);
  const std::string file = folder.write("2026.bag", "old");
  REQUIRE(::chmod(file.c_str(), 0640) == 0);
  std::filesystem::create_symlink("2026.bag", folder.path("now.bag"));
  const Bag bag = random_bag(random, 3);
  save(bag, folder.path("now.bag"));
  CHECK(std::filesystem::is_symlink(folder.path("now.bag")));
  CHECK(content_of(file) == saved(bag));
  struct ::stat status {};
  REQUIRE(::stat(file.c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("a full disk is an error and leaves the old file", "[bag][snapshot]") {
  const ScratchFolder folder;
  std::mt19937 random(4);
  const Bag old = random_bag(random, 3), larger = random_bag(random, 1000);
  const std::string path = folder.path("room.bag");
  save(old, path);
  for (const ::rlim_t limit : {0u, 1000u, 65536u, 100000u}) {
    REQUIRE(saved(larger).size() > limit);
    const std::string said = text_from_child([&] {
      ::signal(SIGXFSZ, SIG_IGN);
      const ::rlimit size{limit, limit};
      ::setrlimit(RLIMIT_FSIZE, &size);
      return error_text([&] { save(larger, path); });
    });
    CHECK(said == path + " cannot be written: File too large");
    CHECK(content_of(path) == saved(old));
    CHECK(files_in(folder) == 1);
  }
}

TEST_CASE("a folder that cannot be written to is an error and leaves the old file",
          "[bag][snapshot]") {
  const ScratchFolder folder;
  std::mt19937 random(5);
  const Bag bag = random_bag(random, 3);
  const std::string path = folder.path("room.bag");
  save(bag, path);
  REQUIRE(::chmod(folder.path().c_str(), 0555) == 0);
  const std::string said = text_from_child([&] {
    // Root may write anywhere: be nobody.
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) return std::string{};
    return error_text([&] { save(random_bag(random, 5), path); });
  });
  REQUIRE(::chmod(folder.path().c_str(), 0755) == 0);
  CHECK(said == path + " cannot be written: Permission denied");
  CHECK(content_of(path) == saved(bag));
  CHECK(error_text([&] { save(bag, folder.path("none/room.bag")); }) ==
        folder.path("none/room.bag") + " cannot be written: No such file or directory");
  CHECK(files_in(folder) == 1);
  std::filesystem::create_directory(folder.path("rooms"));
  CHECK(error_text([&] { save(bag, folder.path("rooms")); }) ==
        folder.path("rooms") + " cannot be written: Is a directory");
  CHECK(files_in(folder) == 2);
}

TEST_CASE("a save replaces no pipe and no device", "[bag][snapshot]") {
  const ScratchFolder folder;
  std::mt19937 random(8);
  const std::string path = folder.path("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  CHECK(error_text([&] { save(random_bag(random, 3), path); }) ==
        path + " cannot be written: Invalid argument");
  CHECK(std::filesystem::is_fifo(path));
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a graph that cannot be kept leaves the old file", "[bag][snapshot]") {
  const ScratchFolder folder;
  std::mt19937 random(6);
  const std::string path = folder.path("room.bag");
  save(random_bag(random, 3), path);
  const std::string before = content_of(path);
  CHECK_THROWS_AS(save(CarelessBag{}, path), InvalidValue);
  CHECK(content_of(path) == before);
  CHECK(files_in(folder) == 1);
}
