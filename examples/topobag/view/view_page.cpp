// SPDX-License-Identifier: MIT
#include "view_page.hpp"

#include "report/html_text.hpp"

namespace program {

std::string view_page(const Json& view) {
  const std::string title = escaped(json_text(view.at("title")));
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>" +
         title + "</title>\n<style>" + view_style + "</style>\n</head>\n<body>\n" + view_body +
         "<script type=\"application/json\" id=\"map-data\">" + script_text(json_text(view)) +
         "</script>\n<script>" + view_script + "</script>\n</body>\n</html>\n";
}

}  // namespace program
