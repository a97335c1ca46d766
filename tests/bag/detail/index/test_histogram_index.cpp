// SPDX-License-Identifier: MIT
#include <topobag/bag/detail/index/histogram_index.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "catch.hpp"

using namespace topobag;

namespace {

SparseHistogram random_histogram(std::mt19937& random) {
  std::uniform_int_distribution<std::size_t> votes(0, 12);
  std::uniform_int_distribution<std::uint64_t> word(0, 20);
  std::uniform_real_distribution<double> weight(0.0, 1.0);
  std::vector<SparseHistogram::Entry> entries(votes(random));
  for (auto& entry : entries) entry = {word(random), weight(random)};
  return SparseHistogram(std::move(entries));
}

struct IndexedHistogram {
  SparseHistogram histogram;
  std::size_t slot;
};

/// By comparing all.
template <typename Admits>
std::vector<Candidate> by_merging(const std::map<KeyframeId, IndexedHistogram>& model,
                                  const SparseHistogram& query, const QueryOptions& options,
                                  const Admits& admits) {
  std::vector<Candidate> found;
  for (const auto& [id, entry] : model) {
    const double score = jaccard(query, entry.histogram);
    if (admits(id) && score >= options.min_similarity) found.push_back({id, score});
  }
  std::sort(found.begin(), found.end());
  if (found.size() > options.max_results) found.resize(options.max_results);
  return found;
}

}  // namespace

TEST_CASE("an index finds what comparing every histogram finds, to the last bit", "[bag]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::uint64_t> id_of(0, 40);
    detail::HistogramIndex index;
    std::map<KeyframeId, IndexedHistogram> model;
    for (int step = 0; step < 200; ++step) {
      const KeyframeId id{id_of(random)};
      const auto known = model.find(id);
      if (known != model.end()) {
        index.remove(known->second.slot, known->second.histogram);
        model.erase(known);
      } else {
        const SparseHistogram histogram = random_histogram(random);
        model[id] = {histogram, index.add(id, histogram)};
      }
      const SparseHistogram query = random_histogram(random);
      QueryOptions options;
      options.max_results = id_of(random);
      options.min_similarity = step % 3 == 0 ? 0.2 : 0.0;
      const auto admits = [&](KeyframeId entry) { return step % 2 == 0 || value(entry) % 3 != 0; };
      CHECK(index.query(query, options, admits) == by_merging(model, query, options, admits));
    }
    index.clear();
    CHECK(index.query(random_histogram(random), {}, [](KeyframeId) { return true; }).empty());
  }
}

TEST_CASE("an index asks for admission only what would be among the best", "[bag]") {
  detail::HistogramIndex index;
  for (std::uint64_t i = 0; i < 100; ++i) {
    index.add(KeyframeId{i}, SparseHistogram({{7, 1.0}, {8 + i, static_cast<double>(i)}}));
  }
  QueryOptions options;
  options.max_results = 3;
  std::size_t asked = 0;
  const auto best = index.query(SparseHistogram({{7, 1.0}}), options, [&](KeyframeId) {
    ++asked;
    return true;
  });
  REQUIRE(best.size() == 3);
  CHECK(best.front() == Candidate{KeyframeId{0}, 1.0});
  CHECK(asked == 3);
}
