// SPDX-License-Identifier: MIT
#include "match_figures.hpp"

#include <algorithm>

#include "html_text.hpp"
#include "match_svg.hpp"

namespace program {
namespace {

const topobag::RelativePose& pose_of(const QueryRecord& record) {
  return *record.recognition.accepted->pose;
}

Figure match_figure(const RecognitionRun& run, std::size_t i, std::string id, std::string title) {
  const QueryRecord& record = run.records[i];
  const topobag::CandidateReport& match = *record.recognition.accepted;
  const auto [score, asked] = topobag::told_apart(match.score(), match.threshold);
  Figure figure{std::move(id), std::move(title), "", ""};
  figure.wide = true;
  figure.drawing = "<div class=\"drawing\">" + match_svg(run, i) + "</div>\n";
  figure.caption =
      "Query " + name_of(run.queries[i]) + " in map " + name_of(run.map[topobag::value(match.id)]) +
      ": " + std::to_string(match.pose->inliers.size()) + " objects agree, score " + score +
      " of " + asked + " asked for, similarity " + fixed_text(match.similarity, 2) + ". ";
  figure.caption += record.error
                        ? "Off the true pose by " + fixed_text(record.error->translation_m, 2) +
                              " m and " + fixed_text(record.error->rotation_deg, 1) + "°."
                        : "The true pose is not known.";
  return figure;
}

/// Whether the first match is worse: by its error where both are known, else by its score.
bool is_worse(const QueryRecord& a, const QueryRecord& b) {
  if (a.error && b.error) return a.error->translation_m > b.error->translation_m;
  return pose_of(a).score() < pose_of(b).score();
}

}  // namespace

std::vector<Figure> match_figures(const RecognitionRun& run, std::size_t max_wrong) {
  std::vector<std::size_t> good;
  std::vector<std::size_t> wrong;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    if (!run.records[i].recognition.accepted || !is_drawable(run, i)) continue;
    (run.records[i].verdict == topobag::PoseVerdict::wrong ? wrong : good).push_back(i);
  }
  const auto by_score = [&](std::size_t a, std::size_t b) {
    return pose_of(run.records[a]).score() > pose_of(run.records[b]).score();
  };
  std::stable_sort(good.begin(), good.end(), by_score);
  std::stable_sort(wrong.begin(), wrong.end(), by_score);

  std::vector<Figure> figures;
  if (!good.empty()) {
    const std::size_t best = good.front();
    figures.push_back(match_figure(run, best, "match-best", "The best match: the highest score"));
    const std::size_t worst = *std::max_element(
        good.begin(), good.end(),
        [&](std::size_t a, std::size_t b) { return is_worse(run.records[b], run.records[a]); });
    if (worst != best) {
      const bool by_error = run.records[worst].error.has_value();
      figures.push_back(match_figure(run, worst, "match-worst",
                                     std::string("The worst match that is not wrong: the ") +
                                         (by_error ? "largest error" : "lowest score")));
    }
  }
  for (std::size_t i = 0; i < std::min(wrong.size(), max_wrong); ++i) {
    figures.push_back(match_figure(
        run, wrong[i], "match-wrong-" + std::to_string(i + 1),
        "Wrong match " + std::to_string(i + 1) + " of " + std::to_string(wrong.size())));
  }
  return figures;
}

}  // namespace program
