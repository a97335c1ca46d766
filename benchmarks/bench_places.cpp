// SPDX-License-Identifier: MIT
// How many queries find their place when hardly any finds a wrong one? One threshold for all data,
// so that it cannot be tuned to a set.
//
// Every query gives its best answer, whatever the score. The runs are pooled, those with gravity
// apart from those without, and the pool says what to ask for: more than its best false answer, or
// so much that one query in a thousand is answered falsely; the library's default is the third.
// Answers are pooled by their margins over the default's threshold, not by bare scores, since what
// is to be asked for grows with the number of places in the map: a margin means the same in all.
// False are answers that are off by more than 1 m or 45 degrees, and all of runs between different
// places; correct are those within 0.3 m and 15 degrees, out of all queries: also such as have
// nothing to find, as most of a sequence's before it comes back.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

#include <topobag/matching/layout_prior_text.hpp>
#include <topobag/matching/usual_layouts.hpp>

#include "look_up_places.hpp"
#include "number_check.hpp"
#include "place_run.hpp"
#include "pooled_figures.hpp"
#include "shared_runs.hpp"

namespace {

struct Result {
  PlaceRun run;
  std::vector<ScoredQuery> queries;
  double milliseconds = 0.0;  // mean of a query, its graphs and map included

  Figures by_default() const { return figures_at(queries, PooledMargins::by_default); }
};

double share(std::size_t part, std::size_t all) {
  return all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
}

void print_head(const char* pool) {
  std::printf("\n%s\n%-26s %5s %3s %7s | %-22s | %-22s | %-22s | %7s\n", pool, "", "", "", "",
              "default", "beyond best false", "1 false in 1,000", "");
  std::printf("%-26s %5s %3s %7s |", "query:map", "kind", "s", "queries");
  for (int i = 0; i < 3; ++i) std::printf(" %5s %5s %4s %5s |", "acc.", "corr.", "imp.", "false");
  std::printf(" %7s\n", "ms");
}

void print(const std::string& name, const char* kind, double window, bool gravity,
           const std::vector<ScoredQuery>& queries, const PooledMargins& margins,
           double milliseconds) {
  const std::array<double, 3> limits{PooledMargins::by_default, margins.beyond_best_false,
                                     margins.one_false_in_1000};
  const std::array<const char*, 3> names{"default", "beyond_best_false", "one_false_in_1000"};
  std::printf("%-26s %5s %3g %7zu |", name.c_str(), kind, window, queries.size());
  std::string json;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const Figures f = figures_at(queries, limits[i]);
    std::printf(" %5zu %5zu %4zu %5zu |", f.accepted, f.correct, f.imprecise, f.wrong);
    const auto field = [&](const char* key, std::size_t n) {
      return std::string(",\"") + names[i] + "_" + key + "\":" + std::to_string(n);
    };
    json += field("accepted", f.accepted) + field("correct", f.correct) +
            field("imprecise", f.imprecise) + field("false", f.wrong);
  }
  std::printf(" %7.1f\n", milliseconds);
  std::printf(
      "{\"bench\":\"places\",\"run\":\"%s\",\"kind\":\"%s\",\"window_s\":%g,\"gravity\":%s,"
      "\"queries\":%zu%s,\"ms\":%.1f}\n",
      name.c_str(), kind, window, gravity ? "true" : "false", queries.size(), json.c_str(),
      milliseconds);
}

/// Prints the runs with or without gravity, the worst first, and all together.
void print_pool(std::vector<Result> results, bool gravity) {
  const auto is_of_other_pool = [&](const Result& result) {
    return result.run.world_up.has_value() != gravity;
  };
  results.erase(std::remove_if(results.begin(), results.end(), is_of_other_pool), results.end());
  if (results.empty()) return;
  std::stable_sort(results.begin(), results.end(), [](const Result& a, const Result& b) {
    return share(a.by_default().wrong, a.queries.size()) >
           share(b.by_default().wrong, b.queries.size());
  });
  std::vector<ScoredQuery> all, with_a_place, of_other_places;
  double milliseconds = 0.0;
  for (const Result& result : results) {
    auto& kind = result.run.kind == PlaceKind::other ? of_other_places : with_a_place;
    for (auto* pool : {&all, &kind}) {
      pool->insert(pool->end(), result.queries.begin(), result.queries.end());
    }
    milliseconds += result.milliseconds * static_cast<double>(result.queries.size());
  }
  const PooledMargins margins = pooled_margins(all);
  print_head(gravity ? "with gravity" : "without gravity");
  for (const Result& result : results) {
    print(result.run.name, to_string(result.run.kind), result.run.window, gravity, result.queries,
          margins, result.milliseconds);
  }
  milliseconds /= std::max(1.0, static_cast<double>(all.size()));
  print("same and loops, pooled", "same", -1.0, gravity, with_a_place, margins, milliseconds);
  print("other, pooled", "other", -1.0, gravity, of_other_places, margins, milliseconds);
  const auto recall = [&](double margin) {
    const Figures figures = figures_at(with_a_place, margin);
    return share(figures.correct, figures.queries);
  };
  const Figures other = figures_at(of_other_places, PooledMargins::by_default);
  const double false_rate = share(other.wrong, other.queries);
  std::printf("margin asked for: beyond the best false %.2f, one false in 1,000 %.2f\n",
              margins.beyond_best_false, margins.one_false_in_1000);
  std::printf(
      "correct of queries: default %.4f, beyond the best false %.4f, one false in 1,000 %.4f\n",
      recall(PooledMargins::by_default), recall(margins.beyond_best_false),
      recall(margins.one_false_in_1000));
  std::printf("false accepts per query of other places, default: %.5f (%zu of %zu)\n", false_rate,
              other.wrong, other.queries);
  const auto or_null = [](double number) {
    return std::isfinite(number) ? std::to_string(number) : std::string("null");
  };
  std::printf(
      "{\"bench\":\"places\",\"pool\":\"%s\",\"queries\":%zu,"
      "\"margin_beyond_best_false\":%s,\"margin_one_false_in_1000\":%s,\"recall_default\":%.5f,"
      "\"recall_beyond_best_false\":%.5f,\"recall_one_false_in_1000\":%.5f,"
      "\"false_rate_of_other_places_default\":%.6f}\n",
      gravity ? "gravity" : "no gravity", all.size(), or_null(margins.beyond_best_false).c_str(),
      or_null(margins.one_false_in_1000).c_str(), recall(PooledMargins::by_default),
      recall(margins.beyond_best_false), recall(margins.one_false_in_1000), false_rate);
}

topobag::LayoutPrior layout_prior(const std::string& file) {
  if (file == "usual") return topobag::usual_layouts(topobag::ClassCatalog::coco80());
  std::ifstream stream(file);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) throw program::InputError(file, "cannot be read");
  return topobag::parse_layout_prior(text);
}

/// Looks all runs up; the results do not depend on the number of threads.
std::vector<Result> results_of(const std::vector<PlaceRun>& runs,
                               const topobag::RecognitionOptions& options, unsigned jobs) {
  std::vector<Result> results(runs.size());
  std::vector<std::exception_ptr> failures(runs.size());
  std::atomic<std::size_t> next{0}, done{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < runs.size(); i = next++) {
      const auto start = std::chrono::steady_clock::now();
      try {
        results[i] = {runs[i], look_up_places(runs[i], options), 0.0};
      } catch (...) {
        failures[i] = std::current_exception();
      }
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - start;
      const auto queries = static_cast<double>(results[i].queries.size());
      results[i].milliseconds = took.count() / std::max(1.0, queries);
      std::cerr << ++done << " of " << runs.size() << ": " + runs[i].name + "\n";
    }
  };
  std::vector<std::thread> threads;
  for (unsigned job = 1; job < jobs; ++job) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return results;
}

}  // namespace

int main(int argc, char** argv) {
  const char* const data = std::getenv("TOPOBAG_DATA");
  std::string list, shared = data ? data : "", only, layouts;
  SharedRunsOptions built_in;
  std::size_t stride = 1;
  unsigned jobs = 1;
  CLI::App app("Recall of places at one threshold for all data");
  app.add_option("runs", list, "CSV file with the runs (see place_run.hpp)");
  app.add_option("--shared", shared, "data folder whose sets are run where no list is given");
  app.add_option("--window", built_in.windows, "s, of the built-in runs")->delimiter(',');
  app.add_option("--min-confidence", built_in.min_confidences, "of the built-in runs")
      ->delimiter(',');
  app.add_option("--rooms-stride", built_in.rooms_stride, "every so many queries in rooms")
      ->check(program::number_within(1));
  app.add_option("--stride", stride, "every so many queries of every run")
      ->check(program::number_within(1));
  app.add_option("--only", only, "runs whose name has this in it");
  app.add_option("--layouts", layouts,
                 "FILE of a layout prior, or usual: what stands alike because it always does earns "
                 "less");
  app.add_option("--jobs", jobs, "threads, each of which takes a run");
  CLI11_PARSE(app, argc, argv);
  if (list.empty() && shared.empty()) {
    std::cout << "Skips the places: neither a list, nor --shared, nor TOPOBAG_DATA.\n";
    return 0;
  }
  try {
    std::vector<PlaceRun> runs;
    for (PlaceRun run : list.empty() ? shared_runs(shared, built_in) : read_place_runs(list)) {
      if (run.name.find(only) == std::string::npos) continue;
      run.stride *= stride;
      runs.push_back(std::move(run));
    }
    topobag::RecognitionOptions options = accept_any_score();
    if (!layouts.empty()) options.matching.chance.layouts = layout_prior(layouts);
    const std::vector<Result> results = results_of(runs, options, jobs);
    for (const bool gravity : {false, true}) print_pool(results, gravity);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
