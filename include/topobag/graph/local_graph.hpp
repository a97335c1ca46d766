// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/gravity.hpp>
#include <topobag/graph/object_track.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/graph/view.hpp>
#include <topobag/sensing/node_noise.hpp>
#include <topobag/sensing/same_object.hpp>
#include <topobag/types/rigid_motion.hpp>
#include <topobag/types/stamp.hpp>

namespace topobag {
inline namespace v0 {

/// Over how long nodes are fused, and which are one object.
struct LocalGraphOptions {
  double window = 3.0;            ///< s; views older than the newest by more are forgotten
  double gate = 3.0;              ///< σ within which a sighting joins an object of its class
  double other_class_gate = 1.0;  ///< σ for another class: detectors waver between tv and laptop
  SameObject merge{0.3};          ///< when two objects of whatever class are made one
  double merge_gate = 2.0;        ///< σ for two of one class that no view shows together
  double correlation = 0.5;    ///< share of a sighting's, or a gravity's, error that others repeat
  double image_margin = 20.0;  ///< px from the border within which nothing need show
  double max_depth = 8.0;      ///< m beyond which nothing need show
  double min_existence = 0.2;  ///< share of the views due to show an object that must have
};

/// Fuses the nodes of the last key frames into one flicker-proof graph in the newest key frame's
/// frame.
///
/// Detectors flicker: most consecutive frames differ in the classes found. Moved by the front end's
/// own relative poses, sightings of one object fall together; each object carries its existence
/// evidence, class votes, mean position with covariance, and size. An object seen in too few of
/// the views that should have shown it is dropped. Where key frames say which way is down, their
/// directions are moved alike and fused.
template <typename Scalar_ = double>
class LocalGraph {
 public:
  using Scalar = Scalar_;
  using Node = SemanticNode<Scalar>;
  using Pose = Eigen::Transform<Scalar, 3, Eigen::Isometry>;

  /// Without a key frame yet.
  explicit LocalGraph(LocalGraphOptions options = {}) : options_(options) {}

  /// Adds the nodes of the next key frame. Nodes without a position are left out.
  /// @param stamp               s, not before the last one
  /// @param nodes               in the key frame's camera frame
  /// @param T_previous_current  from this key frame's camera to the last one's; the first has none
  /// @param view                the key frame's camera and occluders; `T_graph_camera` is ignored
  /// @param gravity             which way is down in the key frame's camera frame, where it knows
  /// Throws InvalidValue for a stamp that goes back, for a pose that is no rigid motion, a camera
  /// that is not finite, and, with its index, for a node that a graph would refuse, and a gravity
  /// alike. O(objects² + objects · nodes).
  void add(double stamp, const std::vector<Node>& nodes, const Pose& T_previous_current,
           View<Scalar> view = {}, std::optional<Gravity<Scalar>> gravity = std::nullopt) {
    require_seconds(stamp);
    if (!frames_.empty() && stamp < frames_.back().stamp) {
      throw InvalidValue("a local graph's stamps must not go back");
    }
    // Put right, as a window is a product of many.
    Pose T_current_previous = Pose::Identity();
    if (!frames_.empty()) {
      const Eigen::Isometry3d T = nearest_rigid(T_previous_current.matrix().template cast<double>(),
                                                "the relative pose", computed_rotation_tolerance);
      T_current_previous = T.template cast<Scalar>().inverse();
    }
    if (view.camera.fx != Scalar(0)) view.camera.validate();
    const TopologyGraph<Scalar> shown(nodes, {}, {}, gravity);
    const std::vector<Node> sighted = placed(shown);
    if (!frames_.empty()) move_to_frame(T_current_previous);
    forget_before(stamp - options_.window);
    view.T_graph_camera.setIdentity();
    frames_.push_back({stamp, next_view_, std::move(view), shown.gravity()});
    associate(sighted);
    merge_coincident();
    ++next_view_;
  }

  /// The fused graph. `view_count()` of its views come with it. O(objects · views² + builder).
  template <typename Builder = KnnEdges>
  TopologyGraph<Scalar> graph(const Builder& builder = {}) const {
    std::vector<Node> nodes;
    for (const auto& [id, node] : objects()) nodes.push_back(node);
    std::vector<View<Scalar>> views;
    for (const Frame& frame : frames_) views.push_back(frame.view);
    return make_topology_graph(std::move(nodes), builder, std::move(views), gravity());
  }

  /// The objects that `graph()` holds, in its order (ascending id).
  std::vector<std::pair<ObjectId, Node>> objects() const {
    std::vector<std::pair<ObjectId, Node>> kept;
    for (const ObjectTrack<Scalar>& track : tracks_) {
      Node node = track.fused(static_cast<Scalar>(options_.correlation));
      const auto [seen, expected] = evidence(track, *node.position);
      node.existence = static_cast<Scalar>(seen) / static_cast<Scalar>(expected);
      if (static_cast<double>(node.existence) < options_.min_existence) continue;
      node.z = std::max(node.position->z(), Scalar(0));
      const PinholeCamera<Scalar>& camera = frames_.back().view.camera;
      if (camera.fx > Scalar(0)) node.pixel = camera.project(*node.position);
      kept.emplace_back(track.id, std::move(node));
    }
    return kept;
  }

  /// Which way is down in the newest key frame's camera frame: what the key frames of the window
  /// that know it say together (see `fused_gravity`); relative poses are taken to be exact. Nothing
  /// where none knows. O(views).
  std::optional<Gravity<Scalar>> gravity() const {
    std::vector<Gravity<Scalar>> directions;
    for (const Frame& frame : frames_) {
      if (!frame.gravity) continue;
      directions.push_back(*frame.gravity);
      directions.back().down = frame.view.T_graph_camera.linear() * frame.gravity->down;
    }
    return fused_gravity(directions, static_cast<Scalar>(options_.correlation));
  }

  /// Key frames in the window.
  std::size_t view_count() const noexcept { return frames_.size(); }

 private:
  struct Frame {
    double stamp;
    std::size_t number;
    View<Scalar> view;
    std::optional<Gravity<Scalar>> gravity;  ///< in its own camera frame
  };

  /// Carries everything into the newest camera's frame.
  void move_to_frame(const Pose& T_new_old) {
    for (Frame& frame : frames_) frame.view.T_graph_camera = T_new_old * frame.view.T_graph_camera;
    const auto R = T_new_old.linear();
    for (ObjectTrack<Scalar>& track : tracks_) {
      for (auto& sighting : track.sightings) {
        sighting.node.position = T_new_old * *sighting.node.position;
        sighting.node.covariance = (R * sighting.node.covariance * R.transpose()).eval();
      }
    }
  }

  void forget_before(double stamp) {
    while (!frames_.empty() && frames_.front().stamp < stamp) frames_.pop_front();
    const std::size_t oldest = frames_.empty() ? next_view_ : frames_.front().number;
    for (ObjectTrack<Scalar>& track : tracks_) {
      auto& s = track.sightings;
      s.erase(std::remove_if(s.begin(), s.end(),
                             [&](const auto& sighting) { return sighting.view < oldest; }),
              s.end());
    }
    tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(),
                                 [](const auto& track) { return track.sightings.empty(); }),
                  tracks_.end());
  }

  /// The nodes with a position; one whose covariance is not modelled gets the default noise.
  static std::vector<Node> placed(const TopologyGraph<Scalar>& graph) {
    std::vector<Node> kept;
    for (const Node& node : graph.nodes()) {
      if (!node.position) continue;
      kept.push_back(node);
      kept.back().covariance = position_covariance(node).template cast<Scalar>();
    }
    return kept;
  }

  /// The estimate of each track.
  std::vector<Node> fused() const {
    std::vector<Node> estimates;
    for (const ObjectTrack<Scalar>& track : tracks_) {
      estimates.push_back(track.fused(static_cast<Scalar>(options_.correlation)));
    }
    return estimates;
  }

  /// Gives each node to the nearest object within its gate, nearest pairs first; the rest found new
  /// objects.
  void associate(const std::vector<Node>& nodes) {
    const std::vector<Node> estimates = fused();
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
      if (!taken[t]) tracks_[t].sightings.push_back({next_view_, nodes[n]});
      given[n] = taken[t] = true;
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (given[n]) continue;
      tracks_.push_back({ObjectId{next_id_++}, {{next_view_, nodes[n]}}});
    }
  }

  /// Joins objects that are one: two boxes on one thing, tracks that split. The older id stays.
  void merge_coincident() {
    std::vector<Node> estimates = fused();
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
        estimates[a] = tracks_[a].fused(static_cast<Scalar>(options_.correlation));
        tracks_.erase(tracks_.begin() + static_cast<std::ptrdiff_t>(b));
        estimates.erase(estimates.begin() + static_cast<std::ptrdiff_t>(b));
      }
    }
  }

  bool coincide(const ObjectTrack<Scalar>& track_a, const Node& a,
                const ObjectTrack<Scalar>& track_b, const Node& b) const {
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

  /// Views that saw the object, and views that saw it or should have.
  std::pair<std::size_t, std::size_t> evidence(const ObjectTrack<Scalar>& track,
                                               const typename Node::Vector3& position) const {
    std::size_t expected = 0, seen_views = 0;
    for (const Frame& frame : frames_) {
      const bool seen = std::any_of(track.sightings.begin(), track.sightings.end(),
                                    [&](const auto& s) { return s.view == frame.number; });
      const bool due = frame.view.should_show(position, static_cast<Scalar>(options_.image_margin),
                                              static_cast<Scalar>(options_.max_depth));
      if (seen) ++seen_views;
      if (seen || due) ++expected;
    }
    return {seen_views, expected};
  }

  LocalGraphOptions options_;
  std::deque<Frame> frames_;                 ///< oldest first
  std::vector<ObjectTrack<Scalar>> tracks_;  ///< ascending id
  std::size_t next_view_ = 0;
  std::uint64_t next_id_ = 0;
};

}  // namespace v0
}  // namespace topobag
