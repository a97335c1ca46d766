// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "plot_axis.hpp"

namespace program {

enum class Marker { dot, ring, triangle, cross };

/// A plot as inline SVG. Colors come from the page: each element has a style class.
class SvgPlot {
 public:
  /// @param width,height  px, of the drawing without the legend
  SvgPlot(PlotAxis x, PlotAxis y, double width = 520.0, double height = 330.0);

  /// A point of the plot on the drawing, px.
  Eigen::Vector2d place(const Eigen::Vector2d& point) const;

  // `hint` is what the page shows when the pointer rests on the element; plain text.
  void line(const std::vector<Eigen::Vector2d>& points, const std::string& style,
            const std::string& hint = "");
  void bar(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const std::string& style,
           const std::string& hint = "");
  void mark(const Eigen::Vector2d& point, Marker marker, const std::string& style,
            const std::string& hint = "");

  /// Entries of the legend, in the order of the calls.
  void explain_line(const std::string& style, const std::string& text);
  void explain_bar(const std::string& style, const std::string& text);
  void explain_mark(Marker marker, const std::string& style, const std::string& text);

  /// @param description  for readers who do not see the drawing; plain text
  std::string svg(const std::string& description) const;

 private:
  void explain(std::string symbol, const std::string& text);
  void write_axes(std::ostream& out) const;
  std::string legend(double& height) const;

  PlotAxis x_;
  PlotAxis y_;
  double width_;
  double height_;
  std::ostringstream marks_;
  std::vector<std::pair<std::string, std::string>> legend_;  ///< symbol about (0, 0), text
};

}  // namespace program
