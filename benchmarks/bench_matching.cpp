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
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <topobag/matching/match_graphs.hpp>
#include <topobag/matching/match_nodes.hpp>
#include <topobag/similarity/padded_cosine.hpp>

#include "keyframe_graphs.hpp"

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

double share(std::vector<double> values, double quantile) {
  const auto at = static_cast<std::ptrdiff_t>(quantile * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Times of `call(candidate, query)` in µs for up to `max_pairs` pairs, evenly spread over all.
template <typename Call>
std::vector<double> times_of(const std::vector<Graph>& map, const std::vector<Graph>& queries,
                             std::size_t max_pairs, Call&& call) {
  const std::size_t all = map.size() * queries.size();
  if (all == 0) throw std::runtime_error("no key frame has that many objects with a depth");
  const std::size_t step = std::max<std::size_t>(1, (all + max_pairs - 1) / max_pairs);
  std::vector<double> times;
  for (std::size_t i = 0; i < all; i += step) {
    double least = 0.0;
    for (int repeat = 0; repeat < 3; ++repeat) {
      const auto start = std::chrono::steady_clock::now();
      call(map[i % map.size()], queries[i / map.size()]);
      const std::chrono::duration<double, std::micro> elapsed =
          std::chrono::steady_clock::now() - start;
      if (repeat == 0 || elapsed.count() < least) least = elapsed.count();
    }
    times.push_back(least);
  }
  return times;
}

double print(const char* what, std::size_t nodes, const std::vector<double>& times) {
  const double median = share(times, 0.5);
  const double mean =
      std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
  std::printf("%-38s %5zu %7zu %10.2f %10.2f %10.2f\n", what, nodes, times.size(), median,
              share(times, 0.99), mean);
  std::printf(
      "{\"bench\":\"matching\",\"what\":\"%s\",\"nodes\":%zu,\"pairs\":%zu,\"median_us\":%.3f,"
      "\"p99_us\":%.3f,\"mean_us\":%.3f}\n",
      what, nodes, times.size(), median, share(times, 0.99), mean);
  return median;
}

struct Tables {
  std::string map = TOPOBAG_SAMPLE "/fr1_xyz";
  std::string query = TOPOBAG_SAMPLE "/fr1_rpy";
  program::KeyframeOptions options{{517.3, 516.5, 318.6, 255.3, 640, 480}, 0.4, 3.0, 0.1};
};

void bench_pose(const Tables& tables) {
  const auto map = graphs_of(tables.map, tables.options, 12);
  const auto queries = graphs_of(tables.query, tables.options, 12);
  std::size_t poses = 0;
  const auto times = times_of(map, queries, 4000, [&](const Graph& p, const Graph& q) {
    poses += topobag::match_graphs(p, q).poses.size();
  });
  print("match and pose", 12, times);
  std::printf("# poses per pair: %.2f\n",
              static_cast<double>(poses) / (3.0 * static_cast<double>(times.size())));
}

/// False when the two searches differ.
bool bench_search(const Tables& tables, bool one_class, std::size_t max_pairs) {
  const auto map = graphs_of(tables.map, tables.options, 8, one_class);
  const auto queries = graphs_of(tables.query, tables.options, 8, one_class);
  std::vector<std::size_t> ours, theirs;
  const std::string classes = one_class ? ", one class" : "";
  const double fast = print(("match" + classes).c_str(), 8,
                            times_of(map, queries, max_pairs, [&](const Graph& p, const Graph& q) {
                              ours.push_back(topobag::match_nodes(p, q).pairs.size());
                            }));
  const double slow = print(("exhaustive reference" + classes).c_str(), 8,
                            times_of(map, queries, max_pairs, [&](const Graph& p, const Graph& q) {
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
  print("padded cosine", 0, times_of(map, queries, 4000, [&](const Graph& p, const Graph& q) {
          sum += similarity(p, q);
        }));
  print("padded cosine, plain formula", 0,
        times_of(map, queries, 4000,
                 [&](const Graph& p, const Graph& q) { sum += plain_padded_cosine(p, q); }));
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
