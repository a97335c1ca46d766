// SPDX-License-Identifier: MIT
#include <topobag/adaptors/orb_slam/orb_slam_options.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("few candidates change nothing but their number", "[adaptors]") {
  const RecognitionOptions few = OrbSlamOptions::few_candidates(7), usual;
  CHECK(few.retrieval.max_results == 7);
  CHECK_FALSE(few.retrieval.restricts());
  CHECK(few.decision.threshold(10) == usual.decision.threshold(10));
  CHECK(OrbSlamOptions{}.recognition.retrieval.max_results < usual.retrieval.max_results);
}

TEST_CASE("with a catalog, its look-alikes and sizes are known, and few candidates matched",
          "[adaptors]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  const OrbSlamOptions options = orb_slam_options(catalog);
  const auto& classes = options.recognition.matching.consistency.classes;
  const ClassId tv = catalog.at("tv"), laptop = catalog.at("laptop");
  CHECK(classes.group(tv) == classes.group(laptop));
  CHECK(classes.group(tv) != classes.group(catalog.at("cup")));
  CHECK_FALSE(options.recognition.matching.chance.sizes.classes.empty());
  const OrbSlamOptions usual;
  CHECK(options.recognition.retrieval.max_results == usual.recognition.retrieval.max_results);
  CHECK(options.fusing.window == usual.fusing.window);
  const OrbSlamOptions outdoors = orb_slam_options(catalog, SensorProfile::lidar());
  CHECK(outdoors.fusing.max_depth == SensorProfile::lidar().detection_range);
  CHECK(outdoors.recognition.place.radius == SensorProfile::lidar().place_radius);
}

TEST_CASE("loops are older than the gap that is asked for, to the second", "[adaptors]") {
  for (const double gap : {5.0, 20.0}) {
    OrbSlamOptions options = atlas_host::single_frames();
    options.min_loop_gap = gap;
    atlas_host::Session session(4, options);
    atlas_host::KeyFrame& old = session.mapped(0.0, session.first);
    session.mapped(1.0, session.first);
    atlas_host::KeyFrame& now = session.mapped(gap + 0.5, session.first);
    atlas_host::Pointers loops, merges;
    session.database.DetectNBestCandidates(&now, loops, merges, 3);
    CHECK(loops == atlas_host::Pointers{&old});
  }
}
