// SPDX-License-Identifier: MIT
#include <memory>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam/asked_key_frames.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("a key frame may be found by its map, unless it is bad or excluded", "[adaptors]") {
  std::mt19937 random(2);
  atlas_host::Map maps[3];
  std::vector<std::unique_ptr<atlas_host::KeyFrame>> key_frames;
  for (unsigned long id = 0; id < 40; ++id) {
    key_frames.push_back(std::make_unique<atlas_host::KeyFrame>(atlas_host::KeyFrame{
        id, 0.0, Eigen::Isometry3d::Identity(), &maps[random() % 3], random() % 4 == 0}));
  }
  for (const AskedMaps which : {AskedMaps::all, AskedMaps::this_one, AskedMaps::others}) {
    AskedKeyFrames<atlas_host::KeyFrame> asked;
    asked.maps = which;
    asked.map = &maps[1];
    for (std::size_t i = 0; i < key_frames.size(); i += 5) {
      asked.excluded.insert(key_frames[i].get());
    }
    std::size_t found = 0;
    for (std::size_t i = 0; i < key_frames.size(); ++i) {
      const atlas_host::KeyFrame& key_frame = *key_frames[i];
      const bool own = key_frame.map == &maps[1];
      const bool in_maps = which == AskedMaps::all || (which == AskedMaps::this_one ? own : !own);
      const bool expected = in_maps && !key_frame.bad && i % 5 != 0;
      CHECK(asked.contains(*key_frames[i]) == expected);
      found += expected ? 1U : 0U;
    }
    CHECK(found > 0);
  }
}
