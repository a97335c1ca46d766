// SPDX-License-Identifier: MIT
// What the README shows of a map that is kept.
#include <filesystem>
#include <utility>
#include <vector>

#include <topobag/bag/snapshot_file.hpp>
#ifdef TOPOBAG_HAS_SQLITE
#include <topobag/adaptors/sqlite.hpp>
#endif

#include "catch.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// The names of the README's files stand for themselves: they lie in a folder of the test's own.
class WorkingFolder {
 public:
  WorkingFolder() { std::filesystem::current_path(folder_.path("")); }
  ~WorkingFolder() { std::filesystem::current_path(before_); }

 private:
  ScratchFolder folder_;
  std::filesystem::path before_ = std::filesystem::current_path();
};

TopologyGraph<> two_objects() {
  std::vector<SemanticNode<>> nodes(2);
  nodes[0].position = Eigen::Vector3d(0, 0, 1);
  nodes[1].position = Eigen::Vector3d(1, 0, 1);
  return TopologyGraph<>(std::move(nodes), EdgeList{});
}

}  // namespace

TEST_CASE("a bag is kept in a file", "[docs]") {
  const WorkingFolder folder;
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{7}, two_objects());
  save(bag, "flat.bag");                          // complete under its name, or not at all
  bag = load<BagOfTopologyGraphs<>>("flat.bag");  // or a FormatError; `bag` is then as it was
  CHECK(bag.size() == 1);
  CHECK(bag.contains(KeyframeId{7}));
}

#ifdef TOPOBAG_HAS_SQLITE
TEST_CASE("a running map goes on where it was", "[docs]") {
  const WorkingFolder folder;
  const TopologyGraph<> graph = two_objects();
  EntryInfo info;
  {
    SqliteBag<> map("flat.db");  // a running map: opened again, it goes on
    info.session = map.begin_session("Monday");
    map.add(KeyframeId{7}, graph, info);
    map.bag().query(graph);
  }
  CHECK(SqliteBag<>("flat.db").bag().contains(KeyframeId{7}));
}
#endif
