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
