// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: a bag to save has Graph = TopologyGraph<Scalar>, size() const and
// MISFIT 2: topobag: a bag that grows has Graph = TopologyGraph<Scalar> and add(KeyframeId,
// MISFIT 3: topobag: a bag to merge has for_each, of KeyframeId, EntryInfo and Graph.
#include <sstream>

#include <topobag/bag/snapshot.hpp>

using namespace topobag;

struct Bag {
  using Graph = TopologyGraph<>;
  bool empty() const { return true; }
  std::uint64_t size() const { return 0; }
#if MISFIT == 1 || MISFIT == 3
  void for_each(void (*)(const Graph&)) const {}
#else
  template <typename Visit>
  void for_each(const Visit&) const {}
#endif
#if MISFIT != 2
  void add(KeyframeId, Graph, EntryInfo) {}
#endif
};

int main() {
  std::stringstream file;
#if MISFIT != 2 && MISFIT != 3
  save(Bag(), file);
#endif
  BagOfTopologyGraphs<> other;
#if MISFIT != 1 && MISFIT != 2
  other.merge(Bag());
#endif
  const Bag loaded = load<Bag>(file);
}
