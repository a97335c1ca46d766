// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/bag/place_contents.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// A graph with one to six objects of six classes, one in four without a position.
TopologyGraph<> some_objects(std::mt19937& random) {
  std::vector<SemanticNode<>> nodes(1 + random() % 6);
  for (auto& node : nodes) {
    node.label = ClassId{static_cast<int>(random() % 6)};
    node.pixel = Eigen::Vector2d(10, 20);
    if (random() % 4 != 0) node.position = Eigen::Vector3d(0.1, 0.2, 2.0);
  }
  return TopologyGraph<>(nodes);
}

EntryInfo in_cell(int cell) {
  EntryInfo info;
  info.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(3.0 * cell + 1.0, 1.0, 1.0));
  return info;
}

struct Placed {
  int cell;
  TopologyGraph<> graph;
};

/// Places that hold all of `objects`, by looking at each.
std::size_t holding(const std::map<KeyframeId, Placed>& entries, const ClassCounts& objects,
                    const ClassGroups& groups) {
  std::map<int, ClassCounts> places;
  for (const auto& [id, placed] : entries) {
    for (const auto& [label, count] : class_counts(placed.graph.nodes())) {
      std::size_t& most = places[placed.cell][label];
      most = std::max(most, count);
    }
  }
  std::size_t found = 0;
  for (const auto& place : places) {
    const bool all = std::all_of(objects.begin(), objects.end(), [&](const auto& asked) {
      std::size_t of_group = 0;
      for (const auto& [label, count] : place.second) {
        if (groups.compatible(label, asked.first)) of_group += count;
      }
      return of_group >= asked.second;
    });
    if (all) ++found;
  }
  return found;
}

/// The same of one class, and of two, exactly.
ClassCounts counts(std::initializer_list<std::pair<const int, std::size_t>> of) {
  ClassCounts counts;
  for (const auto& [label, count] : of) counts[ClassId{label}] = count;
  return counts;
}

}  // namespace

TEST_CASE("places that hold objects are counted as brute force does, whatever is added, moved and "
          "taken out, by both bags",
          "[bag]") {
  std::mt19937 random(17);
  std::map<KeyframeId, Placed> entries;
  BagOfTopologyGraphs<> bag;
  IndexedBag indexed;
  for (int step = 0; step < 400; ++step) {
    const KeyframeId id{random() % 60};
    const int cell = static_cast<int>(random() % 12);
    const TopologyGraph<> graph = some_objects(random);
    if (entries.count(id) == 0) {
      bag.add(id, graph, in_cell(cell));
      indexed.add(id, graph, in_cell(cell));
      entries.emplace(id, Placed{cell, graph});
    } else if (random() % 2 == 0) {
      bag.update(id, graph, in_cell(cell));
      indexed.update(id, graph, in_cell(cell));
      entries.at(id) = {cell, graph};
    } else {
      bag.erase(id);
      indexed.erase(id);
      entries.erase(id);
    }
    if (step % 20 != 0) continue;
    for (int a = 0; a < 6; ++a) {
      for (std::size_t count = 1; count <= 3; ++count) {
        const ClassCounts one = counts({{a, count}});
        const std::size_t exact = std::max<std::size_t>(1, holding(entries, one, {}));
        CHECK(bag.places_holding(one) == exact);
        CHECK(indexed.places_holding(one) == exact);
      }
      for (int b = 0; b < a; ++b) {
        const ClassCounts both = counts({{a, 1}, {b, 1}});
        CHECK(bag.places_holding(both) == std::max<std::size_t>(1, holding(entries, both, {})));
      }
    }
    // Of more than two it is a bound.
    ClassGroups groups;
    groups.join(ClassId{0}, ClassId{1});
    for (const ClassCounts& set : {counts({{0, 1}, {2, 1}, {3, 2}}), counts({{1, 2}, {4, 1}})}) {
      CHECK(bag.places_holding(set, groups) >= holding(entries, set, groups));
      CHECK(bag.places_holding(set, groups) <= std::max<std::size_t>(1, bag.places()));
      CHECK(indexed.places_holding(set, groups) == bag.places_holding(set, groups));
    }
  }
}

TEST_CASE("what a view of a bag says of its places stays as it was; a copy says the same", "[bag]") {
  std::mt19937 random(5);
  IndexedBag bag, other;
  for (std::uint64_t id = 0; id < 30; ++id) {
    bag.add(KeyframeId{id}, some_objects(random), in_cell(static_cast<int>(id % 7)));
    other.add(KeyframeId{id}, some_objects(random), in_cell(0));
  }
  const auto one = counts({{2, 1}});
  const std::size_t before = bag.places_holding(one);
  const auto view = bag.view();
  other = bag;
  CHECK(other.places_holding(one) == before);
  bag.clear();
  CHECK(view->places_holding(one) == before);
  CHECK(bag.places_holding(one) == 1);
  other.merge(*view);
  other.compact();
  CHECK(other.places_holding(one) == before);
}
