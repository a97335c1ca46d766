// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <topobag/types/class_catalog.hpp>

namespace program {

/// Reads the classes of a network: a name per line, in the order of its scores. Throws
/// topobag::Error.
std::vector<topobag::ClassId> read_class_list(const std::string& path,
                                              const topobag::ClassCatalog& catalog);

}  // namespace program
