// SPDX-License-Identifier: MIT
// What does it cost to match two graphs of real key frames and work out their pose, and the paper's
// padded cosine beside the plain formula?
//
// Every query of one sequence meets every key frame of another: the sample's, or two tables of the
// same camera given as arguments (map, query). Graphs fuse three seconds; of each the nodes seen
// most surely are kept, so that all have the same number. A pair's time is the least of three
// calls, which leaves out the neighbours on the machine; the figures are over all pairs.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <topobag/matching/match_graphs.hpp>
#include <topobag/matching/match_nodes.hpp>
#include <topobag/similarity/padded_cosine.hpp>

#include "keyframe_graphs.hpp"
#include "pair_times.hpp"

namespace {

using Graph = topobag::TopologyGraph<>;

/// The graphs of a table's key frames that have `count` placed nodes, cut down to the surest ones.
std::vector<Graph> graphs_of(const std::string& set, const program::KeyframeOptions& options,
                             std::size_t count, bool one_class = false) {
  std::vector<Graph> graphs;
  for (const program::Keyframe& keyframe : program::read_keyframes(set, options)) {
    std::vector<topobag::SemanticNode<>> nodes;
    for (const auto& node : keyframe.graph.nodes()) {
      if (node.position) nodes.push_back(node);
    }
    if (nodes.size() < count) continue;
    const auto sureness = [](const auto& node) { return node.existence * node.confidence; };
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](const auto& a, const auto& b) { return sureness(a) > sureness(b); });
    nodes.resize(count);
    if (one_class) {
      for (auto& node : nodes) node.label = topobag::ClassId{0};
    }
    graphs.emplace_back(std::move(nodes), topobag::EdgeList{}, keyframe.graph.views());
  }
  return graphs;
}

/// The largest set of agreeing pairs by trying every one-to-one assignment within the classes.
class ExhaustiveReference {
 public:
  ExhaustiveReference(const Graph& candidate, const Graph& query)
      : graph_(candidate, query, {}), pairs_(graph_.pairs()), candidate_taken_(candidate.size()) {
    try_query(0, query.size());
  }
  std::size_t size() const { return size_; }

 private:
  void try_query(std::size_t query, std::size_t queries) {
    if (query == queries) {
      if (all_agree()) size_ = std::max(size_, chosen_.size());
      return;
    }
    try_query(query + 1, queries);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const std::size_t candidate = value(pairs_[i].candidate);
      if (value(pairs_[i].query) != query || candidate_taken_[candidate]) continue;
      candidate_taken_[candidate] = true;
      chosen_.push_back(i);
      try_query(query + 1, queries);
      chosen_.pop_back();
      candidate_taken_[candidate] = false;
    }
  }

  bool all_agree() const {
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!graph_.agreement().test(chosen_[i], chosen_[j])) return false;
      }
    }
    return true;
  }

  topobag::ConsistencyGraph graph_;
  const std::vector<topobag::Correspondence>& pairs_;
  std::vector<bool> candidate_taken_;
  std::vector<std::size_t> chosen_;
  std::size_t size_ = 0;
};

/// Eq. 12 as it stands, in Eigen.
double plain_padded_cosine(const Graph& p, const Graph& q) {
  const Eigen::Matrix<double, Eigen::Dynamic, 4> W_p = topobag::topology_weight(p);
  const Eigen::Matrix<double, Eigen::Dynamic, 4> W_q = topobag::topology_weight(q);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < std::min(W_p.rows(), W_q.rows()); ++i) {
    sum += W_p.row(i).dot(W_q.row(i)) / (W_p.row(i).norm() * W_q.row(i).norm());
  }
  return sum / static_cast<double>(std::max(W_p.rows(), W_q.rows()));
}

struct Tables {
  std::string map = TOPOBAG_SAMPLE "/fr1_xyz";
  std::string query = TOPOBAG_SAMPLE "/fr1_rpy";
  program::KeyframeOptions options{{517.3, 516.5, 318.6, 255.3, 640, 480}, 0.4, 3.0, 0.1};
};

/// The same graphs, of whose objects nobody knows what they look like.
std::vector<Graph> without_looks(const std::vector<Graph>& graphs) {
  std::vector<Graph> stripped;
  for (const Graph& graph : graphs) {
    std::vector<topobag::SemanticNode<>> nodes = graph.nodes();
    for (auto& node : nodes) node.appearance = {};
    stripped.emplace_back(std::move(nodes), graph.edges(), graph.views());
  }
  return stripped;
}

/// The share of the objects of which it is known what they look like.
double known_looks(const std::vector<Graph>& graphs) {
  std::size_t nodes = 0, known = 0;
  for (const Graph& graph : graphs) {
    nodes += graph.size();
    for (const auto& node : graph.nodes()) known += node.appearance.known() ? 1U : 0U;
  }
  return static_cast<double>(known) / static_cast<double>(std::max<std::size_t>(1, nodes));
}

/// With what the objects look like and without, pair by pair in turn, so that whatever else runs on
/// the machine meets both.
void bench_pose(const Tables& tables) {
  const auto map = graphs_of(tables.map, tables.options, 12);
  const auto queries = graphs_of(tables.query, tables.options, 12);
  const auto plain_map = without_looks(map), plain_queries = without_looks(queries);
  std::printf("# objects whose looks are known: %.3f\n",
              0.5 * (known_looks(map) + known_looks(queries)));
  std::size_t poses = 0, plain_poses = 0;
  std::vector<double> times, plain_times;
  for (const auto& [i, k] : bench::spread_pairs(map.size(), queries.size(), 4000)) {
    plain_times.push_back(bench::least_time([&, i = i, k = k] {
      plain_poses += topobag::match_graphs(plain_map[i], plain_queries[k]).poses.size();
    }));
    times.push_back(bench::least_time(
        [&, i = i, k = k] { poses += topobag::match_graphs(map[i], queries[k]).poses.size(); }));
  }
  const double with = bench::print("match and pose", 12, times);
  const double without = bench::print("match and pose, no looks", 12, plain_times);
  const auto calls = 3.0 * static_cast<double>(times.size());
  std::printf("# poses per pair: %.2f, no looks: %.2f\n", static_cast<double>(poses) / calls,
              static_cast<double>(plain_poses) / calls);
  std::printf("# time with looks over without: %.3f of medians, %.3f of means\n", with / without,
              bench::mean(times) / bench::mean(plain_times));
  std::printf(
      "{\"bench\":\"matching\",\"what\":\"match and pose over the same without looks\","
      "\"ratio_of_medians\":%.3f,\"ratio_of_means\":%.3f}\n",
      with / without, bench::mean(times) / bench::mean(plain_times));
}

/// False when the two searches differ.
bool bench_search(const Tables& tables, bool one_class, std::size_t max_pairs) {
  const auto map = graphs_of(tables.map, tables.options, 8, one_class);
  const auto queries = graphs_of(tables.query, tables.options, 8, one_class);
  std::vector<std::size_t> ours, theirs;
  const std::string classes = one_class ? ", one class" : "";
  const double fast =
      bench::print(("match" + classes).c_str(), 8,
                   bench::times_of(map, queries, max_pairs, [&](const Graph& p, const Graph& q) {
                     ours.push_back(topobag::match_nodes(p, q).pairs.size());
                   }));
  const double slow =
      bench::print(("exhaustive reference" + classes).c_str(), 8,
                   bench::times_of(map, queries, max_pairs, [&](const Graph& p, const Graph& q) {
                     theirs.push_back(ExhaustiveReference(p, q).size());
                   }));
  std::printf("{\"bench\":\"matching\",\"what\":\"exhaustive over match%s\",\"ratio\":%.1f}\n",
              classes.c_str(), slow / fast);
  return ours == theirs;
}

/// False when the padded cosine differs from the formula.
bool bench_padded_cosine(Tables tables) {
  tables.options.window = 0.0;
  std::vector<Graph> map, queries;
  for (const auto& keyframe : program::read_keyframes(tables.map, tables.options)) {
    if (!keyframe.graph.empty()) map.push_back(keyframe.graph);
  }
  for (const auto& keyframe : program::read_keyframes(tables.query, tables.options)) {
    if (!keyframe.graph.empty()) queries.push_back(keyframe.graph);
  }
  const topobag::PaddedCosine similarity;
  double sum = 0.0, worst = 0.0;
  for (const Graph& p : map) {
    for (const Graph& q : queries) {
      worst = std::max(worst, std::abs(similarity(p, q) - plain_padded_cosine(p, q)));
    }
  }
  bench::print("padded cosine", 0,
               bench::times_of(map, queries, 4000,
                               [&](const Graph& p, const Graph& q) { sum += similarity(p, q); }));
  bench::print("padded cosine, plain formula", 0,
               bench::times_of(map, queries, 4000, [&](const Graph& p, const Graph& q) {
                 sum += plain_padded_cosine(p, q);
               }));
  std::vector<topobag::PaddedCosine::Descriptor> of_map, of_queries;
  for (const Graph& p : map) of_map.push_back(similarity.descriptor(p));
  for (const Graph& q : queries) of_queries.push_back(similarity.descriptor(q));
  const auto start = std::chrono::steady_clock::now();
  for (const auto& p : of_map) {
    for (const auto& q : of_queries) sum += similarity.similarity(p, q);
  }
  const std::chrono::duration<double, std::micro> elapsed =
      std::chrono::steady_clock::now() - start;
  std::printf(
      "{\"bench\":\"matching\",\"what\":\"padded cosine of descriptors\",\"mean_us\":%.4f}\n",
      elapsed.count() / static_cast<double>(map.size() * queries.size()));
  std::printf(
      "{\"bench\":\"matching\",\"what\":\"padded cosine beside the "
      "formula\",\"largest_difference\":"
      "%.2e}\n",
      worst);
  return worst <= 1e-12 && sum > 0.0;
}

}  // namespace

int main(int argc, char** argv) {
  Tables tables;
  if (argc >= 3) {
    tables.map = argv[1];
    tables.query = argv[2];
  }
  std::printf("%-38s %5s %7s %10s %10s %10s\n", "", "nodes", "pairs", "median, us", "p99, us",
              "mean, us");
  try {
    bench_pose(tables);
    bool same = bench_search(tables, false, 4000);
    same = bench_search(tables, true, 20) && same;
    same = bench_padded_cosine(tables) && same;
    if (!same) std::fprintf(stderr, "a result differs from its reference\n");
    return same ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_matching: %s\n", error.what());
    return 2;
  }
}
