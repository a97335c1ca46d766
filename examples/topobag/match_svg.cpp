// SPDX-License-Identifier: MIT
#include "match_svg.hpp"

#include <array>
#include <iomanip>
#include <set>
#include <sstream>

#include "graph_panel.hpp"
#include "input_error.hpp"

namespace program {
namespace {

const double panel_width = 560.0;  // px of the drawing
const double margin = 24.0;
const double width = 2 * panel_width + 3 * margin;
const double header = 92.0;

/// A color for each class, in the order of the class numbers.
ClassColors colors_of(const topobag::TopologyGraph<>& a, const topobag::TopologyGraph<>& b) {
  const std::array<const char*, 10> palette{"#1f6fb4", "#d95f02", "#2a9d5c", "#c2255c", "#6a4fb3",
                                            "#8c6d1f", "#0f8b8d", "#e0a100", "#5c677d", "#a03fa0"};
  ClassColors colors;
  for (const auto* graph : {&a, &b}) {
    for (const auto& node : graph->nodes()) colors[node.label];
  }
  std::size_t next = 0;
  for (auto& [label, color] : colors) color = palette[next++ % palette.size()];
  return colors;
}

/// The query whose accepted match has the best score; of equals the first.
std::optional<std::size_t> best_look_up(const RecognitionRun& run) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const auto score = [&](std::size_t k) { return run.records[k].recognition.accepted->score(); };
    if (run.records[i].recognition && (!best || score(i) > score(*best))) best = i;
  }
  return best;
}

/// "b in a: 3 objects agree, score 4.20"
std::string title_of(const RecognitionRun& run, const topobag::CandidateReport& report) {
  std::ostringstream out;
  out << name_of(run.query_set) << " in " << name_of(run.map_set) << ": ";
  if (report.pose) {
    out << report.pose->inliers.size() << " objects agree, score " << std::fixed
        << std::setprecision(2) << report.score();
  }
  if (report.pose && report.verdict != topobag::Verdict::accepted) out << ", ";
  if (report.verdict != topobag::Verdict::accepted) out << to_string(report.verdict);
  return out.str();
}

std::string pose_line(const topobag::RelativePose& pose,
                      const std::optional<topobag::PoseError>& error) {
  const Eigen::Isometry3d& T = pose.T_candidate_query;
  const Eigen::Vector3d t = T.translation();
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << "The query's camera in the map key frame's: x "
      << t.x() << ", y " << t.y() << ", z " << t.z() << " m, turned by " << std::setprecision(1)
      << topobag::rotation_angle_deg(T.linear()) << "°";
  if (error) {
    out << "; off the true pose by " << std::setprecision(2) << error->translation_m << " m, "
        << std::setprecision(1) << error->rotation_deg << "°";
  }
  return out.str();
}

void open_svg(std::ostream& out, double height) {
  out << std::fixed << std::setprecision(1) << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\""
      << width << "\" height=\"" << height << "\" viewBox=\"0 0 " << width << ' ' << height
      << "\" class=\"matched-graphs\">\n<style>\n"
      << ".matched-graphs { --ink: #1b2430; --paper: #ffffff; --image: #f5f7fa; --edge: #9aa7b5 }\n"
      << "@media screen and (prefers-color-scheme: dark) {\n"
      << "  .matched-graphs { --ink: #e6ebf0; --paper: #1a2129; --image: #27313b; --edge: #7b8a99 "
         "}\n"
      << "}\n"
      << ".matched-graphs text { font: 13px sans-serif; fill: var(--ink) }\n"
      << ".matched-graphs .title { font-size: 17px; font-weight: bold }\n"
      << ".matched-graphs .label { paint-order: stroke; stroke: var(--paper); stroke-width: 3px }\n"
      << ".matched-graphs .image { fill: var(--image); stroke: var(--edge); stroke-opacity: 0.6 }\n"
      << ".matched-graphs .object { fill-opacity: 0.12 }\n"
      << ".matched-graphs .edge { stroke: var(--edge); stroke-width: 1.2 }\n"
      << ".matched-graphs .match { fill: none; stroke-width: 2; stroke-opacity: 0.5 }\n"
      << "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"var(--paper)\"/>\n";
}

void draw_match(std::ostream& out, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                const std::string& color) {
  const double middle = (a.x() + b.x()) / 2;
  out << "<path d=\"M " << a.x() << ' ' << a.y() << " C " << middle << ' ' << a.y() << ' ' << middle
      << ' ' << b.y() << ' ' << b.x() << ' ' << b.y() << "\" class=\"match\" stroke=\"" << color
      << "\"/>\n";
}

void draw_missing(std::ostream& out, const Eigen::Vector2d& center) {
  out << "<rect x=\"" << center.x() - 11 << "\" y=\"" << center.y() - 11
      << "\" width=\"22\" height=\"22\" class=\"missing\" fill=\"none\" stroke=\"var(--ink)\" "
         "stroke-dasharray=\"4 3\"/>\n";
}

/// Without a view it is not known how the key frame's camera saw its objects.
void require_view(const std::string& set, const Keyframe& keyframe) {
  if (!keyframe.graph.views().empty()) return;
  throw InputError(set, "its graphs hold no views, which a drawing needs");
}

std::string pair_svg(const RecognitionRun& run, std::size_t index,
                     const topobag::CandidateReport& match,
                     const std::optional<topobag::PoseError>& error, bool with_missing) {
  std::ostringstream out;
  const Keyframe& candidate = run.map[topobag::value(match.id)];
  const Keyframe& query = run.queries[index];
  require_view(run.map_set, candidate);
  require_view(run.query_set, query);
  GraphPanel left(candidate.graph);
  GraphPanel right(query.graph);
  const Eigen::AlignedBox2d extent = left.extent().merged(right.extent());
  const double scale = panel_width / extent.sizes().x();
  const double right_side = 2 * margin + panel_width;
  left.place(extent, {margin, header}, scale);
  right.place(extent, {right_side, header}, scale);

  open_svg(out, header + scale * extent.sizes().y() + margin);
  draw_text(out, margin, 30, "title", title_of(run, match));
  const topobag::RelativePose pose = match.pose.value_or(topobag::RelativePose{});
  if (match.pose) draw_text(out, margin, 52, "pose", pose_line(pose, error));
  draw_text(out, margin, header - 8, "place", "map, " + name_of(candidate));
  draw_text(out, right_side, header - 8, "place", "query, " + name_of(query));

  std::set<topobag::NodeIndex> left_matched;
  std::set<topobag::NodeIndex> right_matched;
  for (const topobag::Correspondence& pair : pose.inliers) {
    left_matched.insert(pair.candidate);
    right_matched.insert(pair.query);
  }
  const ClassColors colors = colors_of(candidate.graph, query.graph);
  left.draw(out, left_matched, colors);
  right.draw(out, right_matched, colors);
  for (const topobag::Correspondence& pair : pose.inliers) {
    if (!left.shows(pair.candidate) || !right.shows(pair.query)) continue;
    draw_match(out, left.center(pair.candidate), right.center(pair.query),
               colors.at(query.graph.node(pair.query).label));
  }
  if (with_missing) {
    for (const topobag::MissingObject& missing : pose.missing) {
      const GraphPanel& panel = missing.of_candidate ? left : right;
      if (panel.shows(missing.node)) draw_missing(out, panel.center(missing.node));
    }
  }
  left.draw_labels(out, run.classes.catalog);
  right.draw_labels(out, run.classes.catalog);
  out << "</svg>\n";
  return out.str();
}

}  // namespace

std::string match_svg(const RecognitionRun& run) {
  if (const std::optional<std::size_t> best = best_look_up(run)) return match_svg(run, *best);
  std::ostringstream out;
  open_svg(out, header);
  draw_text(out, margin, 34, "title",
            name_of(run.query_set) + " in " + name_of(run.map_set) + ": no match");
  out << "</svg>\n";
  return out.str();
}

bool is_drawable(const RecognitionRun& run, std::size_t index) {
  const topobag::KeyframeId candidate = run.records[index].recognition.accepted->id;
  return !run.map[topobag::value(candidate)].graph.views().empty() &&
         !run.queries[index].graph.views().empty();
}

std::string match_svg(const RecognitionRun& run, std::size_t index) {
  const QueryRecord& record = run.records[index];
  return pair_svg(run, index, *record.recognition.accepted, record.error, false);
}

std::string candidate_svg(const RecognitionRun& run, std::size_t index,
                          const topobag::CandidateReport& candidate) {
  return pair_svg(run, index, candidate, std::nullopt, true);
}

}  // namespace program
