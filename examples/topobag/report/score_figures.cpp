// SPDX-License-Identifier: MIT
#include "score_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <topobag/evaluation/precision_recall.hpp>
#include <topobag/evaluation/recall_at_k.hpp>

#include "html_text.hpp"
#include "svg_plot.hpp"

namespace program {
namespace {

const std::array<const char*, 3> series{"first", "second", "third"};

const char* series_of(std::size_t method) {
  return method < series.size() ? series[method] : "other";
}

/// Whether a figure's text speaks of the method, or leaves it to its hint and its numbers.
bool is_told(std::size_t method) { return method < series.size(); }

void explain_lines(SvgPlot& plot, const std::vector<NamedScores>& methods) {
  for (std::size_t i = 0; i < methods.size() && is_told(i); ++i) {
    plot.explain_line(series_of(i), methods[i].name);
  }
  if (methods.size() > series.size()) {
    plot.explain_line(series_of(series.size()),
                      std::to_string(methods.size() - series.size()) + " others: point at them");
  }
}

std::string percent(double share) { return fixed_text(100.0 * share, 1) + " %"; }

/// The points of a curve that a drawing can show apart; the first and the last among them.
std::vector<topobag::OperatingPoint> thinned(const std::vector<topobag::OperatingPoint>& curve) {
  const double visible = 1e-3;
  std::vector<topobag::OperatingPoint> points;
  for (const topobag::OperatingPoint& point : curve) {
    const bool apart = points.empty() || point.recall() - points.back().recall() > visible ||
                       std::abs(point.precision() - points.back().precision()) > visible ||
                       &point == &curve.back();
    if (apart) points.push_back(point);
  }
  return points;
}

}  // namespace

Figure precision_recall_figure(const std::vector<NamedScores>& methods,
                               const std::string& reading) {
  Figure figure{"precision-recall", "Precision and recall", "", ""};
  figure.table.columns = {"scores", "threshold", "recall", "precision"};
  SvgPlot plot(round_axis("recall", 0.0, 1.0), round_axis("precision", 0.0, 1.0));
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const NamedScores& method = methods[i];
    std::vector<Eigen::Vector2d> line;
    for (const auto& point : thinned(topobag::precision_recall_curve(method.labelled))) {
      if (line.empty()) line.emplace_back(0.0, point.precision());
      line.emplace_back(point.recall(), point.precision());
      figure.table.rows.push_back(Json::array(
          {method.name, method.sign * point.threshold, point.recall(), point.precision()}));
    }
    plot.line(line, series_of(i), method.name);
    if (!is_told(i)) continue;
    const auto metrics = topobag::retrieval_metrics(method.labelled);
    figure.caption += method.name + ": ";
    if (metrics) {
      figure.caption += "AP " + percent(metrics->average_precision) +
                        ", recall at 100 % precision " + percent(metrics->recall_at_100p) +
                        ", best F1 " + percent(metrics->f1_max) + ". ";
    } else {
      figure.caption += "no true pair, so no curve. ";
    }
  }
  figure.caption += reading;
  explain_lines(plot, methods);
  figure.drawing = plot.svg("Precision over recall. " + figure.caption);
  return figure;
}

Figure recall_at_k_figure(const std::vector<NamedScores>& methods) {
  Figure figure{"recall-at-k", "Recall among the best K answers", "", ""};
  figure.table.columns = {"scores", "k", "recall"};
  std::vector<std::vector<std::size_t>> ranks;
  std::size_t most = 10;
  for (const NamedScores& method : methods) {
    ranks.push_back(topobag::first_positive_ranks(method.labelled));
    most = std::max(most, *std::max_element(ranks.back().begin(), ranks.back().end()));
  }
  const std::size_t last = std::min<std::size_t>(most, 50);
  SvgPlot plot(round_axis("K, best answers of a query", 1.0, static_cast<double>(last)),
               round_axis("queries with a true answer among K", 0.0, 1.0));
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const NamedScores& method = methods[i];
    std::vector<Eigen::Vector2d> line;
    const auto has_positive = [](const topobag::PairTotals& t) { return t.positives > 0; };
    const auto all =
        std::count_if(method.labelled.totals.begin(), method.labelled.totals.end(), has_positive);
    for (std::size_t k = 1; k <= last && all > 0; ++k) {
      const auto hits = std::count_if(ranks[i].begin(), ranks[i].end(),
                                      [&](std::size_t rank) { return rank >= 1 && rank <= k; });
      line.emplace_back(static_cast<double>(k),
                        static_cast<double>(hits) / static_cast<double>(all));
      figure.table.rows.push_back(Json::array({method.name, k, line.back().y()}));
    }
    plot.line(line, series_of(i), method.name);
    if (!is_told(i)) continue;
    figure.caption += method.name + ": ";
    figure.caption += all > 0 ? "Recall@1 " + percent(line.front().y()) + ", Recall@10 " +
                                    percent(line[9].y()) + " of " + std::to_string(all) +
                                    " queries with a true place. "
                              : "no query has a true place. ";
  }
  explain_lines(plot, methods);
  figure.drawing = plot.svg("Recall over K. " + figure.caption);
  return figure;
}

Figure score_histogram_figure(const std::string& id, const NamedScores& scores) {
  constexpr std::size_t bins = 40;
  const std::vector<topobag::LabelledScore>& all = scores.labelled.scores;
  const std::string& scored = scores.scored;
  Figure figure{id, "True and false " + scored + " by " + scores.name, "", ""};
  figure.table.columns = {"from", "to", "true_" + scored, "false_" + scored};
  double low = all.empty() ? 0.0 : scores.sign * all.back().score;
  double high = all.empty() ? 1.0 : scores.sign * all.front().score;
  if (low > high) std::swap(low, high);
  if (low == high) high = low + 1.0;
  std::array<std::array<std::size_t, bins>, 2> counts{};  // false, true
  std::array<std::size_t, 2> totals{};
  for (const topobag::LabelledScore& score : all) {
    const double share = (scores.sign * score.score - low) / (high - low);
    const auto bin = std::min(bins - 1, static_cast<std::size_t>(share * bins));
    ++counts[score.positive ? 1 : 0][bin];
    ++totals[score.positive ? 1 : 0];
  }
  double highest = 0.0;
  const auto share_of = [&](std::size_t kind, std::size_t bin) {
    const double share = totals[kind] == 0 ? 0.0
                                           : static_cast<double>(counts[kind][bin]) /
                                                 static_cast<double>(totals[kind]);
    highest = std::max(highest, share);
    return share;
  };
  std::array<std::array<double, bins>, 2> shares{};
  for (std::size_t kind = 0; kind < 2; ++kind) {
    for (std::size_t bin = 0; bin < bins; ++bin) shares[kind][bin] = share_of(kind, bin);
  }
  SvgPlot plot(round_axis(scores.name, low, high),
               axis_from_zero("share of the " + scored + " of its kind", highest));
  const double width = (high - low) / bins;
  const std::array<const char*, 2> styles{"over false", "over true"};
  const std::array<std::string, 2> names{"false " + scored, "true " + scored};
  for (std::size_t kind = 0; kind < 2; ++kind) {
    for (std::size_t bin = 0; bin < bins; ++bin) {
      if (counts[kind][bin] == 0) continue;
      const double from = low + static_cast<double>(bin) * width;
      plot.bar({from, 0.0}, {from + width, shares[kind][bin]}, styles[kind],
               std::to_string(counts[kind][bin]) + ' ' + names[kind] + " from " + short_text(from) +
                   " to " + short_text(from + width));
    }
  }
  for (std::size_t kind = 2; kind-- > 0;) {
    plot.explain_bar(styles[kind], std::to_string(totals[kind]) + ' ' + names[kind]);
  }
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const double from = low + static_cast<double>(bin) * width;
    figure.table.rows.push_back(Json::array({from, from + width, counts[1][bin], counts[0][bin]}));
  }
  figure.caption = "Each kind adds up to 1. " + std::to_string(totals[1]) + " true and " +
                   std::to_string(totals[0]) + " false " + scored + " have a score";
  const topobag::PairTotals pairs = topobag::sum_of_totals(scores.labelled);
  const std::size_t unscored =
      pairs.positives - totals[1] + (pairs.negatives > totals[0] ? pairs.negatives - totals[0] : 0);
  figure.caption += unscored > 0 ? ", " + std::to_string(unscored) + " have none." : ".";
  figure.drawing = plot.svg(figure.title + ". " + figure.caption);
  return figure;
}

}  // namespace program
