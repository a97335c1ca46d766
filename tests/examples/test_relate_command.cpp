// SPDX-License-Identifier: MIT
#include <array>
#include <random>
#include <sstream>

#include <nlohmann/json.hpp>

#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"
#include "desk_of_objects.hpp"
#include "run_program.hpp"

namespace {

constexpr std::array<const char*, 5> relate_names{"cup", "book", "bottle", "keyboard", "mouse"};
const std::string relate_camera = " --camera 500,500,319.5,239.5,640,480 --keyframe-interval 0 ";

/// A desk before a camera that moves to its right, seen in five images.
void write_desk(const ScratchFolder& folder, const std::string& set,
                const std::vector<Eigen::Vector3d>& objects) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.005);
  std::ostringstream frames, nodes;
  frames << "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw\n";
  nodes << "idx,class,conf,u,v,w,h,z\n";
  for (int frame = 0; frame < 5; ++frame) {
    const double x = 0.1 * frame;
    frames << frame << ",f" << frame << ',' << 0.2 * frame << ',' << x << ",0,0,0,0,0,1\n";
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Eigen::Vector3d at = objects[i] - Eigen::Vector3d(x, 0, 0);
      const double z = at.z() * (1.0 + noise(random));
      const double u = 319.5 + 500.0 * at.x() / at.z(), v = 239.5 + 500.0 * at.y() / at.z();
      if (u < 25.0 || u > 614.0) continue;
      nodes << frame << ',' << relate_names[i % 5] << ",0.9," << u << ',' << v << ",20,20," << z
            << '\n';
    }
  }
  folder.write(set + ".frames.csv", frames.str());
  folder.write(set + ".nodes.csv", nodes.str());
}

std::vector<Eigen::Vector3d> desk_before_camera(unsigned seed) {
  auto objects = strewn_objects(22, seed);
  for (auto& p : objects) p = Eigen::Vector3d(p.x() - 1.3, p.z() - 0.2, p.y() + 2.4);
  return objects;
}

}  // namespace

TEST_CASE("another system's map with other words is related and localized in", "[examples]") {
  const ScratchFolder folder;
  const auto objects = desk_before_camera(11);
  write_desk(folder, "query", objects);
  write_desk(folder, "other", desk_before_camera(12));
  std::vector<int> words, classes;
  const topobag::ClassCatalog coco = topobag::ClassCatalog::coco80();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    words.push_back(static_cast<int>(i % 5));
    classes.push_back(topobag::value(coco.at(relate_names[i % 5])));
  }
  const auto there = mapped_elsewhere(objects, some_motion(), 1.06, 0.02, 13);
  folder.write("words.json", object_map_text(there, words));
  folder.write("coco.json", object_map_text(there, classes));
  folder.write("words.txt", "mug\ntome\nflask\ntypewriter\nrodent\n");
  const std::string map = " --map " + folder.path("words.json") + " --map-words " +
                          folder.path("words.txt") + relate_camera;
  const std::string relation = folder.path("relation.json");

  const ProgramRun related =
      run_program("relate --query " + folder.path("query") + map + "--out " + relation);
  CAPTURE(related.err, related.out);
  REQUIRE(related.exit_code == 0);
  CHECK(related.out.find("rodent (map): 4 mouse") != std::string::npos);
  CHECK(refusal("relate --query " + folder.path("other") + map + "--out " + relation)
            .find("no alignment is believed: ") != std::string::npos);

  // No relation is written over what it was learnt from.
  for (const std::string file : {"words.json", "query.nodes.csv"}) {
    const std::string before = content_of(folder.path(file));
    CHECK(refusal("relate --query " + folder.path("query") + map + "--out " + folder.path(file))
              .find("--out " + folder.path(file) + ": the file is also that of --") == 0);
    CHECK(content_of(folder.path(file)) == before);
  }

  const std::string common = " --align-worlds --json --window 0";
  const ProgramRun found = run_program("localize --query " + folder.path("query") + map +
                                       "--map-relation " + relation + common);
  CAPTURE(found.err);
  REQUIRE(found.exit_code == 0);
  CHECK(found.err.empty());
  const auto json = nlohmann::json::parse(found.out);
  CHECK(json.at("accepted") == 5);
  CHECK(json.at("correct") == 5);
  CHECK(json.at("T_map_query_world").size() == 7);

  // Without the words nothing is alike; a map in the queries' own words needs no relation.
  CHECK(refusal("localize --query " + folder.path("query") + " --map " + folder.path("coco.json") +
                " --map-relation " + relation + relate_camera)
            .find(relation + ": it was learnt of words.json by other classes than these") == 0);
  const std::string alike = " --map " + folder.path("coco.json") + relate_camera;
  const auto plain = nlohmann::json::parse(
      run_program("localize --query " + folder.path("query") + alike + common).out);
  CHECK(plain.at("correct") == 5);
  const auto elsewhere = nlohmann::json::parse(
      run_program("localize --query " + folder.path("other") + alike + common).out);
  CHECK(elsewhere.at("accepted") == 0);

  // Another map in the same words, or who knows which, is told.
  folder.write("copy.json", content_of(folder.path("words.json")));
  const auto told_with = [&](const std::string& name, const std::string& file) {
    const ProgramRun run =
        run_program("localize --query " + folder.path("query") + " --map " + folder.path(name) +
                    " --map-words " + folder.path("words.txt") + relate_camera + "--map-relation " +
                    file + common);
    CHECK(nlohmann::json::parse(run.out).at("correct") == 5);
    return run.err;
  };
  CHECK(told_with("copy.json", relation) ==
        "topobag: " + relation + " was learnt of words.json and is used for " +
            folder.path("copy.json") + ": scale, deviation and words are those of the other\n");
  auto earlier = nlohmann::json::parse(content_of(relation));
  earlier.erase("map");
  earlier.erase("catalog");
  const std::string old = folder.write("old.json", earlier.dump());
  CHECK(told_with("words.json", old) ==
        "topobag: " + old + " does not say of which map it was learnt, and is taken for one of " +
            folder.path("words.json") + "; `topobag relate` writes one that does\n");
}

TEST_CASE("a map of objects is saved as a map", "[examples]") {
  const ScratchFolder folder;
  const auto objects = desk_before_camera(11);
  write_desk(folder, "query", objects);
  const topobag::ClassCatalog coco = topobag::ClassCatalog::coco80();
  std::vector<int> classes;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    classes.push_back(topobag::value(coco.at(relate_names[i % 5])));
  }
  folder.write("coco.json", object_map_text(objects, classes));
  REQUIRE(run_program("map --clusters --nodes " + folder.path("coco.json") + " --out " +
                      folder.path("saved.map"))
              .exit_code == 0);
  const auto localized = [&](const std::string& map) {
    const ProgramRun run = run_program("localize --json --window 0 --query " +
                                       folder.path("query") + " --map " + map + relate_camera);
    CAPTURE(run.err);
    return nlohmann::json::parse(run.out);
  };
  const auto saved = localized(folder.path("saved.map")),
             read = localized(folder.path("coco.json"));
  CHECK(read.at("correct") == 5);  // the two worlds are one here
  CHECK(saved.at("correct") == 5);
}
