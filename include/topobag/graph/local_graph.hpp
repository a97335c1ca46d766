// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/detail/object_tracks.hpp>
#include <topobag/graph/gravity.hpp>
#include <topobag/graph/keyframe_sighting.hpp>
#include <topobag/graph/local_graph_options.hpp>
#include <topobag/graph/object_track.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/graph/view.hpp>
#include <topobag/sensing/node_noise.hpp>
#include <topobag/types/rigid_motion.hpp>
#include <topobag/types/stamp.hpp>

namespace topobag {
inline namespace v0 {

/// Fuses the nodes of the last key frames into one flicker-proof graph in the newest key frame's
/// frame.
///
/// Detectors flicker: most consecutive frames differ in the classes found. Moved by the front end's
/// own relative poses, sightings of one object fall together; each object carries its existence
/// evidence, class votes, mean position with covariance, and size. An object seen in too few of
/// the views that should have shown it is dropped. Where key frames say which way is down, their
/// directions are moved alike and fused.
///
/// A rig of several cameras is added camera by camera, all at one stamp, each by its place on the
/// rig: for the first camera of a stamp `T_previous_current` is from it to the camera that was
/// added last, which is the motion and the rig's own geometry together. The graph is in the frame
/// of the camera added last; what several cameras see is one object, and one that only some of them
/// can see is expected of these alone.
template <typename Scalar_ = double>
class LocalGraph {
 public:
  using Scalar = Scalar_;
  using Node = SemanticNode<Scalar>;
  using Pose = Eigen::Transform<Scalar, 3, Eigen::Isometry>;

  /// Without a key frame yet.
  explicit LocalGraph(LocalGraphOptions options = {}) : options_(options), tracks_(options) {}

  /// Adds the nodes of the next key frame. Nodes without a position are left out.
  /// @param stamp               s, not before the last one
  /// @param nodes               in the key frame's camera frame
  /// @param T_previous_current  from this key frame's camera to the last one's; the first has none
  /// @param view                the key frame's camera and occluders; `T_graph_camera` is ignored
  /// @param gravity             which way is down in the key frame's camera frame, where it knows
  /// Throws InvalidValue for a stamp that goes back, for a pose that is no rigid motion, a view and,
  /// with its index, a node that a graph would refuse, and a gravity alike, or descriptors of
  /// another kind than before. O(objects² + objects · nodes).
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
    view.T_graph_camera.setIdentity();
    view.validate();  // here: later it would come up in every graph of the window
    const TopologyGraph<Scalar> shown(nodes, {}, {}, gravity);
    appearance_kind_ = common_kind(appearance_kind_, shown.appearance_kind(), "the key frame");
    const std::vector<Node> sighted = placed(shown);
    if (!frames_.empty()) move_to_frame(T_current_previous);
    forget_before(stamp - options_.window);
    frames_.push_back({stamp, next_view_, std::move(view), shown.gravity()});
    tracks_.add(next_view_++, sighted);
  }

  /// The same of what `sight_keyframe` gives.
  void add(const KeyframeSighting& seen, const Pose& T_previous_current) {
    static_assert(std::is_same_v<Scalar, double>,
                  "topobag: a KeyframeSighting is of double; so is the LocalGraph that takes it.");
    add(seen.stamp, seen.nodes, T_previous_current, seen.view, seen.gravity);
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
    for (const auto& [track, estimate] : tracks_) {
      Node node = estimate;
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
    tracks_.move(T_new_old);
  }

  void forget_before(double stamp) {
    while (!frames_.empty() && frames_.front().stamp < stamp) frames_.pop_front();
    const std::size_t oldest = frames_.empty() ? next_view_ : frames_.front().number;
    tracks_.forget_before(oldest);
  }

  /// The nodes with a position; one whose covariance is not modelled gets the options' noise.
  std::vector<Node> placed(const TopologyGraph<Scalar>& graph) const {
    std::vector<Node> kept;
    for (const Node& node : graph.nodes()) {
      if (!node.position) continue;
      kept.push_back(node);
      kept.back().covariance = position_covariance(node, options_.noise).template cast<Scalar>();
    }
    return kept;
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
  std::deque<Frame> frames_;  ///< oldest first
  detail::ObjectTracks<Scalar> tracks_;
  std::size_t next_view_ = 0;
  AppearanceKind appearance_kind_;  ///< of all key frames so far
};

}  // namespace v0
}  // namespace topobag
