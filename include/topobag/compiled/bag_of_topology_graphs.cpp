// SPDX-License-Identifier: MIT
// Of the library topobag::compiled: what TOPOBAG_COMPILED keeps other files from instantiating.
#include <topobag/bag/bag_of_topology_graphs.hpp>

namespace topobag {
inline namespace v0 {

template class BagOfTopologyGraphs<TopologyGraph<double>, ClassPairDistanceHistogram>;

}  // namespace v0
}  // namespace topobag
