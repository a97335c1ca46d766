// SPDX-License-Identifier: MIT
#include <topobag/topobag.hpp>

// The umbrella in two translation units of one program: a header that defines something twice fails
// to link.
std::size_t nodes_in_first() { return topobag::TopologyGraph<double>{}.size(); }
