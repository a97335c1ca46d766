// SPDX-License-Identifier: MIT
#include "svg_plot.hpp"

#include <algorithm>
#include <iomanip>

#include "html_text.hpp"

namespace program {
namespace {

// px around the plot
const double left = 62.0;
const double right = 18.0;
const double above = 12.0;
const double below = 50.0;
const double row_height = 20.0;  // px of a legend's row

/// Ends an element of the name `tag`, with its hint.
std::string end_of(const char* tag, const std::string& hint) {
  return hint.empty() ? "/>\n" : "><title>" + escaped(hint) + "</title></" + tag + ">\n";
}

std::string symbol_at(const Eigen::Vector2d& at, Marker marker, const std::string& style,
                      const std::string& hint) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  const double x = at.x();
  const double y = at.y();
  switch (marker) {
    case Marker::dot:
    case Marker::ring:
      out << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"4\" class=\""
          << (marker == Marker::dot ? "dot " : "ring ") << style << '"' << end_of("circle", hint);
      break;
    case Marker::triangle:
      out << "<path d=\"M" << x - 4.6 << ' ' << y + 3.6 << 'H' << x + 4.6 << 'L' << x << ' '
          << y - 4.6 << "Z\" class=\"dot " << style << '"' << end_of("path", hint);
      break;
    case Marker::cross:
      out << "<path d=\"M" << x - 4 << ' ' << y - 4 << 'L' << x + 4 << ' ' << y + 4 << 'M' << x - 4
          << ' ' << y + 4 << 'L' << x + 4 << ' ' << y - 4 << "\" class=\"cross " << style << '"'
          << end_of("path", hint);
      break;
  }
  return out.str();
}

/// About how wide a text of 12 px is, px.
double text_width(const std::string& text) {
  const auto starts_character = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  };
  return 6.8 * static_cast<double>(std::count_if(text.begin(), text.end(), starts_character));
}

}  // namespace

SvgPlot::SvgPlot(PlotAxis x, PlotAxis y, double width, double height)
    : x_(std::move(x)), y_(std::move(y)), width_(width), height_(height) {
  marks_ << std::fixed << std::setprecision(1);
}

Eigen::Vector2d SvgPlot::place(const Eigen::Vector2d& point) const {
  const double x = (point.x() - x_.low) / (x_.high - x_.low);
  const double y = (point.y() - y_.low) / (y_.high - y_.low);
  return {left + x * (width_ - left - right), height_ - below - y * (height_ - above - below)};
}

void SvgPlot::line(const std::vector<Eigen::Vector2d>& points, const std::string& style,
                   const std::string& hint) {
  if (points.empty()) return;
  marks_ << "<polyline class=\"line " << style << "\" points=\"";
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d at = place(point);
    marks_ << at.x() << ',' << at.y() << ' ';
  }
  marks_ << '"' << end_of("polyline", hint);
}

void SvgPlot::bar(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const std::string& style,
                  const std::string& hint) {
  const Eigen::Vector2d a = place(low);
  const Eigen::Vector2d b = place(high);
  marks_ << "<rect x=\"" << a.x() << "\" y=\"" << b.y() << "\" width=\""
         << std::max(0.0, b.x() - a.x()) << "\" height=\"" << std::max(0.0, a.y() - b.y())
         << "\" class=\"bar " << style << '"' << end_of("rect", hint);
}

void SvgPlot::mark(const Eigen::Vector2d& point, Marker marker, const std::string& style,
                   const std::string& hint) {
  marks_ << symbol_at(place(point), marker, style, hint);
}

void SvgPlot::explain(std::string symbol, const std::string& text) {
  legend_.emplace_back(std::move(symbol), text);
}

void SvgPlot::explain_line(const std::string& style, const std::string& text) {
  explain("<line x1=\"-9\" x2=\"9\" class=\"line " + style + "\"/>", text);
}

void SvgPlot::explain_bar(const std::string& style, const std::string& text) {
  explain("<rect x=\"-6\" y=\"-6\" width=\"12\" height=\"12\" class=\"bar " + style + "\"/>", text);
}

void SvgPlot::explain_mark(Marker marker, const std::string& style, const std::string& text) {
  explain(symbol_at({0.0, 0.0}, marker, style, ""), text);
}

void SvgPlot::write_axes(std::ostream& out) const {
  const double bottom = height_ - below;
  for (const Tick& tick : y_.ticks) {
    const double y = place({x_.low, tick.value}).y();
    out << "<line class=\"grid\" x1=\"" << left << "\" x2=\"" << width_ - right << "\" y1=\"" << y
        << "\" y2=\"" << y << "\"/><text x=\"" << left - 8 << "\" y=\"" << y + 4
        << "\" text-anchor=\"end\">" << escaped(tick.text) << "</text>\n";
  }
  for (const Tick& tick : x_.ticks) {
    const double x = place({tick.value, y_.low}).x();
    out << "<line class=\"axis\" x1=\"" << x << "\" x2=\"" << x << "\" y1=\"" << bottom
        << "\" y2=\"" << bottom + 5 << "\"/><text x=\"" << x << "\" y=\"" << bottom + 19
        << "\" text-anchor=\"middle\">" << escaped(tick.text) << "</text>\n";
  }
  out << "<line class=\"axis\" x1=\"" << left << "\" x2=\"" << width_ - right << "\" y1=\""
      << bottom << "\" y2=\"" << bottom << "\"/>\n<text class=\"label\" x=\""
      << (left + width_ - right) / 2 << "\" y=\"" << height_ - 10 << "\" text-anchor=\"middle\">"
      << escaped(x_.label)
      << "</text>\n<text class=\"label\" text-anchor=\"middle\" transform=\"translate(15 "
      << (above + bottom) / 2 << ") rotate(-90)\">" << escaped(y_.label) << "</text>\n";
}

std::string SvgPlot::legend(double& height) const {
  std::ostringstream out;
  double x = left;
  height = legend_.empty() ? 0.0 : row_height;
  for (const auto& [symbol, text] : legend_) {
    const double width = 30.0 + text_width(text);
    if (x > left && x + width > width_) {
      x = left;
      height += row_height;
    }
    out << "<g transform=\"translate(" << x + 10 << ' ' << height - row_height / 2 << ")\">"
        << symbol << "<text x=\"14\" y=\"4\">" << escaped(text) << "</text></g>\n";
    x += width + 10.0;
  }
  return out.str();
}

std::string SvgPlot::svg(const std::string& description) const {
  double legend_height = 0.0;
  const std::string explained = legend(legend_height);
  std::ostringstream out;
  out << std::fixed << std::setprecision(1) << "<svg class=\"plot\" role=\"img\" aria-label=\""
      << escaped(description) << "\" viewBox=\"0 0 " << width_ << ' ' << height_ + legend_height
      << "\">\n"
      << explained << "<g transform=\"translate(0 " << legend_height << ")\">\n";
  write_axes(out);
  out << marks_.str() << "</g></svg>\n";
  return out.str();
}

}  // namespace program
