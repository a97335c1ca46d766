// SPDX-License-Identifier: MIT
#include "query_outcome.hpp"

#include <cmath>
#include <utility>

namespace program {

Outcome outcome_of(topobag::PoseVerdict verdict) {
  switch (verdict) {
    case topobag::PoseVerdict::correct:
      return Outcome::correct;
    case topobag::PoseVerdict::imprecise:
      return Outcome::imprecise;
    case topobag::PoseVerdict::wrong:
      return Outcome::wrong;
  }
  return Outcome::unscored;
}

OutcomeStyle style_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::correct:
      return {"correct", "correct", Marker::dot};
    case Outcome::imprecise:
      return {"imprecise", "imprecise", Marker::triangle};
    case Outcome::wrong:
      return {"wrong", "wrong", Marker::cross};
    case Outcome::unscored:
      return {"accepted, truth unknown", "third", Marker::dot};
    case Outcome::missed:
      return {"missed", "missed", Marker::ring};
    case Outcome::nothing:
      return {"nothing to find", "nothing", Marker::ring};
  }
  return {"", "", Marker::dot};
}

KnownPlaces known_places(topobag::Trajectory queries, topobag::Trajectory map,
                         topobag::PlaceProtocol protocol, std::optional<double> loop_gap) {
  if (loop_gap) {
    protocol.exclude_seconds = *loop_gap;
    protocol.past_only = true;
  }
  const topobag::PlaceTruth truth = loop_gap ? topobag::PlaceTruth(protocol, queries)
                                             : topobag::PlaceTruth(protocol, queries, map);
  return {std::move(queries), std::move(map), truth, protocol.frustum};
}

std::optional<TruePlace> nearest_true_place(const KnownPlaces& places, std::size_t query) {
  const topobag::PlaceTruth& truth = places.truth;
  const topobag::StampedPose& q = places.queries[query];
  std::optional<TruePlace> nearest;
  for (std::size_t i = 0; i < truth.num_candidates(); ++i) {
    const double distance =
        (q.T_world_body.translation() - places.map[i].T_world_body.translation()).norm();
    if (nearest && distance >= nearest->distance_m) continue;
    if (truth.relation(query, i) != topobag::PairRelation::positive) continue;
    nearest.emplace();
    nearest->candidate = i;
    nearest->distance_m = distance;
  }
  if (!nearest) return nearest;
  const Eigen::Isometry3d T_candidate_query = truth.T_candidate_query(query, nearest->candidate);
  nearest->angle_deg = topobag::rotation_angle_deg(T_candidate_query.linear());
  nearest->gap_s = std::abs(q.stamp - places.map[nearest->candidate].stamp);
  if (places.frustum) {
    nearest->overlap = topobag::frustum_overlap(*places.frustum, T_candidate_query);
  }
  return nearest;
}

}  // namespace program
