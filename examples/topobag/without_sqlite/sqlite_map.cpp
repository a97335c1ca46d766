// SPDX-License-Identifier: MIT
#include "sqlite_map.hpp"

#include "input_error.hpp"

namespace program {
namespace {

[[noreturn]] void refuse(const std::string& path) {
  throw InputError(path, "the program was built without SQLite3; install it, build again");
}

}  // namespace

std::optional<topobag::DescribedCatalog> sqlite_map_classes(const std::string& path) {
  refuse(path);
}

SavedMap read_sqlite_map(const std::string& path, const topobag::DescribedCatalog&) {
  refuse(path);
}

void extend_sqlite_map(const std::string& path, const std::string&,
                       const topobag::BagOfTopologyGraphs<>&, const topobag::DescribedCatalog&) {
  refuse(path);
}

void write_sqlite_map(const std::string& path, const SavedMap&, const topobag::DescribedCatalog&) {
  refuse(path);
}

}  // namespace program
