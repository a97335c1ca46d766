// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/local_graph_options.hpp>
#include <topobag/graph/object_track.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Which sightings are of one object. Views have rising numbers.
template <typename Scalar>
class ObjectTracks {
  using Node = SemanticNode<Scalar>;
  using Pose = Eigen::Transform<Scalar, 3, Eigen::Isometry>;
  using Track = ObjectTrack<Scalar>;

 public:
  explicit ObjectTracks(const LocalGraphOptions& options) : options_(options) {}

  /// Adds what a view shows: nodes with positions and covariances. O(objects² + objects · nodes).
  void add(std::size_t view, const std::vector<Node>& nodes) {
    associate(view, nodes);
    merge_coincident();
  }

  /// Carries everything into another frame.
  void move(const Pose& T_new_old) {
    const auto R = T_new_old.linear();
    for (Track& track : tracks_) {
      for (auto& sighting : track.sightings) {
        sighting.node.position = T_new_old * *sighting.node.position;
        sighting.node.covariance = (R * sighting.node.covariance * R.transpose()).eval();
      }
    }
  }

  /// Forgets what only earlier views saw.
  void forget_before(std::size_t view) {
    for (Track& track : tracks_) {
      auto& s = track.sightings;
      s.erase(std::remove_if(s.begin(), s.end(),
                             [&](const auto& sighting) { return sighting.view < view; }),
              s.end());
    }
    tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(),
                                 [](const auto& track) { return track.sightings.empty(); }),
                  tracks_.end());
  }

  auto begin() const { return tracks_.begin(); }
  auto end() const { return tracks_.end(); }

  /// What the track's sightings say together.
  Node fused(const Track& track) const {
    return track.fused(static_cast<Scalar>(options_.correlation));
  }

 private:
  /// The estimate of each track.
  std::vector<Node> estimates_of_all() const {
    std::vector<Node> estimates;
    for (const Track& track : tracks_) {
      estimates.push_back(fused(track));
    }
    return estimates;
  }

  /// Gives each node to the nearest object within its gate, nearest pairs first; the rest found new
  /// objects.
  void associate(std::size_t view, const std::vector<Node>& nodes) {
    const std::vector<Node> estimates = estimates_of_all();
    using Offer = std::tuple<Scalar, std::size_t, std::size_t>;  // deviation in gates, node, track
    std::vector<Offer> offers;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      for (std::size_t t = 0; t < estimates.size(); ++t) {
        const double gate =
            nodes[n].label == estimates[t].label ? options_.gate : options_.other_class_gate;
        const Scalar deviation =
            deviations_apart(nodes[n], estimates[t]) / static_cast<Scalar>(gate);
        if (deviation <= Scalar(1)) offers.emplace_back(deviation, n, t);
      }
    }
    std::sort(offers.begin(), offers.end());
    std::vector<bool> given(nodes.size(), false), taken(estimates.size(), false);
    for (const auto& [deviation, n, t] : offers) {
      if (given[n]) continue;
      // A second box well inside the gate of an object seen in this frame is a duplicate.
      if (taken[t] && deviation > Scalar(0.33)) continue;
      if (!taken[t]) tracks_[t].sightings.push_back({view, nodes[n]});
      given[n] = taken[t] = true;
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (given[n]) continue;
      tracks_.push_back({ObjectId{next_id_++}, {{view, nodes[n]}}});
    }
  }

  /// Joins objects that are one: two boxes on one thing, tracks that split. The older id stays.
  void merge_coincident() {
    std::vector<Node> estimates = estimates_of_all();
    for (std::size_t a = 0; a < tracks_.size(); ++a) {
      for (std::size_t b = a + 1; b < tracks_.size();) {
        if (!coincide(tracks_[a], estimates[a], tracks_[b], estimates[b])) {
          ++b;
          continue;
        }
        auto& into = tracks_[a].sightings;
        into.insert(into.end(), tracks_[b].sightings.begin(), tracks_[b].sightings.end());
        std::stable_sort(into.begin(), into.end(),
                         [](const auto& l, const auto& r) { return l.view < r.view; });
        estimates[a] = fused(tracks_[a]);
        tracks_.erase(tracks_.begin() + static_cast<std::ptrdiff_t>(b));
        estimates.erase(estimates.begin() + static_cast<std::ptrdiff_t>(b));
      }
    }
  }

  bool coincide(const Track& track_a, const Node& a, const Track& track_b, const Node& b) const {
    if (options_.merge(a, b)) return true;
    if (a.label != b.label) return false;
    if (!(static_cast<double>(deviations_apart(a, b)) < options_.merge_gate)) return false;
    for (const auto& s : track_a.sightings) {
      for (const auto& t : track_b.sightings) {
        if (s.view == t.view) return false;
      }
    }
    return true;
  }

  LocalGraphOptions options_;
  std::vector<Track> tracks_;  ///< ascending id
  std::uint64_t next_id_ = 0;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
