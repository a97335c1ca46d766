// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_reader.hpp>
#include <topobag/bag/bag_view.hpp>
#include <topobag/bag/camera_poses.hpp>
#include <topobag/bag/detail/index/encoded_entry.hpp>
#include <topobag/bag/detail/index/free_ids.hpp>
#include <topobag/bag/detail/index/part_builder.hpp>
#include <topobag/bag/detail/index/part_edits.hpp>
#include <topobag/bag/detail/index/published_places.hpp>
#include <topobag/bag/detail/present_view.hpp>
#include <topobag/bag/merge_options.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// A bag of topology graphs for a million key frames: graphs in some 100 bytes each, exact answers
/// without reading most of them, and readers that never wait.
///
/// Graphs are kept as `encode` rounds them. A query gives the same ids and similarities, to the
/// last bit, as `BagOfTopologyGraphs` over the graphs that `find` returns. It is fast when
/// neighbours in the order of adding are alike, as key frames of a drive are.
///
/// One thread at a time may call what is not const; any number may take a `view()` meanwhile, and
/// read it as long as they like. The const calls ask such a view. After a call has thrown, the bag
/// is as it was.
template <typename Similarity_ = ClassPairDistanceHistogram>
class BasicIndexedBag : public BagReader<BasicIndexedBag<Similarity_>, BasicBagView<Similarity_>> {
 public:
  using Similarity = Similarity_;
  using View = BasicBagView<Similarity>;
  using Graph = typename View::Graph;

  /// @param views  whether the cameras that looked for the nodes are kept with the graphs
  explicit BasicIndexedBag(Similarity similarity = {}, ViewSection views = ViewSection::kept)
      : similarity_(std::make_shared<const Similarity>(std::move(similarity))), views_(views) {
    publish({});
  }
  /// Of the bag as it is now; thread-safe for `other`. O(1): the copies share what neither changes.
  BasicIndexedBag(const BasicIndexedBag& other)
      : similarity_(other.similarity_), views_(other.views_) {
    detail::BagParts parts = other.view()->parts_;
    if (parts.head) parts.head = std::make_shared<detail::HeadBlock>(*parts.head, parts.head_size);
    places_.recount(parts);
    publish(std::move(parts));
  }
  BasicIndexedBag& operator=(const BasicIndexedBag& other) {
    BasicIndexedBag copy(other);
    similarity_ = copy.similarity_;
    views_ = copy.views_;
    places_ = copy.places_;
    publish(copy.parts());
    return *this;
  }

  /// The bag as it is now. Thread-safe; O(1).
  std::shared_ptr<const View> view() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return view_;
  }

  /// Puts a key frame's graph into the bag. Throws InvalidId if `id` is there already, InvalidValue
  /// as `EntryInfo::validate` and `require_savable`, and for descriptors, of objects or of the
  /// image, of another kind than the bag's. O(n² + log n) for n nodes, amortised.
  void add(KeyframeId id, const Graph& graph, const EntryInfo& info = {}) {
    if (this->contains(id)) {
      throw InvalidId("key frame " + std::to_string(value(id)) +
                      " is in the bag already: use update");
    }
    detail::BagParts next = with_kinds_of(graph, info);
    detail::append(next, make_entry(id, graph, info), *similarity_);
    places_.add(id, info, class_counts(graph.nodes()));
    publish(std::move(next));
  }

  /// Replaces a key frame's graph and info. Throws InvalidId if `id` is not there.
  void update(KeyframeId id, const Graph& graph, const EntryInfo& info = {}) {
    const auto place = parts().find(id);
    if (!place) {
      throw InvalidId("key frame " + std::to_string(value(id)) + " is not in the bag: use add");
    }
    detail::HeadBlock::Entry entry = make_entry(id, graph, info);
    detail::BagParts next = with_kinds_of(graph, info);
    const auto [info_before, objects_before] = places_.placed(next, *place);
    detail::remove(next, *place, *similarity_);
    detail::append(next, std::move(entry), *similarity_);
    places_.remove(id, info_before, objects_before);
    places_.add(id, info, class_counts(graph.nodes()));
    publish(std::move(next));
  }

  /// Moves key frames, as a back end does when it has closed a loop; the others stay. Throws as
  /// `require_poses_of`. O(poses · log n + entries of the segments that hold them).
  void set_poses(const CameraPoses& T_world_camera) {
    require_poses_of(*this, T_world_camera);
    detail::BagParts next = detail::with_poses(parts(), T_world_camera);
    for (const auto& [id, T] : T_world_camera) places_.move(parts(), next, *next.find(id));
    publish(std::move(next));
  }

  /// Takes a key frame out; false if it was not there. Its room comes back when half of its segment
  /// is gone, and with `compact`.
  bool erase(KeyframeId id) {
    const auto place = parts().find(id);
    if (!place) return false;
    detail::BagParts next = parts();
    const auto [info, objects] = places_.placed(next, *place);
    detail::remove(next, *place, *similarity_);
    places_.remove(id, info, objects);
    publish(std::move(next));
    return true;
  }

  void clear() {
    places_.clear();
    publish({});
  }

  /// Adds all entries of another bag. Ids that are free are kept; the others become the numbers
  /// after the greatest of both bags, in their order. Views come along where this bag keeps them.
  /// Returns where each id went. Throws InvalidValue as `MergeOptions` and `encode`, when the ids
  /// run out or a pose becomes infinite, for descriptors of another kind, and InvalidId when the
  /// sessions run out. O(n log n).
  std::map<KeyframeId, KeyframeId> merge(const View& other, const MergeOptions& options = {}) {
    options.validate();
    const detail::BagParts& theirs = other.parts_;
    const detail::DescriptorKinds kinds = parts().kinds.with(theirs.kinds);
    auto new_ids = detail::free_ids(theirs.by_id(), parts().by_id());
    detail::BagParts next = detail::sealed(parts(), *similarity_);
    detail::PartBuilder<Similarity> builder(*similarity_);
    theirs.for_each([&](detail::EntryPlace place) {
      const detail::StoredEntry entry = theirs.entry(place);
      const EntryInfo info = options.moved(theirs.info(place));
      builder.add(new_ids.at(entry.id), info, entry, views_, options.scale);
    });
    auto sealed_parts = std::make_shared<detail::BagParts::Sealed>(*next.sealed);
    for (detail::SealedPart& part : builder.finish()) sealed_parts->push_back(std::move(part));
    next.sealed = std::move(sealed_parts);
    next.kinds = kinds;
    next.live += theirs.live;
    places_.recount(next);
    publish(std::move(next));
    return new_ids;
  }

  /// The same for any other bag with `for_each` as this one's.
  template <typename Other>
  std::map<KeyframeId, KeyframeId> merge(const Other& other, const MergeOptions& options = {}) {
    if constexpr (std::is_same_v<detail::PresentView<Other>, View>) {
      return merge(*detail::present_view(other, 0), options);
    } else {
      static_assert(detail::require_entries<Other, Graph>());
      BasicIndexedBag copy(*similarity_, views_);
      other.for_each([&](KeyframeId id, const EntryInfo& info, const Graph& graph) {
        copy.add(id, graph, info);
      });
      return merge(*copy.view(), options);
    }
  }

  /// Gives back all room of what is gone and makes the index as good as it gets. O(n).
  void compact() {
    detail::PartBuilder<Similarity> builder(*similarity_);
    const detail::BagParts old = parts();
    old.for_each([&](detail::EntryPlace place) { builder.add(old, place); });
    detail::BagParts next;
    next.sealed = std::make_shared<const detail::BagParts::Sealed>(builder.finish());
    next.live = old.live;
    next.kinds = old.kinds;
    publish(std::move(next));
  }

 private:
  /// For the writer, who alone replaces the view.
  const detail::BagParts& parts() const { return view_->parts_; }

  /// The parts as they are, ready for the descriptors of the graph's objects and of the image.
  detail::BagParts with_kinds_of(const Graph& graph, const EntryInfo& info) const {
    detail::BagParts next = parts();
    next.kinds = next.kinds.with(graph, info);
    return next;
  }

  void publish(detail::BagParts parts) {
    parts.places = places_.size();
    parts.contents = places_.contents();
    auto next = std::make_shared<const View>(similarity_, std::move(parts));
    const std::lock_guard<std::mutex> lock(mutex_);
    view_.swap(next);  // the old one goes when the lock is free again
  }

  detail::HeadBlock::Entry make_entry(KeyframeId id, const Graph& graph, const EntryInfo& info) {
    return detail::encoded_entry(id, graph, info, views_, *similarity_, scan_);
  }

  std::shared_ptr<const Similarity> similarity_;
  ViewSection views_;
  detail::NodeScan scan_;           ///< the writer's
  detail::PublishedPlaces places_;  ///< the writer's
  mutable std::mutex mutex_;
  std::shared_ptr<const View> view_;  ///< replaced under `mutex_`
};

/// The bag for the default similarity.
using IndexedBag = BasicIndexedBag<>;

#ifdef TOPOBAG_COMPILED  // in the library topobag::compiled
extern template class BasicIndexedBag<ClassPairDistanceHistogram>;
#endif

}  // namespace v0
}  // namespace topobag
