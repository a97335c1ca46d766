// SPDX-License-Identifier: MIT
#include "html_page.hpp"

#include <sstream>

#include "html_text.hpp"

namespace program {
namespace {

void write_data(std::ostream& out, const char* id, const Json& json) {
  out << "<script type=\"application/json\" id=\"" << id << "\">" << script_text(json_text(json))
      << "</script>\n";
}

void write_figure(std::ostream& out, const Figure& figure, std::size_t number) {
  out << "<figure id=\"" << figure.id << '"' << (figure.wide ? " class=\"wide\"" : "") << ">\n<h2>"
      << number << ". " << escaped(figure.title) << "</h2>\n"
      << figure.drawing << "<figcaption>" << escaped(figure.caption) << "</figcaption>\n";
  if (!figure.table.rows.empty()) {
    out << "<details data-table=\"" << figure.id << "\"><summary>Numbers</summary></details>\n"
        << "<a class=\"download\" data-table=\"" << figure.id << "\" download=\"" << figure.id
        << ".csv\" href=\"#" << figure.id << "\">CSV</a>\n";
  }
  out << "</figure>\n";
}

}  // namespace

Json report_json(const Report& report) {
  Json json;
  json["title"] = report.title;
  for (const auto& [name, value] : report.facts) json["facts"][name] = value;
  json["notes"] = report.notes;
  for (const Figure& figure : report.figures) json["figures"][figure.id] = to_json(figure.table);
  return versioned(json);
}

std::string html_page(const Report& report) {
  std::ostringstream out;
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      << "<meta name=\"color-scheme\" content=\"light dark\">\n"
      << "<link rel=\"icon\" href=\"data:,\">\n<title>" << escaped(report.title)
      << "</title>\n<style>" << page_style << "</style>\n</head>\n<body>\n<header>\n<h1>"
      << escaped(report.title) << "</h1>\n<dl>\n";
  for (const auto& [name, value] : report.facts) {
    const bool is_long = value.size() > 60;
    out << "<div" << (is_long ? " class=\"long\"" : "") << "><dt>" << escaped(name) << "</dt><dd>"
        << escaped(value) << "</dd></div>\n";
  }
  out << "</dl>\n";
  for (const std::string& note : report.notes) {
    out << "<p class=\"note\">" << escaped(note) << "</p>\n";
  }
  out << "<p><a class=\"download\" download=\"report.json\" href=\"#\">All numbers as "
         "JSON</a></p>\n"
      << "</header>\n<main>\n";
  std::size_t number = 0;
  for (const Figure& figure : report.figures) write_figure(out, figure, ++number);
  out << "</main>\n";
  Json drawn = Json::object();
  for (const Figure& figure : report.figures) {
    if (!figure.drawn.is_null()) drawn[figure.id] = figure.drawn;
  }
  write_data(out, "report-data", report_json(report));
  write_data(out, "drawn-data", drawn);
  out << "<script>" << page_script << "</script>\n</body>\n</html>\n";
  return out.str();
}

}  // namespace program
