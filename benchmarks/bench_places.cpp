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
//
// Last, every place is left out in turn of choosing the default's one number, its surplus.
#include <atomic>
#include <chrono>
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
#include "place_tables.hpp"
#include "shared_runs.hpp"

namespace {

topobag::LayoutPrior layout_prior(const std::string& file) {
  if (file == "usual") return topobag::usual_layouts(topobag::ClassCatalog::coco80());
  std::ifstream stream(file);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) throw program::InputError(file, "cannot be read");
  return topobag::parse_layout_prior(text);
}

/// Looks all runs up; the results do not depend on the number of threads.
std::vector<PlaceResult> results_of(const std::vector<PlaceRun>& runs,
                                    const topobag::RecognitionOptions& options, unsigned jobs) {
  std::vector<PlaceResult> results(runs.size());
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
  double lead_deviations = topobag::DecisionOptions{}.lead_deviations;
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
  app.add_option("--lead-deviations", lead_deviations,
                 "asked over a place that is believable itself, where it is not the default");
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
    options.decision.lead_deviations = lead_deviations;
    if (!layouts.empty()) options.matching.chance.layouts = layout_prior(layouts);
    const std::vector<PlaceResult> results = results_of(runs, options, jobs);
    for (const bool gravity : {false, true}) print_pool(results, gravity);
    print_left_out(results);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
