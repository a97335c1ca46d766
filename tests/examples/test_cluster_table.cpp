// SPDX-License-Identifier: MIT
#include <array>
#include <iomanip>
#include <random>
#include <sstream>
#include <string>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "cluster_table.hpp"
#include "run_program.hpp"
#include "scratch.hpp"

using namespace program;

namespace {

const std::string cluster_frames = "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw\n";
const std::string cluster_columns = "idx,class,conf,x,y,z,dx,dy,dz";

/// A drive past the same things, seen by a sensor with x forward and z up.
void write_drive(const ScratchFolder& folder, const std::string& set, double north, unsigned seed) {
  const std::array<const char*, 4> names{"bench", "fire hydrant", "potted plant", "stop sign"};
  std::mt19937 layout(3), random(seed);
  std::uniform_real_distribution<double> side(-12.0, 12.0), size(0.3, 1.5);
  std::normal_distribution<double> noise(0.0, 0.01);
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> things;
  for (int i = 0; i < 16; ++i) {
    const Eigen::Vector3d extent(size(layout), size(layout), size(layout));
    things.push_back({{side(layout), side(layout), 0.5 * extent.z() - 1.5}, extent});
  }
  std::ostringstream frames, clusters;
  frames << cluster_frames;
  clusters << std::setprecision(9) << cluster_columns << ",sx,sy,sz\n";
  for (int frame = 0; frame < 3; ++frame) {
    frames << frame << ",scan" << frame << ',' << frame << ',' << frame << ',' << north
           << ",0,0,0,0,1\n";
    for (std::size_t i = 0; i < things.size(); ++i) {
      clusters << frame << ',' << names[i % names.size()] << ",0.9";
      const Eigen::Vector3d here = things[i].first - Eigen::Vector3d(frame, north, 0.0);
      for (int k = 0; k < 3; ++k) clusters << ',' << here[k] + noise(random);
      for (int k = 0; k < 3; ++k) clusters << ',' << things[i].second[k];
      clusters << ",0.03,0.03,0.03\n";
    }
  }
  folder.write(set + ".frames.csv", frames.str());
  folder.write(set + ".clusters.csv", clusters.str());
}

std::string cluster_error(const std::string& row, const std::string& more = "") {
  const ScratchFolder folder;
  folder.write("s.frames.csv", cluster_frames + "0,a,1.0,0,0,0,0,0,0,1\n");
  folder.write("s.clusters.csv", cluster_columns + more + "\n" + row + "\n");
  return error_in(folder, [&] {
    read_cluster_table(folder.path("s"), topobag::ClassCatalog::coco80());
  });
}

}  // namespace

TEST_CASE("a table of clusters is read to the letter", "[examples]") {
  const ScratchFolder folder;
  folder.write("s.frames.csv", cluster_frames + "7,a,1.0,0,0,0,0,0,0,1\n");
  folder.write("s.clusters.csv", cluster_columns + ",sx,sy,sz\n7,bench,0.5,1,2,3,4,5,6,0.1,0.2,0.3\n");
  const auto table = read_cluster_table(folder.path("s"), topobag::ClassCatalog::coco80());
  REQUIRE(table.frames.at(0).clusters.size() == 1);
  const topobag::ObjectCluster& cluster = table.frames[0].clusters[0];
  CHECK(cluster.label == topobag::ClassCatalog::coco80().at("bench"));
  CHECK(cluster.confidence == 0.5);
  CHECK(cluster.centroid == Eigen::Vector3d(1, 2, 3));
  CHECK(cluster.extent == Eigen::Vector3d(4, 5, 6));
  CHECK(cluster.covariance.diagonal().isApprox(Eigen::Vector3d(0.01, 0.04, 0.09)));
}

TEST_CASE("clusters that are none are named by their line", "[examples]") {
  CHECK(cluster_error("0,bench,0.5,1,2,3,4,5,6") == "nothing was thrown");
  CHECK(cluster_error("3,bench,0.5,1,2,3,4,5,6").find("idx 3 is not among the frames") !=
        std::string::npos);
  CHECK(cluster_error("0,bench,0.5,1,2,3,0,0,0") == "nothing was thrown");
  CHECK(cluster_error("0,bench,0.5,1,2,3,4,-5,6").find("dx, dy and dz, the cluster's size, have") !=
        std::string::npos);
  CHECK(cluster_error("0,sphinx,0.5,1,2,3,4,5,6").find("sphinx") != std::string::npos);
  CHECK(cluster_error("0,bench,0.5,1,2,3,4,5,6,1,0,1", ",sx,sy,sz").find("have to be positive") !=
        std::string::npos);
}

TEST_CASE("a map of clusters is made and looked up in without a camera", "[examples]") {
  const ScratchFolder folder;
  write_drive(folder, "map", 0.0, 1);
  write_drive(folder, "query", 0.5, 2);
  const std::string tables = "localize --map '" + folder.path("map") + "' --query '" +
                             folder.path("query") + "' --keyframe-interval 0 --window 0 ";
  const ProgramRun run = run_program(tables + "--clusters --json");
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const auto found = nlohmann::json::parse(run.out);
  CAPTURE(run.out);
  CHECK(found.at("accepted") == 3);
  CHECK(found.at("correct") == 3);
  CHECK(refusal(tables).find("--camera") != std::string::npos);
  CHECK(refusal(tables + "--clusters --drop 0.5").find("are for boxes") != std::string::npos);
}
