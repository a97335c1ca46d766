// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/scaled_graph.hpp>

#include "catch.hpp"
#include "keyframe_graphs.hpp"
#include "run_program.hpp"
#include "sample.hpp"
#include "saved_map.hpp"

namespace {

/// A sample's key frames, whose world lies at `T_world_sample`, in a unit of so many metres.
program::SavedMap sample_map_at(const std::string& table, const Eigen::Isometry3d& T_world_sample,
                                double unit = 1.0) {
  program::KeyframeOptions options;
  options.camera = {517.3, 516.5, 318.6, 255.3, 640, 480};
  options.interval = 0.0;
  auto keyframes = program::read_keyframes(table, options);
  for (auto& keyframe : keyframes) {
    keyframe.T_world_camera = T_world_sample * *keyframe.T_world_camera;
    keyframe.T_world_camera->translation() /= unit;
    keyframe.graph = topobag::scaled(keyframe.graph, 1.0 / unit);
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

TEST_CASE("a map in an unknown unit is joined up to scale", "[examples]") {
  const ScratchFolder folder;
  const Eigen::Isometry3d T_map_other =
      Eigen::Translation3d(3.0, 1.0, 0.5) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  const std::string ours = folder.path("a.bag"), theirs = folder.path("b.bag");
  const std::string joined = folder.path("c.bag");
  program::write_new_map(ours, sample_map_at(sample_map, Eigen::Isometry3d::Identity()), {});
  program::write_new_map(theirs, sample_map_at(sample_query, T_map_other.inverse(), 0.5), {});
  const std::string command = "merge " + ours + ' ' + theirs + " --out " + joined;
  CHECK(refusal(command).find(theirs + ": too few key frames of one map are recognised") == 0);
  const ProgramRun run = run_program(command + " --unknown-scale");
  CAPTURE(run.err, run.out);
  REQUIRE(run.exit_code == 0);
  const std::string told = ", 1 unit of " + theirs + " is ";
  const std::size_t at = run.out.find(told);
  REQUIRE(at != std::string::npos);
  std::istringstream words(run.out.substr(at + told.size()));
  double scale = 0.0, deviation = 0.0;
  std::string sign, rest;
  words >> scale >> sign >> deviation;
  std::getline(words, rest);
  CHECK(sign == "±");
  CHECK(rest.find(" m of " + ours + " (") == 0);
  CHECK(std::abs(scale - 0.5) < 0.02);
  CHECK(deviation > 0.0);
  CHECK(deviation < 0.02);
  // In the map's unit, every key frame of both is where the sample's trajectory has it.
  const auto truth = sample_map_at(sample_query, Eigen::Isometry3d::Identity());
  std::vector<topobag::EntryInfo> stood;
  std::vector<topobag::TopologyGraph<>> seen;
  truth.bag.for_each([&](topobag::KeyframeId, const auto& info, const auto& graph) {
    stood.push_back(info);
    seen.push_back(graph);
  });
  std::size_t found = 0;
  program::read_saved_map(joined).bag.for_each(
      [&](topobag::KeyframeId, const auto& info, const auto& graph) {
        if (info.session == 0) return;
        REQUIRE(found < stood.size());
        const Eigen::Isometry3d& T_true = *stood[found].T_world_camera;
        CHECK((info.T_world_camera->translation() - T_true.translation()).norm() < 0.2);
        REQUIRE(graph.size() == seen[found].size());
        CHECK(graph.nodes()[0].z == Approx(seen[found].nodes()[0].z).epsilon(0.05));
        ++found;
      });
  CHECK(found == stood.size());
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
