// SPDX-License-Identifier: MIT
#include <topobag/bag/detail/index/camera_grid.hpp>

#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "catch.hpp"

using namespace topobag;

namespace {

EntryInfo seen_from(const Eigen::Vector3d& at) {
  EntryInfo info;
  info.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(at));
  return info;
}

}  // namespace

TEST_CASE("a grid finds the cameras of a region as looking at all does", "[bag]") {
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 random(seed);
    // Crowded, or strewn over more cells than are filled.
    std::uniform_real_distribution<double> metres(seed % 2 == 0 ? -8.0 : -200.0, 8.0);
    std::uniform_real_distribution<double> radius(0.0, seed % 3 == 0 ? 300.0 : 10.0);
    std::uniform_int_distribution<std::uint64_t> id_of(0, 150);
    detail::CameraGrid grid;
    std::map<KeyframeId, EntryInfo> model;
    const auto somewhere = [&] {
      return Eigen::Vector3d(metres(random), metres(random), metres(random));
    };
    for (int step = 0; step < 500; ++step) {
      const KeyframeId id{id_of(random)};
      const auto known = model.find(id);
      if (known != model.end()) {
        grid.remove(id, known->second);
        model.erase(known);
      } else {
        model[id] = value(id) % 7 == 0 ? EntryInfo{} : seen_from(somewhere());
        grid.add(id, model[id]);
      }
      const MapRegion region{somewhere(), radius(random)};
      std::vector<KeyframeId> expected;
      for (const auto& [entry, info] : model) {
        if (info.T_world_camera && region.contains(info.T_world_camera->translation())) {
          expected.push_back(entry);
        }
      }
      CHECK(grid.within(region) == expected);
    }
    grid.clear();
    CHECK(grid.within({Eigen::Vector3d::Zero(), 1e3}).empty());
  }
}

TEST_CASE("a grid takes cameras at the ends of the world", "[bag]") {
  const double far = std::numeric_limits<double>::max();
  detail::CameraGrid grid;
  grid.add(KeyframeId{1}, seen_from({far, -far, 0.0}));
  grid.add(KeyframeId{2}, seen_from({0.0, 0.0, 0.0}));
  CHECK(grid.within({Eigen::Vector3d(far, -far, 0.0), 1.0}) ==
        std::vector<KeyframeId>{KeyframeId{1}});
  CHECK(grid.within({Eigen::Vector3d::Zero(), 1.0}) == std::vector<KeyframeId>{KeyframeId{2}});
}
