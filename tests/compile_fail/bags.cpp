// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: a bag to query has Graph = TopologyGraph<Scalar>, query(graph,
// MISFIT 2: topobag: a bag to query has Graph = TopologyGraph<Scalar>, query(graph,
// MISFIT 3: topobag: a bag that grows has Graph = TopologyGraph<Scalar> and add(KeyframeId,
#include <string>

#include <topobag/recognition/loop_detector.hpp>

using namespace topobag;

struct Bag {
#if MISFIT == 2
  using Graph = std::string;
#else
  using Graph = TopologyGraph<>;
#endif
#if MISFIT != 1
  std::vector<Candidate> query(const Graph&, const QueryOptions&) const { return {}; }
#endif
  std::optional<Graph> find(KeyframeId) const { return std::nullopt; }
#if MISFIT != 3
  void add(KeyframeId, Graph, EntryInfo) {}
#endif
};

int main() {
#if MISFIT != 3
  const Relocalizer<Bag> relocalizer;
#endif
  const LoopDetector<Bag> loops;
}
