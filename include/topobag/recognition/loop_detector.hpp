// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/error.hpp>
#include <topobag/recognition/relocalizer.hpp>

namespace topobag {
inline namespace v0 {

/// What counts as an earlier visit, and how it is recognised.
struct LoopOptions {
  double min_gap = 20.0;             ///< s; nearer key frames of the session are the present visit
  RecognitionOptions recognition{};  ///< retrieval, matching and decision
};

/// Recognises earlier places while a map grows.
///
///     LoopDetector<> loops;
///     for (each key frame) {
///       const Recognition loop = loops.detect_and_add(id, stamp, graph);
///       if (loop) close(id, loop);
///     }
template <typename Bag_ = BagOfTopologyGraphs<>>
class LoopDetector {
  static_assert(is_growing_bag_v<Bag_>,
                "topobag: a bag that grows has Graph = TopologyGraph<Scalar> and add(KeyframeId, "
                "Graph, EntryInfo).");

 public:
  using Bag = Bag_;
  using Graph = typename Bag::Graph;

  /// `bag`: filled already, or with a similarity of yours.
  explicit LoopDetector(LoopOptions options = {}, Bag bag = Bag{})
      : min_gap_(options.min_gap), relocalizer_(std::move(options.recognition), std::move(bag)) {}

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

  /// How key frames are recognised.
  const RecognitionOptions& options() const noexcept { return relocalizer_.options(); }
  /// From the next key frame on; a calibration comes in by this. Not while another thread looks up.
  void set_options(RecognitionOptions options) { relocalizer_.set_options(std::move(options)); }

 private:
  double min_gap_;
  Relocalizer<Bag> relocalizer_;
};

}  // namespace v0
}  // namespace topobag
