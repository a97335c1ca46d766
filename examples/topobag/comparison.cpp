// SPDX-License-Identifier: MIT
#include "comparison.hpp"

#include <iomanip>
#include <sstream>

#include <topobag/evaluation/precision_recall.hpp>
#include <topobag/evaluation/recall_at_k.hpp>

namespace program {

std::vector<ComparisonNumber> numbers_of(const ComparedMethod& method) {
  using topobag::RetrievalMetrics;
  const auto metrics = topobag::retrieval_metrics(topobag::single_best(method.labelled));
  const auto best = [&](double RetrievalMetrics::*value) {
    return metrics ? std::optional<double>((*metrics).*value) : std::nullopt;
  };
  const auto recall = [&](std::size_t k) {
    return topobag::recall_at_k(method.labelled, k).of_queries_with_positive();
  };
  const auto count = [&](std::size_t RunSummary::*value) {
    return method.poses ? std::optional<double>((*method.poses).*value) : std::nullopt;
  };
  return {{"average_precision", "AP", 3, best(&RetrievalMetrics::average_precision)},
          {"auc_pr", "AUC-PR", 3, best(&RetrievalMetrics::auc_pr)},
          {"recall_at_1", "R@1", 3, recall(1)},
          {"recall_at_5", "R@5", 3, recall(5)},
          {"recall_at_100p", "R@100P", 3, best(&RetrievalMetrics::recall_at_100p)},
          {"f1_max", "F1max", 3, best(&RetrievalMetrics::f1_max)},
          {"pair_us", "us/pair", 2, method.pair_us},
          {"accepted", "accepted", 0, count(&RunSummary::accepted)},
          {"correct", "correct", 0, count(&RunSummary::correct)},
          {"imprecise", "imprecise", 0, count(&RunSummary::imprecise)},
          {"wrong", "wrong", 0, count(&RunSummary::wrong)}};
}

std::string to_json(const Comparison& comparison) {
  Json json{{"map", comparison.map_set},
            {"query", comparison.query_set},
            {"protocol", comparison.protocol},
            {"verified", comparison.verified}};
  Json& methods = json["methods"] = Json::array();
  for (const ComparedMethod& method : comparison.methods) {
    Json row{{"name", method.name}, {"meaning", method.meaning}};
    for (const ComparisonNumber& number : numbers_of(method)) {
      const bool whole = number.decimals == 0 && number.value;
      row[number.key] =
          whole ? Json(static_cast<std::size_t>(*number.value)) : or_null(number.value);
    }
    methods.push_back(std::move(row));
  }
  return output_text(json, true);
}

std::string to_table(const Comparison& comparison) {
  std::ostringstream out;
  out << std::fixed << std::left << std::setw(24) << "method" << std::right;
  for (const ComparisonNumber& number : numbers_of({})) out << std::setw(10) << number.heading;
  for (const ComparedMethod& method : comparison.methods) {
    out << '\n' << std::left << std::setw(24) << method.name << std::right;
    for (const ComparisonNumber& number : numbers_of(method)) {
      out << std::setw(10) << std::setprecision(number.decimals);
      if (number.value) {
        out << *number.value;
      } else {
        out << '-';
      }
    }
  }
  out << "\n\n"
      << name_of(comparison.query_set) << " in " << name_of(comparison.map_set)
      << "; a true place: " << comparison.protocol
      << ".\nAP, AUC-PR, R@100P and F1max of each query's best answer; R@K of "
      << "the queries with a true place.\nAccepted and verdicts: the library's verification of a "
      << "similarity's best " << comparison.verified << " answers.\n";
  for (const ComparedMethod& method : comparison.methods) {
    out << "  " << std::left << std::setw(24) << method.name << method.meaning << '\n';
  }
  return out.str();
}

}  // namespace program
