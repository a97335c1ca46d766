// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <topobag/adaptors/fleet_bag.hpp>

#include "bag/described_images.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

/// A robot with a map of its own, which tells the fleet of it.
class SimulatedRobot {
 public:
  SimulatedRobot(const std::string& folder, const std::string& site, std::uint64_t first_id)
      : path_(folder + "/" + topobag::to_text(robot_) + ".db"), next_id_(first_id) {
    topobag::enlist(path_, site, robot_);
    restart();
  }

  /// Opens its map again, as a robot that lost power.
  void restart() {
    map_.reset();
    map_.emplace(path_);
    outbox_.emplace(path_);
  }

  void add(std::mt19937& random, const topobag::TopologyGraph<>& graph) {
    topobag::EntryInfo info = some_info(random);
    if (map_->sessions().size() <= info.session) info.session = map_->begin_session("a run");
    map_->add(topobag::KeyframeId{next_id_++}, graph, info);
  }
  void update(std::mt19937& random, const topobag::TopologyGraph<>& graph) {
    if (const auto id = some_id(random)) map_->update(*id, graph, some_info(random));
  }
  void erase(std::mt19937& random) {
    if (const auto id = some_id(random)) map_->erase(*id);
  }

  const topobag::FleetOutbox& outbox() const { return *outbox_; }
  const topobag::SqliteBag<>& map() const { return *map_; }

  /// Adds its key frames, by their keys, to what the whole fleet knows.
  template <typename Union>
  void tell(Union& all) const {
    const topobag::detail::SqliteConnection file(path_, true);
    map_->bag().for_each([&](topobag::KeyframeId id, const topobag::EntryInfo& info,
                             const topobag::TopologyGraph<>& graph) {
      topobag::detail::SqliteStatement session(file,
                                               "SELECT uuid FROM fleet_session WHERE session = ?");
      session.bind(std::int64_t{info.session}).step();
      topobag::FleetKey key{outbox_->member().site, robot_, {}, id};
      const std::vector<std::uint8_t> uuid = session.blob(0);
      std::copy(uuid.begin(), uuid.end(), key.session.begin());
      all.emplace(key, std::make_pair(info, graph));
    });
  }

 private:
  static topobag::EntryInfo some_info(std::mt19937& random) {
    topobag::EntryInfo info;
    info.image = random_image(random);
    info.session = static_cast<std::uint32_t>(random() % 2);
    if (random() % 4 != 0) info.stamp = static_cast<double>(random()) / 7.0;
    if (random() % 4 != 0) {
      info.T_world_camera = Eigen::Isometry3d(Eigen::AngleAxisd(
          static_cast<double>(random() % 300) / 100.0, Eigen::Vector3d(1, 2, 3).normalized()));
      info.T_world_camera->translation() = Eigen::Vector3d(static_cast<double>(random() % 9), 1, 2);
    }
    return info;
  }
  std::optional<topobag::KeyframeId> some_id(std::mt19937& random) const {
    std::vector<topobag::KeyframeId> ids;
    map_->bag().for_each(
        [&](topobag::KeyframeId id, const auto&, const auto&) { ids.push_back(id); });
    if (ids.empty()) return std::nullopt;
    return ids[random() % ids.size()];
  }

  topobag::Uuid robot_ = topobag::random_uuid();
  std::string path_;
  std::uint64_t next_id_;
  std::optional<topobag::SqliteBag<>> map_;
  std::optional<topobag::FleetOutbox> outbox_;
};

/// What all robots' maps hold, by key.
using FleetUnion =
    std::map<topobag::FleetKey, std::pair<topobag::EntryInfo, topobag::TopologyGraph<>>>;

/// Holds a view against one bag over the union: the same key frames, and the same answers to
/// `queries`, to the last bit.
inline void require_union(const topobag::FleetView& view, const FleetUnion& all,
                          const std::vector<topobag::TopologyGraph<>>& queries) {
  REQUIRE(view.size() == all.size());
  topobag::BagOfTopologyGraphs<topobag::TopologyGraph<>, topobag::ClassPairDistanceHistogram> bag;
  std::vector<topobag::FleetKey> keys;
  for (const auto& [key, entry] : all) {
    bag.add(topobag::KeyframeId{keys.size()}, entry.second, entry.first);
    keys.push_back(key);
  }
  std::size_t at = 0;
  view.for_each([&](const topobag::FleetKey& key, const topobag::EntryInfo& info,
                    const topobag::TopologyGraph<>& graph) {
    REQUIRE(key == keys[at]);
    const auto& [expected, expected_graph] = all.at(keys[at++]);
    REQUIRE(info.stamp == expected.stamp);
    REQUIRE(info.label == expected.label);
    REQUIRE(info.image == expected.image);
    REQUIRE(info.T_world_camera.has_value() == expected.T_world_camera.has_value());
    if (info.T_world_camera) {
      REQUIRE(info.T_world_camera->matrix() == expected.T_world_camera->matrix());
    }
    REQUIRE(topobag::encode(graph) == topobag::encode(expected_graph));
  });
  for (const topobag::TopologyGraph<>& query : queries) {
    for (const std::size_t results : {std::size_t{1}, std::size_t{3}, std::size_t{1000}}) {
      topobag::QueryOptions options;
      options.max_results = results;
      const auto expected = bag.query(query, options);
      const auto found = view.query(query, options);
      REQUIRE(found.size() == expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        REQUIRE(view.key(found[i].id) == keys[value(expected[i].id)]);
        REQUIRE(found[i].similarity == expected[i].similarity);
      }
    }
  }
}
