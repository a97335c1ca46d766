// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>
#include <string>

#include <topobag/adaptors/sqlite.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "bag/described_images.hpp"
#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

TEST_CASE("a map on disk keeps the images of its key frames through every change", "[sqlite]") {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const ScratchFolder folder;
    const std::string path = folder.path("map.db");
    std::mt19937 random(seed);
    SqliteBag<> map(path);
    BagOfTopologyGraphs<> model;
    for (int step = 0; step < 60; ++step) {
      const KeyframeId id{random() % 15};
      EntryInfo info;
      info.image = random_image(random);
      const auto graph = decode(encode(random_graph(random, 4, 80, false)));
      if (!model.contains(id)) {
        map.add(id, graph, info);
        model.add(id, graph, info);
      } else if (random() % 3 == 0) {
        CHECK(map.erase(id));
        model.erase(id);
      } else {
        map.update(id, graph, info);
        model.update(id, graph, info);
      }
      if (step % 10 == 0 && model.contains(id)) {
        map.set_poses({{id, Eigen::Isometry3d::Identity()}});
        model.set_poses({{id, Eigen::Isometry3d::Identity()}});
      }
    }
    CHECK(saved(map.bag()) == saved(model));
    SqliteOptions reading;
    reading.read_only = true;
    CHECK(saved(SqliteBag<>(path, reading).bag()) == saved(model));
    CHECK(SqliteBag<IndexedBag>(path, reading).bag().image_kind() == test_image_kind());
  }
}

TEST_CASE("a map has a table of images from the first one on, and keeps its schema", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  const auto number = [&](const std::string& sql) {
    return detail::sqlite_number(detail::SqliteConnection(path, true), sql);
  };
  const std::string tables = "SELECT count(*) FROM sqlite_master WHERE name = 'image'";
  EntryInfo info;
  info.image = {test_image_kind(), Eigen::VectorXd::Ones(24)};
  {
    SqliteBag<> map(path);
    map.add(KeyframeId{1}, {});
    CHECK(number(tables) == 0);
    map.add(KeyframeId{2}, {}, info);
    map.add(KeyframeId{3}, {}, info);
    map.add(KeyframeId{4}, {}, info);
  }
  CHECK(number(tables) == 1);
  CHECK(number("PRAGMA user_version") == 1);
  CHECK(number("SELECT count(*) FROM image") == 3);
  // As one does who knows nothing of images.
  detail::SqliteConnection(path, false)
      .run(
          "UPDATE keyframe SET graph = graph WHERE id = 2; DELETE FROM keyframe WHERE id = 3;"
          "UPDATE keyframe SET label = 'here' WHERE id = 4");
  const SqliteBag<> map(path);
  CHECK_FALSE(map.info(KeyframeId{2})->image.known());
  CHECK(map.info(KeyframeId{4})->image == info.image);
  CHECK(number("SELECT count(*) FROM image") == 1);
}

TEST_CASE("a map refuses images of two kinds, and damaged ones, and is as it was", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  EntryInfo info, other;
  info.image = {test_image_kind(), Eigen::VectorXd::Ones(24)};
  other.image = {ImageKind("other", 24), Eigen::VectorXd::Ones(24)};
  {
    SqliteBag<> map(path);
    map.add(KeyframeId{1}, {}, info);
    CHECK_THROWS_AS(map.add(KeyframeId{2}, {}, other), InvalidValue);
    map.add(KeyframeId{2}, {}, info);
    CHECK_THROWS_AS(map.update(KeyframeId{2}, {}, other), InvalidValue);
    CHECK(map.info(KeyframeId{2})->image == info.image);
  }
  CHECK(SqliteBag<>(path).size() == 2);
  detail::SqliteConnection(path, false)
      .run("UPDATE image SET descriptor = zeroblob(24) WHERE keyframe = 2");
  CHECK(error_text([&] {
          SqliteBag<> map(path);
        }).find("key frame 2 cannot be read: the checksum of its image does not fit") !=
        std::string::npos);
}
