// SPDX-License-Identifier: MIT
// What does an exact top 10 cost among a million graphs?
//
// The bag is a drive through made-up places, out of pieces of real graphs (`recombined_graphs.hpp`
// says how); a query is another key frame of one of these places. `query` is the indexed bag's;
// `brute` compares the query's histogram with one stored for every graph, worked out beforehand.
// Both have to give the same ids and scores. All on one thread; medians over the queries, and for
// `add` the mean of the processor's time, merges and all.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "drive.hpp"
#include "neighbor_graph.hpp"

namespace {

using topobag::Candidate;
using Graph = topobag::TopologyGraph<>;
using Clock = std::chrono::steady_clock;

double us_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

double quantile(std::vector<double> values, double share) {
  const auto i = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + i, values.end());
  return values[static_cast<std::size_t>(i)];
}

struct Options {
  std::vector<std::size_t> graphs{1000, 10000, 100000, 1000000};
  std::vector<std::string> sets;
  std::size_t queries = 1000;
  std::size_t brute_queries = 25;
  std::size_t max_neighbor_graph = 100000;
};

std::vector<Candidate> brute_force(const std::vector<topobag::SparseHistogram>& stored,
                                   const topobag::SparseHistogram& query) {
  std::vector<Candidate> found;
  found.reserve(stored.size());
  for (std::size_t i = 0; i < stored.size(); ++i) {
    found.push_back({topobag::KeyframeId{i}, topobag::jaccard(query, stored[i])});
  }
  const std::size_t kept = std::min<std::size_t>(10, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept), found.end());
  found.resize(kept);
  return found;
}

/// How far the similarity of a query to a graph moves when the bag rounds the graph.
void report_rounding(const std::vector<Graph>& pieces) {
  Drive drive(pieces, 1);
  std::vector<Graph> exact;
  while (exact.size() < 1000) exact.push_back(drive.next());
  const topobag::ClassPairDistanceHistogram similarity;
  std::vector<double> changes;
  double sum = 0.0;
  for (int query = 0; query < 100; ++query) {
    const Graph graph = drive.revisit();
    for (const Graph& entry : exact) {
      const Graph stored = topobag::decode<double>(topobag::encode(entry));
      changes.push_back(std::abs(similarity(graph, entry) - similarity(graph, stored)));
      sum += changes.back();
    }
  }
  std::printf("Rounding a stored graph moves a similarity by %.4f on average, %.4f at most.\n",
              sum / static_cast<double>(changes.size()), quantile(changes, 1.0));
}

/// False when an answer of the index is not that of brute force.
bool run(std::size_t graphs, const Options& options, const std::vector<Graph>& pieces) {
  Drive drive(pieces, 1);
  topobag::IndexedBag bag;
  double add_us = 0.0;
  while (bag.size() < graphs) {
    std::vector<Graph> batch;
    while (batch.size() < 1000 && bag.size() + batch.size() < graphs) batch.push_back(drive.next());
    const std::clock_t start = std::clock();
    for (const Graph& graph : batch) {
      topobag::EntryInfo info;
      info.stamp = 0.4 * static_cast<double>(bag.size());
      bag.add(topobag::KeyframeId{bag.size()}, graph, info);
    }
    add_us += 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }
  add_us /= static_cast<double>(graphs);
  std::vector<Graph> queries;
  for (std::size_t i = 0; i < options.queries; ++i) queries.push_back(drive.revisit());

  std::vector<std::vector<Candidate>> answers;
  std::vector<double> query_us;
  double untouched = 0.0;
  const auto view = bag.view();
  for (const Graph& query : queries) {
    const auto start = Clock::now();
    topobag::SearchResult result = view->search(query);
    query_us.push_back(us_since(start));
    untouched +=
        static_cast<double>(result.untouched()) / static_cast<double>(graphs * options.queries);
    answers.push_back(std::move(result.candidates));
  }

  const topobag::ClassPairDistanceHistogram similarity;
  std::vector<topobag::SparseHistogram> stored;
  stored.reserve(graphs);
  bag.for_each([&](topobag::KeyframeId, const topobag::EntryInfo&, const Graph& graph) {
    stored.push_back(similarity.descriptor(graph));
  });
  std::vector<double> brute_us;
  bool same = true;
  for (std::size_t i = 0; i < std::min(options.brute_queries, queries.size()); ++i) {
    const auto start = Clock::now();
    const auto found = brute_force(stored, similarity.descriptor(queries[i]));
    brute_us.push_back(us_since(start));
    same = same && found == answers[i];
  }

  const double median_us = quantile(query_us, 0.5), brute = quantile(brute_us, 0.5);
  const double bytes =
      static_cast<double>(bag.memory_usage().total()) / static_cast<double>(graphs);
  std::printf("%9zu %11.0f %9.0f %11.0f %9.0f %7.0f %8.1f %10.1f %%\n", graphs, median_us,
              quantile(query_us, 0.99), brute, brute / median_us, bytes, add_us, 100.0 * untouched);
  std::printf(
      "{\"bench\":\"bag\",\"graphs\":%zu,\"median_us\":%.1f,\"p99_us\":%.1f,\"brute_us\":%.1f,"
      "\"speedup\":%.1f,\"bytes_per_graph\":%.1f,\"add_us\":%.2f}\n",
      graphs, median_us, quantile(query_us, 0.99), brute, brute / median_us, bytes, add_us);
  if (graphs <= options.max_neighbor_graph) {
    bench::compare_neighbor_graphs(stored, similarity, queries, answers);
  }
  std::fflush(stdout);
  return same;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.sets = {TOPOBAG_SOURCES "/examples/data/fr1_xyz",
                  TOPOBAG_SOURCES "/examples/data/fr1_rpy"};
  CLI::App app("The cost of an exact top 10");
  app.add_option("--graphs", options.graphs, "sizes of the bag")->delimiter(',');
  app.add_option("--nodes", options.sets, "node tables whose graphs are the pieces");
  app.add_option("--queries", options.queries, "how many")->check(CLI::PositiveNumber);
  app.add_option("--neighbor-graphs", options.max_neighbor_graph,
                 "largest bag beside which neighbour graphs are built");
  CLI11_PARSE(app, argc, argv);
  const std::vector<Graph> pieces = graphs_of_tables(options.sets);
  report_rounding(pieces);
  std::printf("%9s %11s %9s %11s %9s %7s %8s %12s\n", "graphs", "median, us", "p99, us",
              "brute, us", "speed-up", "bytes", "add, us", "untouched");
  for (const std::size_t graphs : options.graphs) {
    if (!run(graphs, options, pieces)) {
      std::fprintf(stderr, "At %zu graphs the index does not answer as brute force does.\n",
                   graphs);
      return 1;
    }
  }
}
