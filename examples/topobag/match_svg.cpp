// SPDX-License-Identifier: MIT
#include "match_svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

#include <Eigen/Geometry>

#include <topobag/types/class_catalog.hpp>

namespace program {
namespace {

using Box = Eigen::AlignedBox2d;
using Colors = std::map<topobag::ClassId, std::string>;

const double panel_width = 560.0;  // px of the drawing
const double margin = 24.0;
const double header = 84.0;
const double font_size = 13.0;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

/// One graph in its key frame's image plane, placed on the drawing.
class Panel {
 public:
  /// @param keyframe  its graph holds at least one view
  /// @param left,top  px of the drawing
  Panel(const Keyframe& keyframe, double left, double top)
      : graph_(keyframe.graph), image_(image_of(graph_)) {
    // Objects that a moving camera has left behind lie outside the image; far ones are not drawn.
    const Eigen::Vector2d beyond = 0.4 * image_.sizes();
    const Box drawn(image_.min() - beyond, image_.max() + beyond);
    extent_ = image_;
    for (std::size_t i = 0; i < graph_.size(); ++i) {
      const auto& pixel = graph_.nodes()[i].pixel;
      if (!pixel || !drawn.contains(*pixel)) continue;
      shown_.insert(i);
      extent_.extend(*pixel);
    }
    scale_ = panel_width / extent_.sizes().x();
    origin_ = Eigen::Vector2d(left, top);
  }

  double height() const { return scale_ * extent_.sizes().y(); }
  bool shows(std::size_t i) const { return shown_.count(i) != 0; }

  /// Where a node's centre is drawn. Precondition: it is shown.
  Eigen::Vector2d place(std::size_t i) const { return on_drawing(*graph_.nodes()[i].pixel); }

  void draw(std::ostream& out, const std::set<std::size_t>& matched, const Colors& colors) const {
    draw_image(out);
    draw_edges(out);
    for (const std::size_t i : shown_) draw_node(out, i, matched.count(i) != 0, colors);
  }

  void draw_labels(std::ostream& out, const topobag::ClassCatalog& catalog) const {
    std::vector<Box> taken;
    for (const std::size_t i : shown_) {
      const Eigen::Vector2d at = place(i);
      taken.emplace_back(at.array() - 6.0, at.array() + 6.0);
    }
    for (const std::size_t i : shown_) {
      const std::string& name = catalog.name(graph_.nodes()[i].label);
      const Box label = free_place(place(i), name, taken);
      taken.push_back(label);
      out << "<text x=\"" << label.min().x() << "\" y=\"" << label.max().y() - 4.0
          << "\" class=\"label\">" << escaped(name) << "</text>\n";
    }
  }

 private:
  static Box image_of(const topobag::TopologyGraph<>& graph) {
    const auto& camera = graph.views().back().camera;
    return {Eigen::Vector2d(-0.5, -0.5), Eigen::Vector2d(camera.width - 0.5, camera.height - 0.5)};
  }

  Eigen::Vector2d on_drawing(const Eigen::Vector2d& pixel) const {
    return origin_ + scale_ * (pixel - extent_.min());
  }

  void draw_image(std::ostream& out) const {
    const Eigen::Vector2d corner = on_drawing(image_.min());
    const Eigen::Vector2d size = scale_ * image_.sizes();
    out << "<rect x=\"" << corner.x() << "\" y=\"" << corner.y() << "\" width=\"" << size.x()
        << "\" height=\"" << size.y() << "\" rx=\"4\" class=\"image\"/>\n";
  }

  void draw_edges(std::ostream& out) const {
    for (const topobag::Edge& edge : graph_.edges()) {
      if (!shows(value(edge.a)) || !shows(value(edge.b))) continue;
      const Eigen::Vector2d a = place(value(edge.a));
      const Eigen::Vector2d b = place(value(edge.b));
      out << "<line x1=\"" << a.x() << "\" y1=\"" << a.y() << "\" x2=\"" << b.x() << "\" y2=\""
          << b.y() << "\" class=\"edge\"/>\n";
    }
  }

  void draw_node(std::ostream& out, std::size_t i, bool matched, const Colors& colors) const {
    const Eigen::Vector2d at = place(i);
    const std::string& color = colors.at(graph_.nodes()[i].label);
    out << "<circle cx=\"" << at.x() << "\" cy=\"" << at.y() << "\" r=\"" << (matched ? 7.0 : 5.0)
        << "\" fill=\"" << (matched ? color : "#ffffff") << "\" stroke=\"" << color
        << "\" stroke-width=\"2\"/>\n";
  }

  /// Beside, above or below the node, where nothing is yet; else beside it all the same.
  static Box free_place(const Eigen::Vector2d& node, const std::string& name,
                        const std::vector<Box>& taken) {
    const Eigen::Vector2d size(0.56 * font_size * static_cast<double>(name.size()), font_size + 3);
    const double gap = 10.0;
    const std::array<Eigen::Vector2d, 4> corners{
        Eigen::Vector2d(gap, -size.y() / 2), Eigen::Vector2d(-gap - size.x(), -size.y() / 2),
        Eigen::Vector2d(-size.x() / 2, -gap - size.y()), Eigen::Vector2d(-size.x() / 2, gap)};
    for (const Eigen::Vector2d& corner : corners) {
      const Box box(node + corner, node + corner + size);
      const bool free = std::none_of(taken.begin(), taken.end(),
                                     [&](const Box& other) { return other.intersects(box); });
      if (free) return box;
    }
    return {node + corners[0], node + corners[0] + size};
  }

  const topobag::TopologyGraph<>& graph_;
  Box image_;   // px of the image
  Box extent_;  // px of the image, with the objects beyond it
  std::set<std::size_t> shown_;
  double scale_ = 1.0;  // px of the drawing per px of the image
  Eigen::Vector2d origin_;
};

/// A color for each class, in the order of the class numbers.
Colors colors_of(const topobag::TopologyGraph<>& a, const topobag::TopologyGraph<>& b) {
  const std::array<const char*, 10> palette{"#1f6fb4", "#d95f02", "#2a9d5c", "#c2255c", "#6a4fb3",
                                            "#8c6d1f", "#0f8b8d", "#e0a100", "#5c677d", "#a03fa0"};
  Colors colors;
  for (const auto* graph : {&a, &b}) {
    for (const auto& node : graph->nodes()) colors[node.label];
  }
  std::size_t next = 0;
  for (auto& [label, color] : colors) color = palette[next++ % palette.size()];
  return colors;
}

/// The look-up whose accepted match has the best score; of equals the first.
std::optional<std::size_t> best_look_up(const RecognitionRun& run) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < run.look_ups.size(); ++i) {
    const auto score = [&](std::size_t k) {
      return run.look_ups[k].recognition.accepted->pose->score();
    };
    if (run.look_ups[i].recognition && (!best || score(i) > score(*best))) best = i;
  }
  return best;
}

/// "3 objects agree; camera moved by …, off by …"
std::string pose_line(const LookUp& look_up) {
  const topobag::CandidateReport& match = *look_up.recognition.accepted;
  const Eigen::Isometry3d& pose = match.pose->T_candidate_query;
  const Eigen::Vector3d t = pose.translation();
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << match.pose->inliers.size()
      << " objects agree, score " << match.pose->score() << ". The query's camera in the map's: x "
      << t.x() << ", y " << t.y() << ", z " << t.z() << " m, turned by " << std::setprecision(1)
      << topobag::rotation_angle_deg(pose.linear()) << "°";
  if (look_up.error) {
    out << "; off the truth by " << std::setprecision(2) << look_up.error->translation_m << " m, "
        << std::setprecision(1) << look_up.error->rotation_deg << "°";
  }
  return out.str();
}

void open_svg(std::ostream& out, double width, double height) {
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
      << "\" viewBox=\"0 0 " << width << ' ' << height << "\">\n"
      << "<style>\n"
      << "text { font: " << font_size << "px sans-serif; fill: #1b2430 }\n"
      << ".title { font-size: 17px; font-weight: bold }\n"
      << ".label { paint-order: stroke; stroke: #ffffff; stroke-width: 3px }\n"
      << ".image { fill: #f5f7fa; stroke: #c3ccd6 }\n"
      << ".edge { stroke: #9aa7b5; stroke-width: 1.2 }\n"
      << ".match { fill: none; stroke-width: 2; stroke-opacity: 0.45 }\n"
      << "</style>\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

void draw_text(std::ostream& out, double x, double y, const char* style, const std::string& text) {
  out << "<text x=\"" << x << "\" y=\"" << y << "\" class=\"" << style << "\">" << escaped(text)
      << "</text>\n";
}

}  // namespace

std::string match_svg(const RecognitionRun& run) {
  const double width = 2 * panel_width + 3 * margin;
  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  const std::optional<std::size_t> best = best_look_up(run);
  if (!best) {
    open_svg(out, width, header);
    draw_text(out, margin, 34, "title", run.query_set + " in " + run.map_set + ": no match");
    out << "</svg>\n";
    return out.str();
  }

  const LookUp& look_up = run.look_ups[*best];
  const topobag::CandidateReport& match = *look_up.recognition.accepted;
  const Keyframe& candidate = run.map[topobag::value(match.id)];
  const Keyframe& query = run.queries[*best];
  const Panel left(candidate, margin, header);
  const Panel right(query, 2 * margin + panel_width, header);
  const Colors colors = colors_of(candidate.graph, query.graph);

  open_svg(out, width, header + std::max(left.height(), right.height()) + margin);
  draw_text(out, margin, 30, "title", pose_line(look_up));
  draw_text(out, margin, header - 14, "place",
            "map: " + run.map_set + ", frame " + std::to_string(candidate.idx));
  draw_text(out, 2 * margin + panel_width, header - 14, "place",
            "query: " + run.query_set + ", frame " + std::to_string(query.idx));

  std::set<std::size_t> left_matched;
  std::set<std::size_t> right_matched;
  for (const topobag::Correspondence& pair : match.pose->inliers) {
    left_matched.insert(value(pair.candidate));
    right_matched.insert(value(pair.query));
  }
  left.draw(out, left_matched, colors);
  right.draw(out, right_matched, colors);
  for (const topobag::Correspondence& pair : match.pose->inliers) {
    if (!left.shows(value(pair.candidate)) || !right.shows(value(pair.query))) continue;
    const Eigen::Vector2d a = left.place(value(pair.candidate));
    const Eigen::Vector2d b = right.place(value(pair.query));
    const double middle = (a.x() + b.x()) / 2;
    out << "<path d=\"M " << a.x() << ' ' << a.y() << " C " << middle << ' ' << a.y() << ' '
        << middle << ' ' << b.y() << ' ' << b.x() << ' ' << b.y() << "\" class=\"match\" stroke=\""
        << colors.at(query.graph.node(pair.query).label) << "\"/>\n";
  }
  left.draw_labels(out, topobag::ClassCatalog::coco80());
  right.draw_labels(out, topobag::ClassCatalog::coco80());
  out << "</svg>\n";
  return out.str();
}

}  // namespace program
