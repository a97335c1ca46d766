// SPDX-License-Identifier: MIT
#include "trajectory_figure.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <Eigen/Geometry>

#include "html_text.hpp"
#include "likely_up.hpp"

namespace program {
namespace {

/// The axes of the world that a view from above shows: to the right and up the page.
struct ViewFromAbove {
  Eigen::Index right = 0;
  Eigen::Index up = 1;
  std::string vertical;  ///< the axis that points at the viewer

  Eigen::Vector2d operator()(const topobag::StampedPose& pose) const {
    return {pose.T_world_body.translation()[right], pose.T_world_body.translation()[up]};
  }
};

const std::array<const char*, 3> axis_names{"x", "y", "z"};

/// From where the world is seen from above.
ViewFromAbove view_of(const KnownPlaces& places) {
  std::vector<Eigen::Isometry3d> poses;
  for (const auto* trajectory : {&places.queries, &places.map}) {
    for (const topobag::StampedPose& pose : *trajectory) poses.push_back(pose.T_world_body);
  }
  const Eigen::Vector3d up = likely_up(poses);
  Eigen::Index vertical = 0;
  up.cwiseAbs().maxCoeff(&vertical);
  const Eigen::Index next = (vertical + 1) % 3;
  const Eigen::Index last = (vertical + 2) % 3;
  const std::string name = axis_names[static_cast<std::size_t>(vertical)];
  if (up[vertical] > 0.0) return {next, last, name};
  return {last, next, "−" + name};
}

/// The plot's axes about all points, a metre as long to the right as up.
SvgPlot equal_plot(const Eigen::AlignedBox2d& points, const ViewFromAbove& view) {
  const double width = 1100.0;
  const double margin = 0.05 * points.sizes().maxCoeff() + 0.02;
  const Eigen::Vector2d needed = points.sizes().array() + 2.0 * margin;
  const double height = std::clamp(width * needed.y() / needed.x(), 400.0, 760.0);
  const Eigen::Vector2d inner(width - 80.0, height - 62.0);  // without the axes
  const double scale = needed.cwiseQuotient(inner).maxCoeff();
  const Eigen::Vector2d half = 0.5 * scale * inner;
  const Eigen::Vector2d middle = points.center();
  const auto axis = [&](Eigen::Index i, Eigen::Index of_world) {
    return round_axis(std::string(axis_names[static_cast<std::size_t>(of_world)]) + ", m",
                      middle[i] - half[i], middle[i] + half[i]);
  };
  return {axis(0, view.right), axis(1, view.up), width, height};
}

std::string hint_of(std::size_t query, const QueryOutcome& outcome) {
  std::string text = "query row " + std::to_string(query) + ": " + style_of(outcome.outcome).name;
  if (outcome.answer) {
    text += ", candidate row " + std::to_string(*outcome.answer) + ", score " +
            short_text(outcome.score);
  } else if (outcome.place) {
    text += ", nearest true place: candidate row " + std::to_string(outcome.place->candidate);
  }
  return text;
}

}  // namespace

Figure trajectory_figure(const KnownPlaces& places, const std::vector<QueryOutcome>& outcomes,
                         bool one_trajectory) {
  Figure figure{"trajectory", "The trajectory from above", "", ""};
  figure.wide = true;
  const ViewFromAbove view = view_of(places);
  Eigen::AlignedBox2d box;
  std::vector<Eigen::Vector2d> queries;
  std::vector<Eigen::Vector2d> map;
  for (const auto& pose : places.queries) box.extend(queries.emplace_back(view(pose)));
  for (const auto& pose : places.map) box.extend(map.emplace_back(view(pose)));
  SvgPlot plot = equal_plot(box, view);
  if (!one_trajectory) {
    plot.line(map, "path map");
    plot.explain_line("path map", "map");
  }
  plot.line(queries, "path query");
  plot.explain_line("path query", one_trajectory ? "trajectory" : "queries");

  std::array<std::size_t, all_outcomes.size()> counts{};
  figure.table.columns = {"query",  "x",     "y",          "z",          "outcome",
                          "answer", "score", "true_place", "distance_m", "angle_deg"};
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const QueryOutcome& query = outcomes[i];
    ++counts[static_cast<std::size_t>(query.outcome)];
    const Eigen::Vector3d at = places.queries[i].T_world_body.translation();
    Json row = Json::array({i, at.x(), at.y(), at.z(), style_of(query.outcome).name,
                            or_null(query.answer), query.answer ? Json(query.score) : Json()});
    for (const Json& value : query.place
                                 ? Json::array({query.place->candidate, query.place->distance_m,
                                                query.place->angle_deg})
                                 : Json::array({nullptr, nullptr, nullptr})) {
      row.push_back(value);
    }
    figure.table.rows.push_back(std::move(row));
    if (query.answer) {
      plot.line({queries[i], map[*query.answer]},
                std::string("loop ") + style_of(query.outcome).style, hint_of(i, query));
    }
  }
  // What went wrong on top of what went right.
  for (const Outcome outcome :
       {Outcome::missed, Outcome::unscored, Outcome::correct, Outcome::imprecise, Outcome::wrong}) {
    const OutcomeStyle style = style_of(outcome);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (outcomes[i].outcome == outcome) {
        plot.mark(queries[i], style.marker, style.style, hint_of(i, outcomes[i]));
      }
    }
  }
  for (const Outcome outcome : all_outcomes) {
    const std::size_t count = counts[static_cast<std::size_t>(outcome)];
    if (count == 0) continue;
    const OutcomeStyle style = style_of(outcome);
    if (outcome != Outcome::nothing) {
      plot.explain_mark(style.marker, style.style, std::to_string(count) + ' ' + style.name);
    }
    figure.caption +=
        (figure.caption.empty() ? "Queries: " : ", ") + std::to_string(count) + ' ' + style.name;
  }
  figure.caption += ". Each accepted answer is joined to the key frame that it names. World axis " +
                    view.vertical +
                    " points at the reader: the one that the images' up is nearest to.";
  figure.drawing = plot.svg(figure.title + ". " + figure.caption);
  return figure;
}

}  // namespace program
