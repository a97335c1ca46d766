// SPDX-License-Identifier: MIT
#include "fleet_address.hpp"

#include <cctype>
#include <cstddef>
#include <sstream>

#include "input_error.hpp"

namespace program {
namespace {

/// Of an address' part, with %20 and its like read.
std::string decoded(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool code = text[i] == '%' && i + 2 < text.size() &&
                      std::isxdigit(static_cast<unsigned char>(text[i + 1])) != 0 &&
                      std::isxdigit(static_cast<unsigned char>(text[i + 2])) != 0;
    plain += code ? static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16)) : text[i];
    if (code) i += 2;
  }
  return plain;
}

}  // namespace

bool is_fleet_address(const std::string& text) {
  return text.rfind("postgresql:", 0) == 0 || text.rfind("postgres:", 0) == 0;
}

FleetAddress parse_fleet_address(const std::string& text) {
  if (!is_fleet_address(text) || text.compare(text.find(':'), 3, "://") != 0) {
    throw InputError(text,
                     "it is no server's address, as postgresql://USER@HOST/BASE?site=NAME is");
  }
  const std::size_t question = text.find('?');
  const std::string base = text.substr(0, question);
  const std::size_t user = base.find("//") + 2, at = base.find('@', user);
  const std::size_t colon = base.find(':', user);
  FleetAddress address{base, {}, {}};
  bool password = at != std::string::npos && colon < at;
  std::istringstream settings(question == std::string::npos ? "" : text.substr(question + 1));
  std::string rest;
  for (std::string setting; std::getline(settings, setting, '&');) {
    const std::size_t equals = setting.find('=');
    const std::string key = setting.substr(0, equals);
    const std::string value =
        equals == std::string::npos ? "" : decoded(setting.substr(equals + 1));
    if (key == "site") {
      address.sites.push_back(value);
    } else if (key == "robot") {
      address.robot = value;
    } else {
      password = password || key == "password";
      rest += (rest.empty() ? '?' : '&') + setting;
    }
  }
  if (password) {
    throw InputError(
        "the address holds a password, which others would see; give it in PGPASSWORD or ~/.pgpass");
  }
  address.conninfo += rest;
  return address;
}

}  // namespace program
