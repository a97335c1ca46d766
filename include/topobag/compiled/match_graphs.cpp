// SPDX-License-Identifier: MIT
// Of the library topobag::compiled: what TOPOBAG_COMPILED keeps other files from instantiating.
#include <topobag/matching/judge_pose.hpp>
#include <topobag/matching/match_graphs.hpp>
#include <topobag/recognition/explain.hpp>

namespace topobag {
inline namespace v0 {

template GraphMatch detail::match_known(const TopologyGraph<double>&,
                                        const detail::KnownDistances<double>&, const MatchOptions&);
template GraphMatch detail::match_in_one_unit(const TopologyGraph<double>&,
                                              const detail::KnownDistances<double>&,
                                              const MatchOptions&);
template GraphMatch match_graphs(const TopologyGraph<double>&, const TopologyGraph<double>&,
                                 const MatchOptions&);
template std::optional<RelativePose> judge_pose(const TopologyGraph<double>&,
                                                const TopologyGraph<double>&,
                                                const Eigen::Isometry3d&, const MatchOptions&,
                                                double);
template CandidateExplanation explain_candidate(const CandidateReport&,
                                                const TopologyGraph<double>&,
                                                const TopologyGraph<double>&, const ClassCatalog&,
                                                const RecognitionOptions&, std::optional<double>);

}  // namespace v0
}  // namespace topobag
