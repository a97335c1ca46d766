// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <topobag/adaptors/orb_slam/sightings_file.hpp>

#include "adaptors/small_host.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

TEST_CASE("sightings are kept in a file beside the host's map", "[adaptors]") {
  const ScratchFolder folder;
  const std::string path = folder.path("atlas.sightings");
  SavedSighting saved;
  saved.id = 5;
  saved.sighting = small_host::sighting(SyntheticRoom(7, 9, 4), 1.5, Eigen::Isometry3d::Identity());
  save_sightings({saved}, path);
  const std::vector<SavedSighting> back = load_sightings(path);
  REQUIRE(back.size() == 1);
  CHECK(back[0].id == 5);
  CHECK(back[0].sighting.stamp == 1.5);
  CHECK(back[0].sighting.nodes.size() == 9);

  CHECK_THROWS_AS(load_sightings(folder.path("none")), Error);
  CHECK_THROWS_AS(save_sightings({saved}, folder.path()), Error);
  const std::string other = folder.write("other", "a file of somebody else's, long enough");
  CHECK(error_text([&] { load_sightings(other); }) ==
        other + ": these are no sightings of topobag, or they are cut off");
}
