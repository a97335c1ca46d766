// SPDX-License-Identifier: MIT
#include "comparison.hpp"

#include <iomanip>
#include <sstream>

#include <topobag/evaluation/precision_recall.hpp>
#include <topobag/evaluation/recall_at_k.hpp>

#include "report/html_text.hpp"

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
  Json json{{"map", comparison.map_set},           {"query", comparison.query_set},
            {"protocol", comparison.protocol},     {"verified", comparison.verified},
            {"true_pairs", comparison.true_pairs}, {"false_pairs", comparison.false_pairs}};
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

std::string to_markdown(const Comparison& comparison) {
  std::string head = "| method |", rule = "|---|", rows;
  for (const ComparisonNumber& number : numbers_of({})) {
    head += std::string(" ") + number.heading + " |";
    rule += "---|";
  }
  for (const ComparedMethod& method : comparison.methods) {
    rows += "| " + method.name + " |";
    for (const ComparisonNumber& number : numbers_of(method)) {
      rows += ' ' + (number.value ? fixed_text(*number.value, number.decimals) : "–") + " |";
    }
    rows += '\n';
  }
  return head + '\n' + rule + '\n' + rows;
}

std::string to_table(const Comparison& comparison) {
  std::ostringstream out;
  const auto cell = [&](const std::string& text) { out << std::right << std::setw(10) << text; };
  const auto name = [&](const std::string& text) { out << std::left << std::setw(24) << text; };
  name("method");
  for (const ComparisonNumber& number : numbers_of({})) cell(number.heading);
  for (const ComparedMethod& method : comparison.methods) {
    out << '\n';
    name(method.name);
    for (const ComparisonNumber& number : numbers_of(method)) {
      cell(number.value ? fixed_text(*number.value, number.decimals) : "-");
    }
  }
  out << "\n\n"
      << name_of(comparison.query_set) << " in " << name_of(comparison.map_set)
      << "; a true place: " << comparison.protocol << ".\n"
      << "AP, AUC-PR, R@100P and F1max of each query's best answer; R@K of the queries with a true "
         "place.\nAccepted and verdicts: the library's verification of a similarity's best "
      << comparison.verified << " answers.\n";
  for (const ComparedMethod& method : comparison.methods) {
    out << "  ";
    name(method.name);
    out << method.meaning << '\n';
  }
  return out.str();
}

}  // namespace program
