// SPDX-License-Identifier: MIT
#pragma once

#include <shared_mutex>

#include <topobag/error.hpp>

#include "map.hpp"

namespace python {

/// Keeps writers out while it lives, and knows how many of its kind a thread holds.
class ReadLock {
 public:
  explicit ReadLock(std::shared_mutex& mutex) : lock_(mutex) { ++held(); }
  ReadLock(const ReadLock&) = delete;
  ReadLock& operator=(const ReadLock&) = delete;
  ~ReadLock() { --held(); }

  /// Of the present thread.
  static int& held() {
    static thread_local int count = 0;
    return count;
  }

 private:
  std::shared_lock<std::shared_mutex> lock_;
};

/// Keeps everybody else out. Throws Error in a thread that reads: it would wait for itself.
class WriteLock {
 public:
  explicit WriteLock(std::shared_mutex& mutex) {
    if (ReadLock::held() > 0) {
      throw topobag::Error(
          "a filter or a similarity may not change a bag: the query that called it reads one");
    }
    lock_ = std::unique_lock<std::shared_mutex>(mutex);
  }

 private:
  std::unique_lock<std::shared_mutex> lock_;
};

/// A `BagOfTopologyGraphs`, whose readers wait while it is changed, as a view.
template <typename Bag>
class LockedView : public MapView {
 public:
  LockedView(const Bag& bag, std::shared_mutex& mutex) : lock_(mutex), bag_(bag) {}

  std::vector<topobag::Candidate> query(const Graph& graph,
                                        const topobag::QueryOptions& options) const override {
    return bag_.query(graph, options);
  }
  std::shared_ptr<const Graph> peek(KeyframeId id) const override {
    return {std::shared_ptr<const Graph>(), bag_.peek(id)};  // the bag owns it
  }
  std::optional<EntryInfo> info(KeyframeId id) const override { return bag_.info(id); }
  std::optional<KeyframeId> after(KeyframeId id) const override { return bag_.after(id); }
  std::optional<KeyframeId> before(KeyframeId id) const override { return bag_.before(id); }
  topobag::AppearanceKind appearance_kind() const override { return bag_.appearance_kind(); }
  topobag::ImageKind image_kind() const override { return bag_.image_kind(); }
  std::vector<KeyframeId> within(const topobag::MapRegion& region) const override {
    return bag_.within(region);
  }
  std::size_t size() const override { return bag_.size(); }
  std::size_t places() const override { return bag_.places(); }
  std::size_t places_holding(const topobag::ClassCounts& objects,
                             const topobag::ClassGroups& groups) const override {
    return bag_.places_holding(objects, groups);
  }
  void for_each(const Visit& visit) const override { bag_.for_each(visit); }

 private:
  ReadLock lock_;
  const Bag& bag_;
};

}  // namespace python
