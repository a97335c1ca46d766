// SPDX-License-Identifier: MIT
#include "catch.hpp"
#include "desk_of_objects.hpp"
#include "map_relation.hpp"
#include "scratch.hpp"

using namespace program;
using topobag::ClassId;

namespace {

constexpr double planted_scale = 1.1, planted_deviation = 0.02;

/// Objects of classes 0 … 4 in a query, which the map calls 80 … 84.
Keyframe query_of(const std::vector<Eigen::Vector3d>& objects) {
  std::vector<topobag::SemanticNode<>> nodes;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    topobag::SemanticNode<> node;
    node.label = ClassId{static_cast<int>(i % 5)};
    node.position = objects[i];
    node.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    nodes.push_back(node);
  }
  Keyframe query;
  query.graph = topobag::TopologyGraph<>(std::move(nodes));
  return query;
}

std::vector<MappedObject> map_of(const std::vector<Eigen::Vector3d>& objects, unsigned seed) {
  std::vector<MappedObject> map;
  for (const auto& at : mapped_elsewhere(objects, some_motion(), planted_scale,
                                         planted_scale * planted_deviation, seed)) {
    map.push_back({{{ClassId{80 + static_cast<int>(map.size() % 5)}, 1.0}}, at, {}});
  }
  return map;
}

}  // namespace

TEST_CASE("scale, deviation and words are learnt from geometry alone", "[examples]") {
  const auto objects = strewn_objects(25, 7);
  const auto learnt = learn_relation(map_of(objects, 8), query_of(objects));
  REQUIRE(learnt);
  CHECK(learnt->objects >= 23);
  CHECK(learnt->significance > 10.0);
  CHECK(learnt->next_best < learnt->significance - 5.0);
  CHECK(learnt->relation.scale == Approx(planted_scale).epsilon(0.02));
  CHECK(learnt->relation.deviation > 0.01);
  CHECK(learnt->relation.deviation < 0.03);
  double right = 0.0, wrong = 0.0;
  for (const SharedObjects& shared : learnt->relation.classes) {
    const bool same = value(shared.map) - 80 == value(shared.query);
    (same ? right : wrong) += shared.count;
  }
  CHECK(right >= 23.0);
  CHECK(wrong <= 1.0);
}

TEST_CASE("layouts that have nothing in common are not taken for one", "[examples]") {
  const topobag::DecisionOptions decision;
  int proposed = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    const auto map = map_of(strewn_objects(25, 100 + seed), 9);
    const auto query = query_of(strewn_objects(20, 200 + seed));
    const auto learnt = learn_relation(map, query);
    if (!learnt) continue;
    ++proposed;
    CHECK(learnt->significance < decision.threshold(1));
  }
  CHECK(proposed > 0);
}

TEST_CASE("a relation is kept as it is", "[examples]") {
  const ScratchFolder folder;
  const auto coco = topobag::ClassCatalog::coco80();
  const MapRelation relation{1.05, 0.03, {{coco.at("cup"), coco.at("vase"), 2.0}}, "desk.json"};
  write_relation(folder.path("relation.json"), relation, coco);
  const MapRelation read = read_relation(folder.path("relation.json"), coco);
  CHECK(read.scale == relation.scale);
  CHECK(read.deviation == relation.deviation);
  CHECK(read.map == "desk.json");
  REQUIRE(read.classes.size() == 1);
  CHECK(read.classes[0].map == coco.at("cup"));
  CHECK(read.classes[0].query == coco.at("vase"));
  CHECK(read.classes[0].count == 2.0);
  const auto said = [&](const std::string& text) {
    const std::string path = folder.write("bad.json", text);
    return error_in(folder, [&] { read_relation(path, coco); });
  };
  CHECK(said(R"({"scale": 0, "deviation": 0.1, "classes": []})") ==
        "bad.json: scale and deviation have to be positive");
  for (const char* other : {R"({"nodes": []})", "[1]", "scale"}) {
    CHECK(said(other) == "bad.json: it is no relation, as `topobag relate` writes one");
  }
  CHECK(said(R"({"scale": 1, "deviation": 0.1, "classes": [
          {"map": "sphinx", "query": "cup", "objects": 1}]})")
            .find("bad.json: unknown class 'sphinx'") == 0);
}

TEST_CASE("a relation learnt by other classes is refused", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string path = folder.path("relation.json");
  ObjectClasses words, others, coco;
  add_map_words(folder.write("words.txt", "mug\ngemstone\n"), words);
  add_map_words(folder.write("others.txt", "gemstone\nmug\n"), others);
  const ClassId cup = coco.catalog.at("cup");
  write_relation(path, {1.05, 0.03, {{words.catalog.at("mug (map)"), cup, 2.0}}, "desk.json"},
                 words.catalog);
  CHECK(read_relation(path, words.catalog).classes[0].map == ClassId{80});
  const std::string sentence =
      " by other classes than these; give --map-words and --classes as `topobag relate` had them, "
      "or learn it anew";
  for (const ObjectClasses& other : {others, coco}) {
    CHECK(error_in(folder, [&] { read_relation(path, other.catalog); }) ==
          "relation.json: it was learnt of desk.json" + sentence);
  }
  // A topobag that did not say by which classes went by their names, and so do its files.
  const std::string all = content_of(path);
  const auto without = [&](const std::string& key) {
    const std::size_t begin = all.find("\"" + key + "\"");
    return std::string(all).erase(begin, all.find('\n', begin) + 1 - begin);
  };
  folder.write("relation.json", without("map"));
  CHECK(error_in(folder, [&] { read_relation(path, coco.catalog); }) ==
        "relation.json: it was learnt of a map" + sentence);
  folder.write("relation.json", without("catalog"));
  CHECK(read_relation(path, others.catalog).classes[0].map == ClassId{81});
  folder.write("relation.json", R"({"catalog": 7, "scale": 1, "deviation": 1, "classes": []})");
  CHECK_THROWS_AS(read_relation(path, coco.catalog), topobag::Error);
}

TEST_CASE("what is believed of a map's word before it was counted", "[examples]") {
  const ScratchFolder folder;
  ObjectClasses classes;
  add_map_words(folder.write("words.txt", "mug\ngemstone\n"), classes);
  const ClassId mug{80}, gemstone{81}, cup = classes.catalog.at("cup");
  CHECK(classes.catalog.name(mug) == "mug (map)");
  const auto confusion = confusion_of({1.0, 0.05, {{mug, cup, 1.0}}}, classes);
  CHECK(confusion.probability(mug, cup) == Approx((1.0 + 1.0 / 80.0) / 2.0));
  CHECK(confusion.probability(gemstone, cup) == Approx(1.0 / 80.0));
  classes.confusion = confusion;
  const auto options = recognition_options_for(classes);
  CHECK(options.matching.consistency.classes.compatible(mug, cup));
  CHECK_FALSE(options.matching.consistency.classes.compatible(gemstone, cup));
  ObjectClasses holed;
  // Where map and queries speak alike, a class mostly keeps its name.
  CHECK(confusion_of({}, ObjectClasses{}).probability(cup, cup) == Approx(0.9));
  CHECK(error_in(folder, [&] {
          add_map_words(folder.write("two.txt", "mug\n\nbook\n"), holed);
        }).find("two.txt:3: ") == 0);
}
