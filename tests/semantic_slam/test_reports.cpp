// SPDX-License-Identifier: MIT
// What the program beside an ORB-SLAM prints, and what it refuses before it begins.
#include <sstream>
#include <string>
#include <vector>

#include <reports.hpp>
#include <tum_sequence.hpp>

#include "catch.hpp"
#include "scratch_folder.hpp"

namespace {

/// A camera that stands still at the origin for a tenth of a second.
topobag::Trajectory still_truth() {
  return {{0.0, Eigen::Isometry3d::Identity()},
          {0.05, Eigen::Isometry3d::Identity()},
          {0.1, Eigen::Isometry3d::Identity()}};
}

semantic::OfferedPlaces offered_at(double stamp, double x, bool by_bearings, int accepted) {
  semantic::OfferedPlaces offered;
  offered.stamp = stamp;
  offered.verified = 1;
  offered.by_bearings = by_bearings;
  offered.accepted = accepted;
  offered.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, 0.0));
  return offered;
}

}  // namespace

TEST_CASE("a line of times leaves the look of other numbers as it was", "[hooks][regression]") {
  std::ostringstream out;
  semantic::print_times("stage", {3.0, 1.0, 2.0}, out);
  CHECK(out.str() == "  stage                                    3     2.00     2.00     3.00\n");
  out << 0.012345;
  CHECK(out.str().substr(out.str().find('\n') + 1) == "0.012345");
}

TEST_CASE("the places of the frames shown are counted, with depth and without", "[hooks]") {
  std::vector<semantic::OfferedPlaces> places{offered_at(0.0, 0.1, false, 0),
                                              offered_at(0.05, 0.5, true, -1),
                                              offered_at(0.1, 0.1, true, -1)};
  semantic::OfferedPlaces guess = offered_at(0.1, 0.0, false, -1);
  guess.verified = 0;
  guess.guesses = 2;
  guess.T_world_camera.reset();
  places.push_back(guess);
  std::ostringstream out;
  semantic::report_places(places, {0.05}, still_truth(), topobag::Alignment(), out);
  const std::string text = out.str();
  CAPTURE(text);
  CHECK(text.find("by objects alone: 3 verified, 1 of them not within 0.3 m and 15 degrees; by "
                  "objects or the host: 3; frames with guesses alone: 1; the host took the "
                  "objects' pose in 1\n") == 0);
  CHECK(text.find("without depth, by directions: 2 frames asked, 2 verified, 1 of them not within "
                  "0.3 m and 15 degrees\n") != std::string::npos);
}

TEST_CASE("candidates that the truth does not know are told apart from right ones",
          "[hooks][regression]") {
  const ScratchFolder folder;
  const std::vector<semantic::OfferedLoop> offered{{0.0, 0.1, Eigen::Isometry3d::Identity()},
                                                   {0.0, 50.0, Eigen::Isometry3d::Identity()}};
  const auto said = [&](const topobag::Trajectory& truth) {
    std::ostringstream out;
    semantic::report_offers("loop", offered, truth, 1.0, folder.path("loops.csv"), out);
    return out.str();
  };
  CHECK(said(still_truth()) ==
        "loop candidates offered: 2, of which the truth knows: 1, wrong by the truth: 0\n");
  CHECK(said({}) ==
        "loop candidates offered: 2, of which the truth knows: 0, wrong by the truth: 0\n");
}

TEST_CASE("candidates in a host's own unit are scored in metres", "[hooks]") {
  const ScratchFolder folder;
  const topobag::Trajectory walk{{0.0, Eigen::Isometry3d::Identity()},
                                 {0.05, Eigen::Isometry3d(Eigen::Translation3d(1.0, 0.0, 0.0))},
                                 {0.1, Eigen::Isometry3d(Eigen::Translation3d(2.0, 0.0, 0.0))}};
  const std::vector<semantic::OfferedLoop> offered{
      {0.1, 0.0, Eigen::Isometry3d(Eigen::Translation3d(4.0, 0.0, 0.0))}};
  const auto said = [&](double scale) {
    std::ostringstream out;
    semantic::report_offers("loop", offered, walk, scale, folder.path("loops.csv"), out);
    return out.str();
  };
  CHECK(said(0.5) == "loop candidates offered: 1, wrong by the truth: 0\n");
  CHECK(content_of(folder.path("loops.csv")).find(",0,0\n") != std::string::npos);
  CHECK(said(1.0) == "loop candidates offered: 1, wrong by the truth: 1\n");
}

TEST_CASE("how often the bag has merge candidates is told beside the host's own", "[hooks]") {
  std::ostringstream out;
  semantic::report_merges({9, 6, 5, 4}, out);
  CHECK(out.str() ==
        "key frames asked for merges: 9; with candidates of the host: 6, of the bag: 5, of both: "
        "4\n");
}

TEST_CASE("a kidnapped camera is not scored without a truth", "[hooks][regression]") {
  const ScratchFolder folder;
  CHECK(semantic::read_truth(folder.path()).empty());
  CHECK_THROWS_AS(semantic::required_truth(folder.path()), topobag::Error);
  folder.write("groundtruth.txt", "# no poses\n");
  CHECK_THROWS_AS(semantic::required_truth(folder.path()), topobag::Error);
  folder.write("groundtruth.txt", "1.5 0 0 0 0 0 0 1\n");
  CHECK(semantic::required_truth(folder.path()).size() == 1);
}
