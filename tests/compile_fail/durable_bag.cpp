// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: a bag over SQLite has Graph = TopologyGraph<Scalar>, contains(KeyframeId)
// MISFIT 2: topobag: a bag over SQLite has Graph = TopologyGraph<Scalar>, contains(KeyframeId)
#include <topobag/adaptors/sqlite.hpp>

using namespace topobag;

struct Bag {
  using Graph = TopologyGraph<>;
#if MISFIT != 1
  bool contains(KeyframeId) const { return false; }
#endif
  void add(KeyframeId, Graph, EntryInfo) {}
#if MISFIT == 2
  void update(KeyframeId, Graph) {}
#else
  void update(KeyframeId, Graph, EntryInfo) {}
#endif
  bool erase(KeyframeId) { return false; }
};

int main() {
  SqliteBag<Bag> map("map.db");
  map.update(KeyframeId{1}, {});
}
