// SPDX-License-Identifier: MIT
#include "report/html_page.hpp"

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "examples/report/page_text.hpp"
#include "report/svg_plot.hpp"

using program::Figure;
using program::Json;
using program::Report;

namespace {

Report report_of(std::size_t figures) {
  Report report{"<b>A & B</b>", {{"Map", "a<b>"}}, {"\"note\" </p>"}, {}};
  for (std::size_t i = 0; i < figures; ++i) {
    Figure figure{"f" + std::to_string(i), "T<i>", "C</figcaption>", "<svg></svg>"};
    figure.table = {{"name", "value"}, {Json::array({"</script><script>x()", 0.5})}};
    report.figures.push_back(figure);
  }
  return report;
}

}  // namespace

TEST_CASE("a page holds its figures, and no text of theirs becomes markup", "[examples][report]") {
  for (const std::size_t figures : {0U, 1U, 7U}) {
    const std::string page = program::html_page(report_of(figures));
    CHECK(times(page, "<figure ") == figures);
    CHECK(times(page, "</figcaption>") == figures);
    CHECK(times(page, "<script") == 3);
    CHECK(times(page, "</script>") == 3);
    CHECK(times(page, "<b>") == 0);
    CHECK(times(page, "<i>") == 0);
    CHECK(references(page).empty());
  }
}

TEST_CASE("a page's data is the report's, whatever the texts hold", "[examples][report]") {
  const Report report = report_of(2);
  const std::string page = program::html_page(report);
  const std::string start = "id=\"report-data\">";
  const std::size_t from = page.find(start) + start.size();
  const Json read = Json::parse(page.substr(from, page.find("</script>", from) - from));
  CHECK(read == program::report_json(report));
  CHECK(read.at("figures").at("f1").at("rows").at(0).at(0) == "</script><script>x()");
}

TEST_CASE("text that is no UTF-8 does not stop a page", "[examples][report]") {
  Report report = report_of(1);
  report.title = "a\xff";
  CHECK(times(program::html_page(report), "<figure ") == 1);
}

TEST_CASE("a table's CSV quotes what it must", "[examples][report]") {
  const program::DataTable table{{"a", "b"},
                                 {Json::array({"x,y", 1}), Json::array({"say \"z\"", nullptr})}};
  CHECK(program::to_csv(table) == "a,b\n\"x,y\",1\n\"say \"\"z\"\"\",\n");
}

TEST_CASE("a plot puts the axes' ends on its edges and explains its marks", "[examples][report]") {
  program::SvgPlot plot(program::round_axis("x <m>", 0.0, 2.0), program::round_axis("y", -1.0, 1.0),
                        400.0, 300.0);
  const Eigen::Vector2d low = plot.place({0.0, -1.0});
  const Eigen::Vector2d high = plot.place({2.0, 1.0});
  CHECK(low.x() < high.x());
  CHECK(low.y() > high.y());
  CHECK(plot.place({1.0, 0.0}).isApprox((low + high) / 2.0));
  CHECK(low.x() > 0.0);
  CHECK(high.x() < 400.0);
  plot.line({{0.0, 0.0}, {1.0, 1.0}}, "first", "a \"hint\"");
  plot.line({}, "second");
  plot.mark({1.0, 0.0}, program::Marker::cross, "wrong");
  plot.explain_line("first", "A & B");
  const std::string svg = plot.svg("all");
  CHECK(times(svg, "<polyline") == 1);
  CHECK(times(svg, "<title>a &quot;hint&quot;</title>") == 1);
  CHECK(times(svg, "A &amp; B") == 1);
  CHECK(times(svg, "x &lt;m&gt;") == 1);
  CHECK(times(svg, "nan") == 0);
}
