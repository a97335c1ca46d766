// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include <topobag/bag/indexed_bag.hpp>

#include "bag/desk_pieces.hpp"
#include "bag/filled_bags.hpp"
#include "catch.hpp"
#include "long_rounds.hpp"
#include "recombined_graphs.hpp"

using namespace topobag;

namespace {

/// Writes and reads at once for `time`; every view has to be whole.
void write_and_read(std::chrono::milliseconds time) {
  RecombinedGraphs source(desk_pieces(1), 1);
  IndexedBag bag = bag_of(source, 30);
  std::vector<TopologyGraph<>> queries;
  for (int i = 0; i < 20; ++i) queries.push_back(source.keyframe(source.place()));
  std::atomic<bool> stop{false};
  std::atomic<std::size_t> torn{0}, reads{0};
  const auto read = [&](std::size_t reader) {
    for (std::size_t i = reader; !stop; ++i) {
      const auto view = bag.view();
      const auto found = view->query(queries[i % queries.size()]);
      const bool again = view->query(queries[i % queries.size()]) == found;
      bool whole = again && found.size() == std::min<std::size_t>(10, view->size());
      for (const Candidate& candidate : found) {
        const auto graph = view->find(candidate.id);
        // The writer gives every graph its number of nodes as its session.
        whole = whole && graph && view->info(candidate.id)->session == graph->size();
      }
      if (i % 50 == reader) {
        std::size_t entries = 0;
        view->for_each([&](KeyframeId, const EntryInfo&, const TopologyGraph<>&) { ++entries; });
        whole = whole && entries == view->size();
      }
      if (!whole) ++torn;
      ++reads;
    }
  };
  bag.clear();
  std::vector<std::thread> readers;
  for (std::size_t i = 0; i < 4; ++i) readers.emplace_back(read, i);
  const auto end = std::chrono::steady_clock::now() + time;
  auto place = source.place();
  for (std::uint64_t i = 0; std::chrono::steady_clock::now() < end || reads < 40; ++i) {
    if (i % 12 == 0) place = source.place();
    const TopologyGraph<> graph = source.keyframe(place);
    EntryInfo info;
    info.session = static_cast<std::uint32_t>(graph.size());
    bag.add(KeyframeId{i}, graph, info);
    const KeyframeId old{source.below(static_cast<std::size_t>(i) + 1)};
    if (i % 3 == 0) bag.erase(old);
    if (i % 3 == 1 && bag.contains(old)) bag.update(old, graph, info);
    if (i % 5000 == 4999) bag.compact();
    if (bag.size() > 3000) bag.clear();
  }
  stop = true;
  for (std::thread& reader : readers) reader.join();
  CHECK(torn == 0);
  CHECK(reads >= 40);
}

}  // namespace

TEST_CASE("a bag is copied while its writer adds", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(6), 6);
  std::vector<TopologyGraph<>> graphs;
  for (int i = 0; i < 40; ++i) graphs.push_back(source.keyframe(source.place()));
  const auto nodes_of = [&](std::uint64_t id) { return graphs[id % graphs.size()].size(); };
  IndexedBag bag;
  std::atomic<bool> stop{false};
  std::thread writer([&] {
    for (std::uint64_t i = 0; !stop; ++i) {
      bag.add(KeyframeId{i}, graphs[i % graphs.size()]);
      if (i % 5 == 4) bag.erase(KeyframeId{i - 2});
      if (bag.size() > 400) bag.clear();
    }
  });
  const KeyframeId own{1u << 30U};
  QueryOptions without_own;
  without_own.filter = [&](KeyframeId id, const EntryInfo&) { return id != own; };
  std::size_t torn = 0;
  for (int i = 0; i < 200; ++i) {
    IndexedBag copy = bag;
    const auto view = copy.view();
    view->for_each([&](KeyframeId id, const EntryInfo&, const TopologyGraph<>& graph) {
      torn += graph.size() == nodes_of(value(id)) ? 0U : 1U;
    });
    const TopologyGraph<>& query = graphs[static_cast<std::size_t>(i) % graphs.size()];
    copy.add(own, query);  // where the writer may be adding, too
    torn += copy.size() == view->size() + 1 ? 0U : 1U;
    torn += copy.query(query, without_own) == view->query(query) ? 0U : 1U;
  }
  stop = true;
  writer.join();
  CHECK(torn == 0);
}

TEST_CASE("readers and a writer do not disturb each other", "[bag][index]") {
  write_and_read(std::chrono::milliseconds(500));
}

TEST_CASE("readers and a writer do not disturb each other for long", "[bag][index][long]") {
  write_and_read(std::chrono::milliseconds(long_rounds(35000)));
}
