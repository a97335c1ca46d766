// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/types/class_catalog.hpp>

namespace program {

using ClassColors = std::map<topobag::ClassId, std::string>;

/// Writes an SVG text element of the class `style`.
void draw_text(std::ostream& out, double x, double y, const char* style, const std::string& text);

/// One graph in its key frame's image plane, to be placed on an SVG drawing.
///
/// Elements get the style classes image, object, edge and label.
class GraphPanel {
 public:
  /// @param graph  holds at least one view, outlives the panel
  explicit GraphPanel(const topobag::TopologyGraph<>& graph);

  /// The part of the image plane that holds the image and the nodes, px of the image.
  const Eigen::AlignedBox2d& extent() const { return extent_; }

  /// Shows `extent` from `corner` on, `scale` px of the drawing for one of the image.
  void place(const Eigen::AlignedBox2d& extent, const Eigen::Vector2d& corner, double scale);

  /// False for a node behind the camera or far outside the image.
  bool shows(topobag::NodeIndex node) const { return shown_.count(node) != 0; }

  /// Where a node's centre is drawn. Precondition: it is shown.
  Eigen::Vector2d center(topobag::NodeIndex node) const;

  /// The image, the objects, the edges and the nodes, of which the matched ones are filled.
  void draw(std::ostream& out, const std::set<topobag::NodeIndex>& matched,
            const ClassColors& colors) const;

  /// The nodes' classes, beside them where there is room.
  void draw_labels(std::ostream& out, const topobag::ClassCatalog& catalog) const;

 private:
  Eigen::Vector2d on_drawing(const Eigen::Vector2d& pixel) const {
    return corner_ + scale_ * (pixel - extent_.min());
  }
  void draw_object(std::ostream& out, topobag::NodeIndex node, const ClassColors& colors) const;
  void draw_edge(std::ostream& out, const topobag::Edge& edge) const;
  void draw_node(std::ostream& out, topobag::NodeIndex node, bool matched,
                 const ClassColors& colors) const;
  Eigen::AlignedBox2d free_place(const Eigen::Vector2d& node, const std::string& name,
                                 const std::vector<Eigen::AlignedBox2d>& taken) const;

  const topobag::TopologyGraph<>& graph_;
  topobag::PinholeCamera<> camera_;
  Eigen::AlignedBox2d image_;
  Eigen::AlignedBox2d extent_;
  std::set<topobag::NodeIndex> shown_;
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();
  double scale_ = 1.0;
};

}  // namespace program
