// SPDX-License-Identifier: MIT
#include <map>
#include <sstream>
#include <variant>

#include "bags.hpp"
#include "described_catalog.hpp"
#include "fields.hpp"
#include "rooms.hpp"
#include "similarities.hpp"

namespace python {
namespace {

using topobag::QueryOptions;
using Unlocked = py::call_guard<py::gil_scoped_release>;
using DefaultMap = MemoryMapBy<topobag::ClassPairDistanceHistogram>;
using AnySimilarityArgument =
    std::variant<std::monostate, std::shared_ptr<Similarity>, OwnSimilarity::Callable>;

std::shared_ptr<MemoryMap> memory_map(const AnySimilarityArgument& argument) {
  if (std::holds_alternative<std::monostate>(argument)) {
    return std::make_shared<DefaultMap>(DefaultMap::Bag{});
  }
  std::shared_ptr<const Similarity> similarity;
  if (const auto* known = std::get_if<std::shared_ptr<Similarity>>(&argument)) {
    similarity = *known;
    if (const auto pairs =
            std::dynamic_pointer_cast<const topobag::ClassPairDistanceHistogram>(similarity)) {
      return std::make_shared<DefaultMap>(DefaultMap::Bag(*pairs));
    }
  } else {
    similarity = std::make_shared<const OwnSimilarity>(std::get<OwnSimilarity::Callable>(argument));
  }
  using Bag = MemoryMapBy<AnySimilarity>::Bag;
  return std::make_shared<MemoryMapBy<AnySimilarity>>(Bag(AnySimilarity(similarity)));
}

Graph graph_at(const Map& map, KeyframeId id) {
  if (auto graph = map.view()->find(id)) return *std::move(graph);
  throw topobag::InvalidId("key frame " + std::to_string(topobag::value(id)) +
                           " is not in the bag");
}

void set_poses(Map& map, const std::map<KeyframeId, ArrayLike>& T_world_camera) {
  topobag::CameraPoses poses;
  for (const auto& [id, pose] : T_world_camera) {
    poses.emplace(id,
                  pose_of(pose, "key frame " + std::to_string(topobag::value(id)) + ": the pose"));
  }
  const py::gil_scoped_release unlocked;
  map.set_poses(poses);
}

EntryInfo info_from(const std::optional<double>& stamp, std::uint32_t session,
                    const std::optional<Eigen::Isometry3d>& T_world_camera, std::string label,
                    topobag::ImageDescriptor image) {
  return {stamp, session, T_world_camera, std::move(label), std::move(image)};
}

/// `Map::add` or `Map::update` with the info's members as arguments.
template <typename Change>
void define_change(py::class_<Map, std::shared_ptr<Map>>& type, const char* name, Change change,
                   const char* text) {
  type.def(
      name,
      [change](Map& map, KeyframeId id, const Graph& graph, const std::optional<double>& stamp,
               const std::optional<Eigen::Isometry3d>& T_world_camera, std::uint32_t session,
               std::string label, topobag::ImageDescriptor image) {
        (map.*change)(
            id, graph,
            info_from(stamp, session, T_world_camera, std::move(label), std::move(image)));
      },
      py::arg("id"), py::arg("graph"), py::kw_only(), py::arg("stamp") = py::none(),
      py::arg("T_world_camera") = py::none(), py::arg("session") = 0, py::arg("label") = "",
      py::arg_v("image", topobag::ImageDescriptor(), "ImageDescriptor()"), Unlocked(), text);
}

template <typename Bag>
Bag loaded(const std::string& path, const std::optional<ClassesArgument>& catalog) {
  return catalog ? topobag::load<Bag>(path, described(*catalog)) : topobag::load<Bag>(path);
}

py::bytes snapshot_of(const Map& map) {
  std::ostringstream stream;
  topobag::save(*map.view(), stream);
  return py::bytes(stream.str());
}

template <typename Bag>
Bag bag_of(const py::bytes& snapshot) {
  std::istringstream stream(static_cast<std::string>(snapshot));
  return topobag::load<Bag>(stream);
}

void bind_map(py::module_& module) {
  py::class_<Map, std::shared_ptr<Map>> map(
      module, "Bag",
      "What all bags have in common: one graph per key frame, asked for those that resemble a "
      "query. Any number of threads may read one while others change it.");
  define_change(map, "add", &Map::add, doc("BagOfTopologyGraphs.add"));
  define_change(map, "update", &Map::update, doc("BagOfTopologyGraphs.update"));
  map.def("erase", &Map::erase, py::arg("id"), Unlocked(), doc("BagOfTopologyGraphs.erase"))
      .def("set_poses", &set_poses, py::arg("T_world_camera"),
           "Moves key frames, as a back end does when it has closed a loop: a dict of 4 x 4 poses "
           "by id; the others stay. All of them, or nothing has changed: raises InvalidId for a "
           "key frame that is not in the bag, InvalidValue for a pose that is no rigid motion. No "
           "graph and no index is touched.")
      .def("merge", &Map::merge, py::arg("other"),
           py::arg_v("options", topobag::MergeOptions(), "MergeOptions()"), Unlocked(),
           doc("BagOfTopologyGraphs.merge"))
      .def(
          "query",
          [](const Map& bag, const Graph& graph, const QueryOptions& options) {
            return bag.view()->query(graph, options);
          },
          py::arg("graph"), py::arg_v("options", QueryOptions(), "QueryOptions()"), Unlocked(),
          doc("BagOfTopologyGraphs.query"))
      .def(
          "find", [](const Map& bag, KeyframeId id) { return bag.view()->find(id); }, py::arg("id"),
          Unlocked(), doc("BagOfTopologyGraphs.find"))
      .def(
          "info", [](const Map& bag, KeyframeId id) { return bag.view()->info(id); }, py::arg("id"),
          Unlocked(), doc("BagOfTopologyGraphs.info"))
      .def(
          "within",
          [](const Map& bag, const topobag::MapRegion& region) {
            return bag.view()->within(region);
          },
          py::arg("region"), Unlocked(), doc("BagOfTopologyGraphs.within"))
      .def(
          "after", [](const Map& bag, KeyframeId id) { return bag.view()->after(id); },
          py::arg("id"), Unlocked(), doc("BagReader.after"))
      .def(
          "before", [](const Map& bag, KeyframeId id) { return bag.view()->before(id); },
          py::arg("id"), Unlocked(), doc("BagReader.before"))
      .def_property_readonly(
          "places", [](const Map& bag) { return bag.view()->places(); },
          doc("BagOfTopologyGraphs.places"))
      .def_property_readonly(
          "appearance_kind", [](const Map& bag) { return bag.view()->appearance_kind(); },
          doc("BagOfTopologyGraphs.appearance_kind"))
      .def_property_readonly(
          "image_kind", [](const Map& bag) { return bag.view()->image_kind(); },
          doc("BagOfTopologyGraphs.image_kind"))
      .def(
          "save",
          [](const Map& bag, const std::string& path,
             const std::optional<ClassesArgument>& catalog) { bag.save(path, described(catalog)); },
          py::arg("path"), py::arg("catalog") = py::none(), Unlocked(),
          "Writes a snapshot, complete under its name or not at all. It keeps the `catalog` (a "
          "ClassCatalog, or a DescribedCatalog with what else is said of the classes), is read "
          "with no other classes, and tells them (`saved_catalog`).")
      .def(
          "__len__", [](const Map& bag) { return bag.view()->size(); }, Unlocked())
      .def("__iter__", [](const Map& bag) { return py::iter(py::cast(ids_of(*bag.view()))); })
      .def(
          "__contains__",
          [](const Map& bag, KeyframeId id) { return bag.view()->info(id).has_value(); },
          py::arg("id"), Unlocked())
      .def("__getitem__", &graph_at, py::arg("id"), Unlocked(),
           "The key frame's graph. Raises InvalidId.")
      .def("__repr__", [](const py::object& self) {
        return "<" + py::type::of(self).attr("__name__").cast<std::string>() + ": " +
               std::to_string(py::len(self)) + " key frames>";
      });
}

void bind_indexed(py::module_& module) {
  using Bag = topobag::IndexedBag;
  py::class_<IndexedMap, Map, std::shared_ptr<IndexedMap>>(module, "IndexedBag",
                                                           doc("BasicIndexedBag"))
      .def(py::init<>())
      .def_static(
          "load",
          [](const std::string& path, const std::optional<ClassesArgument>& catalog) {
            return std::make_shared<IndexedMap>(loaded<Bag>(path, catalog));
          },
          py::arg("path"), py::arg("catalog") = py::none(), Unlocked(), doc("load"))
      .def("compact", &IndexedMap::compact, Unlocked(), doc("BasicIndexedBag.compact"))
      .def("search", &IndexedMap::search, py::arg("graph"),
           py::arg_v("options", QueryOptions(), "QueryOptions()"),
           py::arg("max_visited") = std::numeric_limits<std::size_t>::max(), Unlocked(),
           doc("BasicBagView.search"))
      .def("memory_usage", &IndexedMap::memory_usage, doc("BasicBagView.memory_usage"))
      .def(py::pickle(
          [](const IndexedMap& map) { return snapshot_of(map); },
          [](const py::bytes& bytes) { return std::make_shared<IndexedMap>(bag_of<Bag>(bytes)); }));
}

void bind_sqlite(py::module_& module) {
  Fields<topobag::MapSession>(module, "MapSession")
      .field("id", &topobag::MapSession::id)
      .field("name", &topobag::MapSession::name);
  py::class_<SqliteMap, Map, std::shared_ptr<SqliteMap>>(module, "SqliteBag", doc("SqliteBag"))
      .def(py::init([](const std::string& path, bool read_only,
                       const std::optional<ClassesArgument>& catalog) {
             topobag::SqliteOptions options;
             options.read_only = read_only;
             options.catalog = described(catalog);
             return std::make_shared<SqliteMap>(path, std::move(options));
           }),
           py::arg("path"), py::arg("read_only") = false, py::arg("catalog") = py::none(),
           doc("SqliteBag.SqliteBag"))
      .def("begin_session", &SqliteMap::begin_session, py::arg("name"), Unlocked(),
           doc("SqliteBag.begin_session"))
      .def("sessions", &SqliteMap::sessions, Unlocked(), doc("SqliteBag.sessions"))
      .def_property_readonly("path", &SqliteMap::path, doc("SqliteBag.path"));
}

}  // namespace

void bind_bags(py::module_& module) {
  bind_map(module);
  using Bag = topobag::BagOfTopologyGraphs<>;
  py::class_<MemoryMap, Map, std::shared_ptr<MemoryMap>>(module, "BagOfTopologyGraphs",
                                                         doc("BagOfTopologyGraphs"))
      .def(py::init(&memory_map), py::arg("similarity") = py::none(),
           "`similarity`: one of the library's, or a callable (query, entry) -> number; "
           "ClassPairDistanceHistogram where it is left out.")
      .def_static(
          "load",
          [](const std::string& path, const std::optional<ClassesArgument>& catalog) {
            return std::shared_ptr<MemoryMap>(
                std::make_shared<DefaultMap>(loaded<Bag>(path, catalog)));
          },
          py::arg("path"), py::arg("catalog") = py::none(), Unlocked(), doc("load"))
      .def(py::pickle([](const MemoryMap& map) { return snapshot_of(map); },
                      [](const py::bytes& bytes) {
                        return std::shared_ptr<MemoryMap>(
                            std::make_shared<DefaultMap>(bag_of<Bag>(bytes)));
                      }));
  bind_indexed(module);
  bind_sqlite(module);
}

}  // namespace python
