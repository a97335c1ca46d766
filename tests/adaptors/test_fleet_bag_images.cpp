// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/postgres_server.hpp"
#include "bag/described_images.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

std::string base_of_halls(const std::vector<std::string>& sites = {"hall"}) {
  const std::string conninfo = shared_postgres().new_base();
  PostgresStore store(conninfo);
  store.prepare();
  for (const std::string& site : sites) store.add_site(site, 0);
  return conninfo;
}

EntryInfo info_with(const ImageDescriptor& image) {
  EntryInfo info;
  info.image = image;
  return info;
}

const ImageDescriptor ones(test_image_kind(), Eigen::VectorXd::Ones(24));

FleetVersion version_with(const ImageDescriptor& image, const Uuid& robot, std::int64_t seq) {
  std::mt19937 random(3);
  FleetVersion version =
      version_of({"hall", robot, Uuid{9}, KeyframeId{static_cast<std::uint64_t>(seq)}},
                 info_with(image), random_graph(random, 5));
  version.seq = seq;
  return version;
}

}  // namespace

TEST_CASE("images go through outbox, server and follower to the last bit", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const ScratchFolder folder;
  const std::string conninfo = base_of_halls(), path = folder.path("map.db");
  std::mt19937 random(1);
  enlist(path, "hall");
  SqliteBag<> map(path);
  const FleetOutbox outbox(path);
  PostgresStore store(conninfo);
  FleetBag fleet({{conninfo, {"hall"}}});
  for (int step = 0; step < 120; ++step) {
    const KeyframeId id{random() % 20};
    const EntryInfo info = info_with(random_image(random));
    const auto graph = random_graph(random, 5);
    if (!map.contains(id)) {
      map.add(id, graph, info);
    } else if (random() % 4 == 0) {
      map.erase(id);
    } else if (random() % 3 == 0) {
      map.set_poses({{id, Eigen::Isometry3d(Eigen::Translation3d(step, 0, 0))}});
    } else {
      map.update(id, graph, info);
    }
    if (step % 10 != 9) continue;
    push(outbox, store);
    fleet.follow();
    const auto view = fleet.view();
    REQUIRE(view->size() == map.size());
    view->for_each([&](const FleetKey& key, const EntryInfo& followed, const auto&) {
      CHECK(followed.image == map.info(key.keyframe)->image);
    });
  }
  CHECK(fleet.refused().empty());
  CHECK(push(outbox, store) == 0);

  // Who follows looks up by images as who holds the map does.
  QueryOptions options;
  options.max_results = 100;
  options.image = {{test_image_kind(), Eigen::VectorXd::Unit(24, 2)}, 0.5, 0.5};
  const auto graph = random_graph(random, 6);
  const auto view = fleet.view();
  const auto expected = map.query(graph, options), found = view->query(graph, options);
  REQUIRE(found.size() == expected.size());
  CHECK(found.size() < view->size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(view->key(found[i].id).keyframe == expected[i].id);
    CHECK(found[i].similarity == expected[i].similarity);
  }
}

TEST_CASE("an outbox tells the image that its key frame has now", "[fleet]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  enlist(path, "hall");
  SqliteBag<> map(path);
  const FleetOutbox outbox(path);
  map.add(KeyframeId{1}, {}, info_with(ones));
  map.add(KeyframeId{2}, {});
  map.add(KeyframeId{3}, {}, info_with(ones));
  auto versions = outbox.after(0, 10);
  REQUIRE(versions.size() == 3);
  CHECK(versions[0].image == ones);
  CHECK(versions[0].info().image == ones);
  CHECK_FALSE(versions[1].image.known());
  map.update(KeyframeId{1}, {});
  map.erase(KeyframeId{3});
  map.set_poses({{KeyframeId{2}, Eigen::Isometry3d::Identity()}});
  versions = outbox.after(versions.back().seq, 10);
  REQUIRE(versions.size() == 3);
  for (const FleetVersion& version : versions) CHECK_FALSE(version.image.known());
}

TEST_CASE("a robot's other kind of images, and damaged ones, harm no other", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = base_of_halls();
  PostgresStore store(conninfo);
  const ImageDescriptor other(ImageKind("other", 65535), Eigen::VectorXd::Ones(65535));
  CHECK(store.append({version_with(ones, Uuid{1}, 1), version_with({}, Uuid{1}, 2)}) == 2);
  CHECK(store.append({version_with(other, Uuid{2}, 1)}) == 1);
  FleetBag fleet({{conninfo, {"hall"}}});
  CHECK(fleet.follow() == 3);
  CHECK(fleet.size() == 2);
  REQUIRE(fleet.refused().size() == 1);
  CHECK(fleet.refused().front().find("an image's descriptor of another kind (65535 numbers)") !=
        std::string::npos);
  FleetCursor cursor;
  const auto read = store.read("hall", cursor);
  CHECK(read.at(2).version.image == other);

  for (const std::string damage :
       {"image = '\\x00'", "image = ''", "image_checksum = 7", "image_checksum = NULL",
        "image_kind = NULL", "image_kind = 5", "image = image || '\\x01'"}) {
    const std::string changed = base_of_halls();
    PostgresStore there(changed);
    there.append({version_with(ones, Uuid{1}, 1), version_with({}, Uuid{1}, 2)});
    shared_postgres().sql(
        "ALTER TABLE topobag.version DISABLE TRIGGER append_only;"
        "UPDATE topobag.version SET " +
            damage + " WHERE seq = 1",
        changed);
    FleetBag careful({{changed, {"hall"}}});
    CAPTURE(damage);
    CHECK(careful.follow() == 2);
    CHECK(careful.size() == 1);
    CHECK(careful.refused().size() == 1);
  }
}

TEST_CASE("another image under one number is another content, an image alone is none", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = base_of_halls();
  PostgresStore store(conninfo);
  Eigen::VectorXd vector = Eigen::VectorXd::Ones(24);
  vector(3) = -0.5;
  CHECK(store.append({version_with(ones, Uuid{1}, 1), version_with({}, Uuid{1}, 2)}) == 2);
  CHECK(store.append({version_with(ones, Uuid{1}, 1), version_with(ones, Uuid{1}, 2)}) == 0);
  CHECK(store.append({version_with({}, Uuid{1}, 1)}) == 0);
  CHECK(error_text([&] {
          store.append({version_with({test_image_kind(), vector}, Uuid{1}, 1)});
        }).find("a copy of the map is in use") != std::string::npos);
}

TEST_CASE("roles have the rights to images that they have to versions", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = base_of_halls({"hall", "yard"});
  for (const char* role : {"painter", "viewer", "stranger"}) {
    shared_postgres().sql(std::string("CREATE ROLE ") + role + " LOGIN");
  }
  PostgresStore owner(conninfo);
  owner.admit("painter", "hall", Uuid{1});
  owner.admit("viewer", "hall");
  const auto as = [&](const std::string& role) {
    std::string changed = conninfo;
    return changed.replace(changed.find("user=owner"), 10, "user=" + role);
  };
  PostgresStore painter(as("painter"));
  CHECK(painter.append({version_with(ones, Uuid{1}, 1)}) == 1);
  CHECK_THROWS_AS(painter.append({version_with(ones, Uuid{2}, 1)}), Error);
  PostgresStore viewer(as("viewer"));
  CHECK_THROWS_AS(viewer.append({version_with(ones, Uuid{1}, 2)}), Error);
  const std::string images = "SELECT count(image) FROM topobag.version";
  CHECK(shared_postgres().sql(images, as("viewer")) == "1");
  CHECK(shared_postgres().sql(images, as("stranger")) == "0");
  for (const std::string& role : {as("painter"), as("viewer"), conninfo}) {
    CHECK_THROWS_AS(shared_postgres().sql("UPDATE topobag.version SET image = NULL", role),
                    std::runtime_error);
  }
}
