// SPDX-License-Identifier: MIT
#include "outcome_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "html_text.hpp"

namespace program {
namespace {

using Values = std::vector<std::pair<double, Outcome>>;

/// Counts of outcomes between edges, the last edge included.
class Bins {
 public:
  explicit Bins(std::vector<double> edges) : edges_(std::move(edges)), counts_(edges_.size() - 1) {}

  void add(double value, Outcome outcome) {
    const auto after = std::upper_bound(edges_.begin(), edges_.end(), value);
    const std::ptrdiff_t at = after - edges_.begin() - 1;
    const auto last = static_cast<std::ptrdiff_t>(size()) - 1;
    ++counts_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, last))]
             [static_cast<std::size_t>(outcome)];
  }

  std::size_t size() const { return counts_.size(); }
  double from(std::size_t bin) const { return edges_[bin]; }
  double to(std::size_t bin) const { return edges_[bin + 1]; }
  std::size_t count(std::size_t bin, Outcome outcome) const {
    return counts_[bin][static_cast<std::size_t>(outcome)];
  }
  std::size_t total(std::size_t bin) const {
    std::size_t sum = 0;
    for (const std::size_t count : counts_[bin]) sum += count;
    return sum;
  }
  std::size_t most() const {
    std::size_t most = 0;
    for (std::size_t bin = 0; bin < size(); ++bin) most = std::max(most, total(bin));
    return most;
  }
  bool holds(Outcome outcome) const {
    for (std::size_t bin = 0; bin < size(); ++bin) {
      if (count(bin, outcome) > 0) return true;
    }
    return false;
  }

 private:
  std::vector<double> edges_;
  std::vector<std::array<std::size_t, all_outcomes.size()>> counts_;
};

/// Round edges about all values.
std::vector<double> round_edges(double low, double high, std::size_t max_count) {
  if (!(high > low)) high = low + 1.0;
  std::vector<double> edges;
  for (const Tick& tick : round_ticks(low, high, max_count)) edges.push_back(tick.value);
  const double step = edges.size() > 1 ? edges[1] - edges[0] : high - low;
  if (edges.front() > low) edges.insert(edges.begin(), edges.front() - step);
  if (edges.back() < high) edges.push_back(edges.back() + step);
  return edges;
}

DataTable table_of(const Bins& bins) {
  DataTable table{{"from", "to"}, {}};
  for (const Outcome outcome : all_outcomes) {
    if (bins.holds(outcome)) table.columns.emplace_back(style_of(outcome).name);
  }
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    Json row = Json::array({bins.from(bin), bins.to(bin)});
    for (const Outcome outcome : all_outcomes) {
      if (bins.holds(outcome)) row.push_back(bins.count(bin, outcome));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Stacks the outcomes of each bin from `left(bin)` to `right(bin)`; a count is `unit(bin)` high.
void draw_stacks(SvgPlot& plot, const Bins& bins, const std::function<double(std::size_t)>& left,
                 const std::function<double(std::size_t)>& right,
                 const std::function<double(std::size_t)>& unit) {
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    double base = 0.0;
    for (const Outcome outcome : all_outcomes) {
      const std::size_t count = bins.count(bin, outcome);
      if (count == 0) continue;
      const double top = base + unit(bin) * static_cast<double>(count);
      plot.bar({left(bin), base}, {right(bin), top}, style_of(outcome).style,
               std::to_string(count) + " of " + std::to_string(bins.total(bin)) + ' ' +
                   style_of(outcome).name + ", from " + short_text(bins.from(bin)) + " to " +
                   short_text(bins.to(bin)));
      base = top;
    }
  }
  for (const Outcome outcome : all_outcomes) {
    if (bins.holds(outcome)) plot.explain_bar(style_of(outcome).style, style_of(outcome).name);
  }
}

/// Shares of the outcomes in each bin; empty bins are kept, without a bar.
/// @param whole  the values are whole numbers
Figure share_figure(const char* id, const char* title, const char* label, const Bins& bins,
                    bool whole = false) {
  Figure figure{id, title, "", ""};
  PlotAxis x{label, 0.0, static_cast<double>(bins.size()), {}};
  std::size_t queries = 0;
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    const double last = whole ? bins.to(bin) - 1.0 : bins.to(bin);
    x.ticks.push_back(
        {static_cast<double>(bin) + 0.5,
         short_text(bins.from(bin)) + (last > bins.from(bin) ? "–" + short_text(last) : "")});
    figure.caption += (bin > 0 ? ", " : "") + std::to_string(bins.total(bin));
    queries += bins.total(bin);
  }
  figure.caption = "Of " + std::to_string(queries) +
                   " queries with a true place; queries in each bar: " + figure.caption + ".";
  SvgPlot plot(std::move(x), round_axis("share of the queries", 0.0, 1.0));
  draw_stacks(
      plot, bins, [](std::size_t bin) { return static_cast<double>(bin) + 0.12; },
      [](std::size_t bin) { return static_cast<double>(bin) + 0.88; },
      [&](std::size_t bin) { return 1.0 / static_cast<double>(bins.total(bin)); });
  figure.table = table_of(bins);
  figure.drawing = plot.svg(figure.title + ". " + figure.caption);
  return figure;
}

Bins binned(const Values& values, std::vector<double> edges) {
  Bins bins(std::move(edges));
  for (const auto& [value, outcome] : values) bins.add(value, outcome);
  return bins;
}

std::vector<double> edges_about(const Values& values, std::size_t max_count) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return round_edges(low->first, high->first, max_count);
}

/// The same for whole numbers, with a whole number of them in each bin.
std::vector<double> whole_edges_about(const Values& values, std::size_t max_bins) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double count = high->first - low->first + 1.0;
  const double step = std::ceil(count / static_cast<double>(max_bins));
  std::vector<double> edges{low->first};
  while (edges.back() <= high->first) edges.push_back(edges.back() + step);
  return edges;
}

Figure error_figure(const char* id, const char* title, const char* label, const Values& values,
                    const std::string& limits) {
  Figure figure{id, title, "", ""};
  double most = 0.0;
  std::vector<double> sorted;
  for (const auto& [value, outcome] : values) sorted.push_back(value);
  std::sort(sorted.begin(), sorted.end());
  most = sorted.back();
  const Bins bins = binned(values, round_edges(0.0, most, 21));
  SvgPlot plot(round_axis(label, 0.0, bins.to(bins.size() - 1)),
               axis_from_zero("accepted matches", static_cast<double>(bins.most())));
  draw_stacks(
      plot, bins, [&](std::size_t bin) { return bins.from(bin); },
      [&](std::size_t bin) { return bins.to(bin); }, [](std::size_t) { return 1.0; });
  figure.caption =
      std::to_string(sorted.size()) + " accepted matches with a known true pose: median " +
      short_text(sorted[sorted.size() / 2]) + ", largest " + short_text(most) + ". " + limits;
  figure.table = table_of(bins);
  figure.drawing = plot.svg(figure.title + ". " + figure.caption);
  return figure;
}

}  // namespace

std::vector<Figure> breakdown_figures(const std::vector<QueryOutcome>& outcomes) {
  Values angles;
  Values overlaps;
  Values objects;
  Values gaps;
  for (const QueryOutcome& query : outcomes) {
    if (!query.place) continue;
    angles.emplace_back(query.place->angle_deg, query.outcome);
    if (query.place->overlap) overlaps.emplace_back(*query.place->overlap, query.outcome);
    if (query.objects) objects.emplace_back(static_cast<double>(*query.objects), query.outcome);
    gaps.emplace_back(query.place->gap_s, query.outcome);
  }
  std::vector<Figure> figures;
  if (angles.empty()) return figures;
  figures.push_back(share_figure("by-angle", "By view angle",
                                 "angle between query and nearest true place, °",
                                 binned(angles, {0, 10, 20, 30, 45, 90, 180})));
  if (!overlaps.empty()) {
    figures.push_back(share_figure("by-overlap", "By overlap of the views",
                                   "overlap of query and nearest true place",
                                   binned(overlaps, edges_about(overlaps, 7))));
  }
  if (!objects.empty()) {
    figures.push_back(share_figure("by-objects", "By number of objects",
                                   "nodes of the query's graph",
                                   binned(objects, whole_edges_about(objects, 7)), true));
  }
  figures.push_back(share_figure("by-gap", "By time gap", "time between query and true place, s",
                                 binned(gaps, edges_about(gaps, 6))));
  return figures;
}

std::vector<Figure> error_figures(const std::vector<JudgedError>& errors,
                                  const topobag::PoseLimits& limits) {
  if (errors.empty()) return {};
  Values translations;
  Values rotations;
  for (const JudgedError& judged : errors) {
    translations.emplace_back(judged.error.translation_m, judged.outcome);
    rotations.emplace_back(judged.error.rotation_deg, judged.outcome);
  }
  const auto sentence = [](double correct, double wrong, const char* unit) {
    return "Correct up to " + short_text(correct) + unit + ", wrong beyond " + short_text(wrong) +
           unit + "; a match is correct by both errors.";
  };
  return {error_figure("translation-error", "Translation error of accepted matches",
                       "translation error, m", translations,
                       sentence(limits.correct_translation_m, limits.wrong_translation_m, " m")),
          error_figure("rotation-error", "Rotation error of accepted matches", "rotation error, °",
                       rotations,
                       sentence(limits.correct_rotation_deg, limits.wrong_rotation_deg, "°"))};
}

}  // namespace program
