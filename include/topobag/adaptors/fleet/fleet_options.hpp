// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/graph_codec.hpp>

namespace topobag {
inline namespace v0 {

/// A server, and the sites that are followed there.
struct FleetSource {
  std::string conninfo;            ///< as `PostgresStore` has it
  std::vector<std::string> sites;  ///< their names
};

/// How a fleet is followed.
struct FleetOptions {
  std::uint64_t catalog = 0;  ///< fingerprint that all key frames' classes must have; 0 = any
  ViewSection views = ViewSection::kept;  ///< whether graphs keep their views
  std::chrono::milliseconds silence = std::chrono::seconds(30);  ///< as `PostgresStore` has it
  /// All that is said of the classes in use, which no site may say otherwise; in place of
  /// `catalog`, which is then their fingerprint.
  std::optional<DescribedCatalog> classes{};
};

}  // namespace v0
}  // namespace topobag
