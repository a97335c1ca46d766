// SPDX-License-Identifier: MIT
#include "graph_panel.hpp"

#include <algorithm>
#include <array>

#include "input_error.hpp"
#include "report/html_text.hpp"

namespace program {
namespace {

using Box = Eigen::AlignedBox2d;
using topobag::NodeIndex;

void draw_rectangle(std::ostream& out, const Box& box, const std::string& style) {
  out << "<rect x=\"" << box.min().x() << "\" y=\"" << box.min().y() << "\" width=\""
      << box.sizes().x() << "\" height=\"" << box.sizes().y() << "\" rx=\"4\" " << style << "/>\n";
}

}  // namespace

void draw_text(std::ostream& out, double x, double y, const char* style, const std::string& text) {
  out << "<text x=\"" << x << "\" y=\"" << y << "\" class=\"" << style << "\">" << escaped(text)
      << "</text>\n";
}

GraphPanel::GraphPanel(const topobag::TopologyGraph<>& graph)
    : graph_(graph),
      camera_(graph.views().back().camera),
      image_(Eigen::Vector2d(-0.5, -0.5),
             Eigen::Vector2d(camera_.width - 0.5, camera_.height - 0.5)),
      extent_(image_) {
  if (camera_.width == 0) {
    throw InputError("--clusters", "there is no image to draw in: leave --svg and --report out");
  }
  // Objects that a moving camera has left behind lie outside the image; far ones are not drawn.
  const Eigen::Vector2d beyond = 0.4 * image_.sizes();
  const Box drawn(image_.min() - beyond, image_.max() + beyond);
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    const auto& pixel = graph_.nodes()[i].pixel;
    if (!pixel || !drawn.contains(*pixel)) continue;
    shown_.insert(topobag::node_index(i));
    const double room = 30.0;  // px of the image, for the node's circle
    extent_.extend(Eigen::Vector2d(pixel->array() - room));
    extent_.extend(Eigen::Vector2d(pixel->array() + room));
  }
}

void GraphPanel::place(const Box& extent, const Eigen::Vector2d& corner, double scale) {
  extent_ = extent;
  corner_ = corner;
  scale_ = scale;
}

Eigen::Vector2d GraphPanel::center(NodeIndex node) const {
  return on_drawing(*graph_.node(node).pixel);
}

void GraphPanel::draw(std::ostream& out, const std::set<NodeIndex>& matched,
                      const ClassColors& colors) const {
  draw_rectangle(out, {on_drawing(image_.min()), on_drawing(image_.max())}, "class=\"image\"");
  for (const NodeIndex node : shown_) draw_object(out, node, colors);
  for (const topobag::Edge& edge : graph_.edges()) draw_edge(out, edge);
  for (const NodeIndex node : shown_) draw_node(out, node, matched.count(node) != 0, colors);
}

void GraphPanel::draw_labels(std::ostream& out, const topobag::ClassCatalog& catalog) const {
  std::vector<Box> taken;
  for (const NodeIndex node : shown_) {
    taken.emplace_back(center(node).array() - 6.0, center(node).array() + 6.0);
  }
  for (const NodeIndex node : shown_) {
    const std::string& name = catalog.name(graph_.node(node).label);
    const Box label = free_place(center(node), name, taken);
    taken.push_back(label);
    draw_text(out, label.min().x(), label.max().y() - 4.0, "label", name);
  }
}

/// The object's size about its centre.
void GraphPanel::draw_object(std::ostream& out, NodeIndex index, const ClassColors& colors) const {
  const auto& node = graph_.node(index);
  if (!(node.z > 0.0)) return;
  const Eigen::Vector2d size(node.size.x() * camera_.fx, node.size.y() * camera_.fy);
  const Eigen::Vector2d half = size / (2.0 * node.z);
  const Box shown = Box(*node.pixel - half, *node.pixel + half).intersection(extent_);
  draw_rectangle(out, {on_drawing(shown.min()), on_drawing(shown.max())},
                 "class=\"object\" fill=\"" + colors.at(node.label) + '"');
}

void GraphPanel::draw_edge(std::ostream& out, const topobag::Edge& edge) const {
  if (!shows(edge.a) || !shows(edge.b)) return;
  out << "<line x1=\"" << center(edge.a).x() << "\" y1=\"" << center(edge.a).y() << "\" x2=\""
      << center(edge.b).x() << "\" y2=\"" << center(edge.b).y() << "\" class=\"edge\"/>\n";
}

void GraphPanel::draw_node(std::ostream& out, NodeIndex node, bool matched,
                           const ClassColors& colors) const {
  const std::string& color = colors.at(graph_.node(node).label);
  out << "<circle cx=\"" << center(node).x() << "\" cy=\"" << center(node).y() << "\" r=\""
      << (matched ? 7.0 : 5.0) << "\" fill=\"" << (matched ? color : "var(--paper)")
      << "\" stroke=\"" << color << "\" stroke-width=\"2\"/>\n";
}

/// Beside, above or below the node, inside the panel and where nothing is yet; else beside it.
Box GraphPanel::free_place(const Eigen::Vector2d& node, const std::string& name,
                           const std::vector<Box>& taken) const {
  const Box bounds(on_drawing(extent_.min()), on_drawing(extent_.max()));
  const Eigen::Vector2d size(7.3 * static_cast<double>(name.size()), 16.0);
  const double gap = 10.0;
  const std::array<Eigen::Vector2d, 4> corners{
      Eigen::Vector2d(gap, -size.y() / 2), Eigen::Vector2d(-gap - size.x(), -size.y() / 2),
      Eigen::Vector2d(-size.x() / 2, -gap - size.y()), Eigen::Vector2d(-size.x() / 2, gap)};
  for (const Eigen::Vector2d& corner : corners) {
    const Box box(node + corner, node + corner + size);
    const bool hidden = std::any_of(taken.begin(), taken.end(),
                                    [&](const Box& other) { return other.intersects(box); });
    if (!hidden && bounds.contains(box)) return box;
  }
  return {node + corners[0], node + corners[0] + size};
}

}  // namespace program
