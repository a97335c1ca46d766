// SPDX-License-Identifier: MIT
#include "retrieval_report.hpp"

#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

#include <topobag/evaluation/precision_recall.hpp>
#include <topobag/evaluation/recall_at_k.hpp>

#include "progress.hpp"

namespace program {
namespace {

using topobag::LabelledScores;
using topobag::RetrievalMetrics;

/// The metrics by name, in the order of the output.
std::vector<std::pair<const char*, std::optional<double>>> named(const RetrievalMetrics& m) {
  return {
      {"average_precision", m.average_precision},   {"auc_pr", m.auc_pr},
      {"recall_at_100p", m.recall_at_100p},         {"lowest_recall_precision", m.lowest_recall_p},
      {"extended_precision", m.extended_precision}, {"f1_max", m.f1_max},
      {"precision_at_100r", m.precision_at_100r},   {"roc_auc", m.roc_auc}};
}

Json interval_json(const std::optional<topobag::ConfidenceInterval>& interval) {
  return interval ? Json::array({interval->low, interval->high}) : Json();
}

/// Confidence intervals of every metric; resamples where one is undefined do not count for it.
Json intervals_json(const LabelledScores& labelled, const RetrievalReportOptions& options) {
  std::map<std::string, std::vector<double>> values;
  Progress progress(options.resampling.resamples, "resamples scored");
  topobag::for_each_resample(labelled.totals.size(), options.resampling, [&](const auto& times) {
    progress.step();
    const auto metrics = topobag::retrieval_metrics(labelled, times);
    if (!metrics) return;
    for (const auto& [name, value] : named(*metrics)) {
      if (value) values[name].push_back(*value);
    }
  });
  Json json;
  for (const auto& [name, value] : named({})) {
    json[name] = interval_json(topobag::percentile_interval(values[name], options.level));
  }
  return json;
}

Json metrics_json(const LabelledScores& labelled, const RetrievalReportOptions& options) {
  const auto metrics = topobag::retrieval_metrics(labelled);
  Json json;
  for (const auto& [name, value] : named(metrics.value_or(RetrievalMetrics{}))) {
    json[name] = metrics ? or_null(value) : Json();
  }
  json["f1_max_threshold"] = metrics && metrics->f1_max > 0.0
                                 ? Json(options.score_sign * metrics->f1_max_threshold)
                                 : Json();
  if (options.resampling.resamples > 0) json["intervals"] = intervals_json(labelled, options);
  return json;
}

/// Per query with a positive: 1 when its best answer is one, else 0.
std::vector<double> first_answers(const LabelledScores& labelled) {
  std::vector<double> hits;
  const auto ranks = topobag::first_positive_ranks(labelled);
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    if (labelled.totals[i].positives > 0) hits.push_back(ranks[i] == 1 ? 1.0 : 0.0);
  }
  return hits;
}

void append(std::string& text, double value, char end) {
  std::array<char, 32> digits{};
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  text += end;
}

}  // namespace

Json retrieval_json(const LabelledScores& labelled, const RetrievalReportOptions& options) {
  const topobag::PairTotals totals = topobag::sum_of_totals(labelled);
  const topobag::RecallAtK any = topobag::recall_at_k(labelled, 1);
  Json json;
  json["queries"] = any.queries;
  json["queries_with_positive"] = any.queries_with_positive;
  json["positive_pairs"] = totals.positives;
  json["negative_pairs"] = totals.negatives;
  json["scored_pairs"] = labelled.scores.size();
  json["pairs"] = metrics_json(labelled, options);
  json["single_best"] = metrics_json(topobag::single_best(labelled), options);
  Json of_queries_with_positive;
  Json of_all_queries;
  for (const std::size_t k : options.ks) {
    const topobag::RecallAtK recall = topobag::recall_at_k(labelled, k);
    of_queries_with_positive[std::to_string(k)] = or_null(recall.of_queries_with_positive());
    of_all_queries[std::to_string(k)] = or_null(recall.of_all_queries());
  }
  json["recall_at_k"]["of_queries_with_positive"] = std::move(of_queries_with_positive);
  json["recall_at_k"]["of_all_queries"] = std::move(of_all_queries);
  if (options.resampling.resamples > 0) {
    json["resamples"] = options.resampling.resamples;
    json["seed"] = options.resampling.seed;
    json["level"] = options.level;
  }
  return json;
}

Json comparison_json(const LabelledScores& a, const LabelledScores& b,
                     const RetrievalReportOptions& options) {
  topobag::ResamplingOptions resampling = options.resampling;
  if (resampling.resamples == 0) resampling.resamples = topobag::ResamplingOptions{}.resamples;
  Json json;
  json["resamples"] = resampling.resamples;
  json["seed"] = resampling.seed;
  json["level"] = options.level;

  const auto difference = [&](const topobag::QueryMultiplicity& times) -> std::optional<double> {
    const auto of_a = topobag::retrieval_metrics(a, times);
    const auto of_b = topobag::retrieval_metrics(b, times);
    if (!of_a || !of_b) return std::nullopt;
    return of_b->average_precision - of_a->average_precision;
  };
  std::vector<double> differences;
  Progress progress(resampling.resamples, "resamples compared");
  topobag::for_each_resample(a.totals.size(), resampling, [&](const auto& times) {
    progress.step();
    if (const auto value = difference(times)) differences.push_back(*value);
  });
  json["average_precision"]["difference"] = or_null(difference({}));
  json["average_precision"]["interval"] =
      interval_json(topobag::percentile_interval(std::move(differences), options.level));

  const auto test = topobag::paired_test(first_answers(a), first_answers(b), resampling);
  json["recall_at_1"]["difference"] = test.mean_difference;
  json["recall_at_1"]["p_value"] = test.p_value;
  return json;
}

Json verdicts_json(const topobag::LoopVerdicts& verdicts, const topobag::PoseLimits& limits) {
  Json json;
  json["limits"]["correct_m"] = limits.correct_translation_m;
  json["limits"]["correct_deg"] = limits.correct_rotation_deg;
  json["limits"]["wrong_m"] = limits.wrong_translation_m;
  json["limits"]["wrong_deg"] = limits.wrong_rotation_deg;
  json["accepted"] = verdicts.accepted();
  json["correct"] = verdicts.correct;
  json["imprecise"] = verdicts.imprecise;
  json["wrong"] = verdicts.wrong;
  json["precision"] = or_null(verdicts.precision());
  return json;
}

std::string curve_csv(const LabelledScores& labelled, const RetrievalReportOptions& options) {
  std::string text = "threshold,true_positives,false_positives,precision,recall,f1\n";
  for (const topobag::OperatingPoint& point : topobag::precision_recall_curve(labelled)) {
    append(text, options.score_sign * point.threshold, ',');
    append(text, static_cast<double>(point.true_positives), ',');
    append(text, static_cast<double>(point.false_positives), ',');
    append(text, point.precision(), ',');
    append(text, point.recall(), ',');
    append(text, point.f1(), '\n');
  }
  return text;
}

std::string ranks_csv(const LabelledScores& labelled) {
  std::string text = "query,positives,negatives,first_positive_rank\n";
  const auto ranks = topobag::first_positive_ranks(labelled);
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    const topobag::PairTotals& totals = labelled.totals[i];
    text += std::to_string(i) + ',' + std::to_string(totals.positives) + ',' +
            std::to_string(totals.negatives) + ',' +
            (ranks[i] > 0 ? std::to_string(ranks[i]) : std::string()) + '\n';
  }
  return text;
}

}  // namespace program
