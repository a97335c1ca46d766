// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "catch.hpp"
#include "keyframe_graphs.hpp"
#include "run_program.hpp"
#include "sample.hpp"
#include "saved_map.hpp"

namespace {

/// A sample's key frames, whose world lies at `T_world_sample`.
program::SavedMap sample_map_at(const std::string& table, const Eigen::Isometry3d& T_world_sample) {
  program::KeyframeOptions options;
  options.camera = {517.3, 516.5, 318.6, 255.3, 640, 480};
  options.interval = 0.0;
  auto keyframes = program::read_keyframes(table, options);
  for (auto& keyframe : keyframes) {
    keyframe.T_world_camera = T_world_sample * *keyframe.T_world_camera;
  }
  return {"", {{0, "a run"}}, program::new_entries(topobag::BagOfTopologyGraphs<>(), keyframes)};
}

}  // namespace

TEST_CASE("two maps of one desk become one", "[examples]") {
  const ScratchFolder folder;
  const Eigen::Isometry3d T_map_other =
      Eigen::Translation3d(3.0, 1.0, 0.5) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  const auto map = sample_map_at(sample_map, Eigen::Isometry3d::Identity());
  const auto other = sample_map_at(sample_query, T_map_other.inverse());
#ifdef TOPOBAG_HAS_SQLITE
  const std::string ours = folder.path("a.db"), joined = folder.path("c.db");
  const std::string theirs = folder.path("b.db");  // a snapshot knows no names of sessions
#else
  const std::string ours = folder.path("a.bag"), joined = folder.path("c.bag");
  const std::string theirs = folder.path("b.bag");
#endif
  program::write_new_map(ours, map, {});
  program::write_new_map(theirs, other, {});
  const std::string command = "merge " + ours + ' ' + theirs + " --out " + joined;
  const ProgramRun run = run_program(command);
  CAPTURE(run.err, run.out);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find(joined + ": ") == 0);
  const auto both = program::read_saved_map(joined);
  CHECK(both.bag.size() == map.bag.size() + other.bag.size());
#ifdef TOPOBAG_HAS_SQLITE
  REQUIRE(both.sessions.size() == 2);
  CHECK(both.sessions[1].id == 1);
  CHECK(both.sessions[1].name == "a run");
#endif
  // Where the cameras of the other map stand, by the trajectory of the sample.
  const auto truth = sample_map_at(sample_query, Eigen::Isometry3d::Identity());
  std::vector<Eigen::Isometry3d> stood, found;
  truth.bag.for_each([&](topobag::KeyframeId, const topobag::EntryInfo& info, const auto&) {
    stood.push_back(*info.T_world_camera);
  });
  both.bag.for_each([&](topobag::KeyframeId, const topobag::EntryInfo& info, const auto&) {
    if (info.session == 1) found.push_back(*info.T_world_camera);
  });
  REQUIRE(found.size() == stood.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK((found[i].translation() - stood[i].translation()).norm() < 0.15);
  }
  CHECK(refusal(command) == joined + ": it exists; give another name");
}

TEST_CASE("maps without poses are not joined", "[examples]") {
  const ScratchFolder folder;
  auto map = sample_map_at(sample_map, Eigen::Isometry3d::Identity());
  program::write_new_map(folder.path("a.bag"), map, {});
  map.bag.clear();
  program::write_new_map(folder.path("b.bag"), map, {});
  const std::string a = folder.path("a.bag"), b = folder.path("b.bag");
  for (const std::string& maps : {a + ' ' + b, b + ' ' + a}) {
    CHECK(refusal("merge " + maps + " --out " + folder.path("c.bag"))
              .find(b + ": a map has no key frame with a pose") == 0);
  }
}

TEST_CASE("merge refuses before the work what it cannot do", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string a = folder.path("a.bag"), b = folder.path("b.map");
  const auto map = sample_map_at(sample_map, Eigen::Isometry3d::Identity());
  program::write_new_map(a, map, {});
  program::write_new_map(b, map, {});
  const std::string twice =
      ": the map holds these key frames already, as session 0: mapped twice, "
      "a place is found by itself";
  CHECK(refusal("merge " + a + ' ' + a + " --out " + folder.path("c.bag")) == a + twice);
  CHECK(refusal("merge " + a + ' ' + b + " --out " + folder.path("c.bag")) == a + twice);
  CHECK(refusal("merge " + a + ' ' + b + " --out " + folder.path("no/c.bag")) ==
        "--out " + folder.path("no/c.bag") + ": the folder does not exist; make it first");
  CHECK(refusal("merge " + a + ' ' + b + " --out " + folder.path()) ==
        "--out " + folder.path() + ": it is a folder; name a file in it");
  CHECK(refusal("merge " + a + ' ' + b + " --out 'postgresql://localhost/x?site=a'") ==
        "--out: merge writes a file, which `topobag fleet push` sends to a server");
}
