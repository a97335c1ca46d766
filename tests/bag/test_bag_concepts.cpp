// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <vector>

#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

struct LengthOnly {
  double operator()(const std::string& a, const std::string& b) const {
    return a.size() == b.size();
  }
};

/// A bag of something else than topology graphs.
using Words = BagOfTopologyGraphs<std::string, LengthOnly>;

/// Has all names, but `find` says nothing of an id that is not there.
struct Careless {
  using Graph = TopologyGraph<>;
  std::vector<Candidate> query(const Graph&, const QueryOptions&) const { return {}; }
  const Graph* find(KeyframeId) const { return nullptr; }
  void add(KeyframeId, Graph) {}
  void for_each(int) const {}
  int size() const { return 0; }
  bool contains(KeyframeId) const { return false; }
  void update(KeyframeId, Graph, EntryInfo) {}
  void erase(KeyframeId) {}
};

template <typename Bag>
std::string concepts_of() {
  std::string met;
  if (is_searchable_bag_v<Bag>) met += "searchable ";
  if (is_growing_bag_v<Bag>) met += "growing ";
  if (is_stored_bag_v<Bag>) met += "stored ";
  if (is_durable_bag_v<Bag>) met += "durable ";
  return met;
}

}  // namespace

TEST_CASE("the library's bags fit what it asks of bags", "[bag]") {
  CHECK(concepts_of<BagOfTopologyGraphs<>>() == "searchable growing stored durable ");
  CHECK(concepts_of<BagOfTopologyGraphs<TopologyGraph<float>>>() ==
        "searchable growing stored durable ");
  CHECK(concepts_of<IndexedBag>() == "searchable growing stored durable ");
  CHECK(concepts_of<BagView>() == "searchable stored ");
}

TEST_CASE("what is no bag of topology graphs does not fit", "[bag]") {
  CHECK(concepts_of<Words>().empty());
  CHECK(concepts_of<Careless>().empty());
  CHECK(concepts_of<int>().empty());
}
