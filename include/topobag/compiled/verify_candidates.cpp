// SPDX-License-Identifier: MIT
// Of the library topobag::compiled: what TOPOBAG_COMPILED keeps other files from instantiating.
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/bag_view.hpp>
#include <topobag/recognition/verify_candidates.hpp>

namespace topobag {
inline namespace v0 {

template Recognition verify_candidates(const BagOfTopologyGraphs<>&, const TopologyGraph<double>&,
                                       const std::vector<Candidate>&, const RecognitionOptions&);
template Recognition verify_candidates(const BagView&, const TopologyGraph<double>&,
                                       const std::vector<Candidate>&, const RecognitionOptions&);

}  // namespace v0
}  // namespace topobag
