// SPDX-License-Identifier: MIT
#include "comparison_page.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include <topobag/evaluation/precision_recall.hpp>

#include "html_text.hpp"
#include "retrieval_page.hpp"

namespace program {
namespace {

Figure table_figure(const Comparison& comparison) {
  Figure figure{"comparison", "Every method on the same pairs", "", ""};
  figure.wide = true;
  std::ostringstream table;
  table << "<div class=\"table\"><table><tr><th class=\"name\">method</th>";
  figure.table.columns = {"method"};
  for (const ComparisonNumber& number : numbers_of({})) {
    table << "<th>" << escaped(number.heading) << "</th>";
    figure.table.columns.push_back(number.key);
  }
  for (const ComparedMethod& method : comparison.methods) {
    table << "</tr>\n<tr title=\"" << escaped(method.meaning) << "\"><td class=\"name\">"
          << escaped(method.name) << "</td>";
    Json row = Json::array({method.name});
    for (const ComparisonNumber& number : numbers_of(method)) {
      table << "<td>" << (number.value ? fixed_text(*number.value, number.decimals) : "–")
            << "</td>";
      row.push_back(or_null(number.value));
    }
    figure.table.rows.push_back(std::move(row));
  }
  table << "</tr></table></div>\n";
  figure.drawing = table.str();
  figure.caption =
      "AP, AUC-PR, R@100P and F1max of each query's best answer, R@K of the queries with a true "
      "place. Accepted and verdicts: the library's verification of a similarity's best " +
      std::to_string(comparison.verified) + " answers. Point at a row: what the method is.";
  return figure;
}

double average_precision(const ComparedMethod& method) {
  const auto metrics = topobag::retrieval_metrics(topobag::single_best(method.labelled));
  return metrics ? metrics->average_precision : 0.0;
}

}  // namespace

Report comparison_report(const Comparison& comparison, const KnownPlaces& places,
                         DecidedScores decided) {
  // The first two, the library and the paper, then the others, best first: those on top are told.
  std::vector<const ComparedMethod*> methods;
  for (const ComparedMethod& method : comparison.methods) methods.push_back(&method);
  std::stable_sort(methods.begin() + 2, methods.end(), [](const auto* a, const auto* b) {
    return average_precision(*a) > average_precision(*b);
  });
  RetrievalRun run;
  run.scores = std::move(decided.scores);
  run.outcomes = std::move(decided.outcomes);
  run.limits = decided.limits;
  run.one_trajectory = decided.one_sequence;
  for (const ComparedMethod* method : methods) {
    run.methods.push_back({method->name, method->labelled});
  }
  Report report = retrieval_report(places, run);
  report.title = "Methods held against each other: " + name_of(comparison.query_set) + " in " +
                 name_of(comparison.map_set);
  report.figures.insert(report.figures.begin(), table_figure(comparison));
  return report;
}

}  // namespace program
