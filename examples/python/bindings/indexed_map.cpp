// SPDX-License-Identifier: MIT
#include "bags.hpp"

namespace python {
namespace {

/// The bag at one moment.
class IndexedView : public MapView {
 public:
  explicit IndexedView(std::shared_ptr<const topobag::BagView> view) : view_(std::move(view)) {}

  std::vector<topobag::Candidate> query(const Graph& graph,
                                        const topobag::QueryOptions& options) const override {
    return view_->query(graph, options);
  }
  std::shared_ptr<const Graph> peek(KeyframeId id) const override {
    auto graph = view_->find(id);
    return graph ? std::make_shared<const Graph>(*std::move(graph)) : nullptr;
  }
  std::optional<EntryInfo> info(KeyframeId id) const override { return view_->info(id); }
  std::optional<KeyframeId> after(KeyframeId id) const override { return view_->after(id); }
  std::optional<KeyframeId> before(KeyframeId id) const override { return view_->before(id); }
  topobag::AppearanceKind appearance_kind() const override { return view_->appearance_kind(); }
  topobag::ImageKind image_kind() const override { return view_->image_kind(); }
  std::vector<KeyframeId> within(const topobag::MapRegion& region) const override {
    return view_->within(region);
  }
  std::size_t size() const override { return view_->size(); }
  std::size_t places() const override { return view_->places(); }
  std::size_t places_holding(const topobag::ClassCounts& objects,
                             const topobag::ClassGroups& groups) const override {
    return view_->places_holding(objects, groups);
  }
  void for_each(const Visit& visit) const override { view_->for_each(visit); }

 private:
  std::shared_ptr<const topobag::BagView> view_;
};

}  // namespace

std::shared_ptr<const MapView> IndexedMap::view() const {
  return std::make_shared<IndexedView>(bag_.view());
}
void IndexedMap::add(KeyframeId id, const Graph& graph, const EntryInfo& info) {
  const std::lock_guard<std::mutex> lock(writing_);
  bag_.add(id, graph, info);
}
void IndexedMap::update(KeyframeId id, const Graph& graph, const EntryInfo& info) {
  const std::lock_guard<std::mutex> lock(writing_);
  bag_.update(id, graph, info);
}
bool IndexedMap::erase(KeyframeId id) {
  const std::lock_guard<std::mutex> lock(writing_);
  return bag_.erase(id);
}
void IndexedMap::save(const std::string& path, const Classes& classes) const {
  save_view(*view(), path, classes);
}
void IndexedMap::set_poses(const topobag::CameraPoses& T_world_camera) {
  const std::lock_guard<std::mutex> lock(writing_);
  bag_.set_poses(T_world_camera);
}
NewIds IndexedMap::merge(const Map& other, const topobag::MergeOptions& options) {
  if (const auto* const indexed = dynamic_cast<const IndexedMap*>(&other)) {
    const auto theirs = indexed->bag_.view();  // no graph is decoded
    const std::lock_guard<std::mutex> lock(writing_);
    return bag_.merge(*theirs, options);
  }
  const MapEntries theirs(other);
  const std::lock_guard<std::mutex> lock(writing_);
  return bag_.merge(theirs, options);
}
void IndexedMap::compact() {
  const std::lock_guard<std::mutex> lock(writing_);
  bag_.compact();
}

}  // namespace python
