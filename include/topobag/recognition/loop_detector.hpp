// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/error.hpp>
#include <topobag/recognition/relocalizer.hpp>

namespace topobag {
inline namespace v0 {

/// What counts as an earlier visit, and how it is recognised.
struct LoopOptions {
  double min_gap = usual_loop_gap;   ///< s; nearer key frames of the session are the present visit
  RecognitionOptions recognition{};  ///< retrieval, matching and decision
};

/// Recognises earlier places while a map grows, which is its own, or one that it refers to.
///
///     SqliteBag<> map("flat.db");
///     LoopOptions options;  // the classes' options: without, it knows nothing of them
///     options.recognition = recognition_options(ClassCatalog::coco80());
///     LoopDetector loops(map, options);  // or LoopDetector<> loops(options): a map of its own
///     for (each key frame) {
///       const Recognition loop = loops.detect_and_add(id, stamp, graph);
///       if (loop) close(id, loop);
///     }
///
/// @tparam Bag_  a bag; with `&`, one that lives elsewhere and outlives the detector
template <typename Bag_ = BagOfTopologyGraphs<>>
class LoopDetector {
 public:
  using Bag = std::remove_reference_t<Bag_>;
  using Graph = typename Bag::Graph;
  static_assert(is_growing_bag_v<Bag>,
                "topobag: a bag that grows has Graph = TopologyGraph<Scalar> and add(KeyframeId, "
                "Graph, EntryInfo).");

  /// `bag`: filled already, or with a similarity of yours; to refer to, where `Bag_` is a
  /// reference.
  explicit LoopDetector(LoopOptions options = {}, Bag_ bag = std::decay_t<Bag_>{})
      : min_gap_(options.min_gap),
        relocalizer_(std::move(options.recognition), std::forward<Bag_>(bag)) {}

  /// Refers to `map`.
  template <typename Map, std::enable_if_t<std::is_same_v<Map&, Bag_>, int> = 0>
  explicit LoopDetector(Map& map, LoopOptions options = {})
      : LoopDetector(std::move(options), map) {}

  /// The key frames so far.
  const Bag& bag() const noexcept { return relocalizer_.map(); }
  /// The same, to be changed.
  Bag& bag() noexcept { return relocalizer_.map(); }

  /// Looks the key frame up among those of other sessions, whatever their clocks say, and those of
  /// its own that are at least `min_gap` older; entries of its session without a stamp are never
  /// asked. Nothing is added. Throws InvalidValue when the stamp or the gap is not finite.
  Recognition detect(double stamp, const Graph& graph, std::uint32_t session = 0) const {
    return detect(stamp, graph, session, relocalizer_.options());
  }

  /// The same with options for this key frame alone.
  Recognition detect(double stamp, const Graph& graph, std::uint32_t session,
                     RecognitionOptions options) const {
    const double latest = stamp - min_gap_;
    if (!std::isfinite(latest)) {
      throw InvalidValue("a key frame's stamp and the least gap between visits must be finite");
    }
    options.retrieval.among.not_of = PresentVisit{session, latest};
    return relocalizer_.localize(graph, options);
  }

  /// `detect` in the session of `info`, then puts the key frame into the bag.
  Recognition detect_and_add(KeyframeId id, double stamp, Graph graph, EntryInfo info = {}) {
    Recognition recognition = detect(stamp, graph, info.session);
    info.stamp = stamp;
    bag().add(id, std::move(graph), std::move(info));
    return recognition;
  }

  /// The pose in the world of the key frame that was recognised: as `Relocalizer`.
  std::optional<PoseWithCovariance<>> T_world_query(const Recognition& recognition) const {
    return relocalizer_.T_world_query(recognition);
  }
  /// The same from the matched entry's pose and its covariance, as the back end knows them: as
  /// `Relocalizer`.
  std::optional<PoseWithCovariance<>> T_world_query(
      const Recognition& recognition, const PoseWithCovariance<>& T_world_candidate) const {
    return relocalizer_.T_world_query(recognition, T_world_candidate);
  }

  /// How key frames are recognised.
  const RecognitionOptions& options() const noexcept { return relocalizer_.options(); }
  /// From the next key frame on; a calibration comes in by this. Not while another thread looks up.
  void set_options(RecognitionOptions options) { relocalizer_.set_options(std::move(options)); }

 private:
  double min_gap_;
  Relocalizer<Bag_> relocalizer_;
};

/// Of a map that lives elsewhere.
template <typename Bag, std::enable_if_t<is_growing_bag_v<Bag>, int> = 0>
explicit LoopDetector(Bag&) -> LoopDetector<Bag&>;
/// The same with options.
template <typename Bag, std::enable_if_t<is_growing_bag_v<Bag>, int> = 0>
explicit LoopDetector(Bag&, LoopOptions) -> LoopDetector<Bag&>;

#ifdef TOPOBAG_COMPILED  // in the library topobag::compiled
extern template class LoopDetector<>;
#endif

}  // namespace v0
}  // namespace topobag
