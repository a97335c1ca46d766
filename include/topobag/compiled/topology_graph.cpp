// SPDX-License-Identifier: MIT
// Of the library topobag::compiled: what TOPOBAG_COMPILED keeps other files from instantiating.
#include <topobag/graph/topology_graph.hpp>

namespace topobag {
inline namespace v0 {

template class TopologyGraph<double>;

}  // namespace v0
}  // namespace topobag
