// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <topobag/recognition/decision_options.hpp>

#include "leave_one_out.hpp"
#include "place_run.hpp"
#include "pooled_figures.hpp"

/// A run and what its queries came to.
struct PlaceResult {
  PlaceRun run;
  std::vector<ScoredQuery> queries;
  double milliseconds = 0.0;  // mean of a query, its graphs and map included

  Figures by_default() const { return figures_at(queries, PooledMargins::by_default); }
};

inline double share(std::size_t part, std::size_t all) {
  return all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
}

inline void print_head(const char* pool) {
  std::printf("\n%s\n%-26s %5s %3s %7s | %-22s | %-22s | %-22s | %7s\n", pool, "", "", "", "",
              "default", "beyond best false", "1 false in 1,000", "");
  std::printf("%-26s %5s %3s %7s |", "query:map", "kind", "s", "queries");
  for (int i = 0; i < 3; ++i) std::printf(" %5s %5s %4s %5s |", "acc.", "corr.", "imp.", "false");
  std::printf(" %7s\n", "ms");
}

inline void print(const std::string& name, const char* kind, double window, bool gravity,
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

/// Prints what the surplus would be, were each place left out of choosing it, and what that surplus
/// does there.
inline void print_left_out(const std::vector<PlaceResult>& results) {
  std::vector<RunQueries> runs;
  for (const PlaceResult& result : results) runs.push_back({result.run.places, result.queries});
  const double false_share = 1.0 / 2000.0;
  const auto folds = leave_one_out(runs, false_share);
  if (folds.size() < 2) return;
  std::printf(
      "\nsurplus chosen without a place, with and without gravity: at most one query in 2,000 of "
      "the others "
      "answered falsely\n%-12s %8s | %7s %5s %5s | %7s %5s %5s\n",
      "left out", "surplus", "others", "corr.", "false", "its own", "corr.", "false");
  for (const LeftOut& fold : folds) {
    const double surplus = topobag::DecisionOptions{}.surplus - fold.margin;
    std::printf("%-12s %8.2f | %7zu %5zu %5zu | %7zu %5zu %5zu\n", fold.place.c_str(), surplus,
                fold.kept.queries, fold.kept.correct, fold.kept.wrong, fold.left_out.queries,
                fold.left_out.correct, fold.left_out.wrong);
    std::printf(
        "{\"bench\":\"places\",\"left_out\":\"%s\",\"surplus\":%.3f,"
        "\"queries\":%zu,\"correct\":%zu,\"false\":%zu}\n",
        fold.place.c_str(), surplus, fold.left_out.queries, fold.left_out.correct,
        fold.left_out.wrong);
  }
}

/// Prints the runs with or without gravity, the worst first, and all together.
inline void print_pool(std::vector<PlaceResult> results, bool gravity) {
  const auto is_of_other_pool = [&](const PlaceResult& result) {
    return result.run.world_up.has_value() != gravity;
  };
  results.erase(std::remove_if(results.begin(), results.end(), is_of_other_pool), results.end());
  if (results.empty()) return;
  std::stable_sort(results.begin(), results.end(), [](const PlaceResult& a, const PlaceResult& b) {
    return share(a.by_default().wrong, a.queries.size()) >
           share(b.by_default().wrong, b.queries.size());
  });
  std::vector<ScoredQuery> all, with_a_place, of_other_places;
  double milliseconds = 0.0;
  for (const PlaceResult& result : results) {
    auto& kind = result.run.kind == PlaceKind::other ? of_other_places : with_a_place;
    for (auto* pool : {&all, &kind}) {
      pool->insert(pool->end(), result.queries.begin(), result.queries.end());
    }
    milliseconds += result.milliseconds * static_cast<double>(result.queries.size());
  }
  const PooledMargins margins = pooled_margins(all);
  print_head(gravity ? "with gravity" : "without gravity");
  for (const PlaceResult& result : results) {
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
