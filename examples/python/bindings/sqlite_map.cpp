// SPDX-License-Identifier: MIT
#include "bags.hpp"

namespace python {

std::shared_ptr<const MapView> SqliteMap::view() const {
  return std::make_shared<LockedView<topobag::BagOfTopologyGraphs<>>>(bag_.bag(), mutex_);
}
void SqliteMap::add(KeyframeId id, const Graph& graph, const EntryInfo& info) {
  const WriteLock lock(mutex_);
  bag_.add(id, graph, info);
}
void SqliteMap::update(KeyframeId id, const Graph& graph, const EntryInfo& info) {
  const WriteLock lock(mutex_);
  bag_.update(id, graph, info);
}
bool SqliteMap::erase(KeyframeId id) {
  const WriteLock lock(mutex_);
  return bag_.erase(id);
}
void SqliteMap::set_poses(const topobag::CameraPoses& T_world_camera) {
  const WriteLock lock(mutex_);
  bag_.set_poses(T_world_camera);
}
NewIds SqliteMap::merge(const Map& other, const topobag::MergeOptions& options) {
  const MapEntries theirs(other);
  const WriteLock lock(mutex_);
  return bag_.merge(theirs, options);
}
void SqliteMap::save(const std::string& path, const Classes& classes) const {
  save_view(*view(), path, classes);
}
std::uint32_t SqliteMap::begin_session(const std::string& name) {
  const WriteLock lock(mutex_);
  return bag_.begin_session(name);
}
std::vector<topobag::MapSession> SqliteMap::sessions() const {
  const WriteLock lock(mutex_);  // one statement at a time
  return bag_.sessions();
}

}  // namespace python
