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

 public:
  struct Object {
    ObjectTrack<Scalar> track;
    Node estimate;  ///< what its sightings say together
  };

  explicit ObjectTracks(const LocalGraphOptions& options) : options_(options) {}

  /// Adds what a view shows: nodes with positions and covariances. O(objects² + objects · nodes).
  void add(std::size_t view, const std::vector<Node>& nodes) {
    associate(view, nodes);
    merge_coincident();
  }

  /// Carries everything into another frame.
  void move(const Pose& T_new_old) {
    const auto R = T_new_old.linear();
    const auto carry = [&](Node& node) {
      node.position = T_new_old * *node.position;
      node.covariance = (R * node.covariance * R.transpose()).eval();
    };
    for (Object& object : objects_) {
      for (auto& sighting : object.track.sightings) carry(sighting.node);
      carry(object.estimate);
    }
  }

  /// Forgets what only earlier views saw.
  void forget_before(std::size_t view) {
    for (Object& object : objects_) {
      auto& s = object.track.sightings;
      const auto forgotten = std::remove_if(
          s.begin(), s.end(), [&](const auto& sighting) { return sighting.view < view; });
      if (forgotten == s.end()) continue;
      s.erase(forgotten, s.end());
      if (!s.empty()) estimate(object);
    }
    objects_.erase(
        std::remove_if(objects_.begin(), objects_.end(),
                       [](const Object& object) { return object.track.sightings.empty(); }),
        objects_.end());
  }

  auto begin() const { return objects_.begin(); }
  auto end() const { return objects_.end(); }

 private:
  void estimate(Object& object) const {
    object.estimate = object.track.fused(static_cast<Scalar>(options_.correlation));
  }

  /// Gives each node to the nearest object within its gate, nearest pairs first; the rest found new
  /// objects.
  void associate(std::size_t view, const std::vector<Node>& nodes) {
    using Offer = std::tuple<Scalar, std::size_t, std::size_t>;  // deviation in gates, node, object
    std::vector<Offer> offers;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      for (std::size_t k = 0; k < objects_.size(); ++k) {
        const Node& known = objects_[k].estimate;
        const double gate =
            nodes[n].label == known.label ? options_.gate : options_.other_class_gate;
        const Scalar deviation = deviations_apart(nodes[n], known) / static_cast<Scalar>(gate);
        if (deviation <= Scalar(1)) offers.emplace_back(deviation, n, k);
      }
    }
    std::sort(offers.begin(), offers.end());
    std::vector<bool> given(nodes.size(), false), taken(objects_.size(), false);
    for (const auto& [deviation, n, k] : offers) {
      if (given[n]) continue;
      // A second box well inside the gate of an object seen in this frame is a duplicate.
      if (taken[k] && deviation > Scalar(0.33)) continue;
      if (!taken[k]) {
        objects_[k].track.sightings.push_back({view, nodes[n]});
        estimate(objects_[k]);
      }
      given[n] = taken[k] = true;
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (given[n]) continue;
      objects_.push_back({{ObjectId{next_id_++}, {{view, nodes[n]}}}, {}});
      estimate(objects_.back());
    }
  }

  /// Joins objects that are one: two boxes on one thing, tracks that split. The older id stays.
  void merge_coincident() {
    for (std::size_t a = 0; a < objects_.size(); ++a) {
      for (std::size_t b = a + 1; b < objects_.size();) {
        if (!coincide(objects_[a], objects_[b])) {
          ++b;
          continue;
        }
        auto& into = objects_[a].track.sightings;
        const auto& from = objects_[b].track.sightings;
        into.insert(into.end(), from.begin(), from.end());
        std::stable_sort(into.begin(), into.end(),
                         [](const auto& l, const auto& r) { return l.view < r.view; });
        estimate(objects_[a]);
        objects_.erase(objects_.begin() + static_cast<std::ptrdiff_t>(b));
      }
    }
  }

  bool coincide(const Object& a, const Object& b) const {
    if (options_.merge(a.estimate, b.estimate)) return true;
    if (a.estimate.label != b.estimate.label) return false;
    const auto apart = static_cast<double>(deviations_apart(a.estimate, b.estimate));
    if (!(apart < options_.merge_gate)) return false;
    for (const auto& s : a.track.sightings) {
      for (const auto& t : b.track.sightings) {
        if (s.view == t.view) return false;
      }
    }
    return true;
  }

  LocalGraphOptions options_;
  std::vector<Object> objects_;  ///< ascending id
  std::uint64_t next_id_ = 0;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
