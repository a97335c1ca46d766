// SPDX-License-Identifier: MIT
// The models of examples/docs/concepts.md, and every valid expression that the page claims.
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/adaptors/topology_thread.hpp>
#include <topobag/bag/build_indexed_bag.hpp>
#include <topobag/bag/snapshot.hpp>
#include <topobag/edges/complete_edges.hpp>
#include <topobag/edges/radius_edges.hpp>
#include <topobag/recognition/calibrate.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/temporal_consistency.hpp>
#include <topobag/sensing/disparity_depth.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/range_detections.hpp>
#include <topobag/sensing/sparse_depth.hpp>
#ifdef TOPOBAG_HAS_SQLITE
#include <topobag/adaptors/sqlite.hpp>

#include "scratch_folder.hpp"
#endif
#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

// ---- Detection
// -----------------------------------------------------------------------------------

namespace {

struct MyBox {
  float left, top, right, bottom;  // px
  int name;
  float score;
};

struct MyObject {
  MyBox box;
  double metres;
};

}  // namespace

template <>
struct topobag::detection_traits<MyBox> {
  static BoundingBox box(const MyBox& b) { return {b.left, b.top, b.right, b.bottom}; }
  static ClassId label(const MyBox& b) { return ClassId{b.name}; }
  static double confidence(const MyBox& b) { return b.score; }
};

template <>
struct topobag::detection_traits<MyObject> {
  static BoundingBox box(const MyObject& o) { return detection_traits<MyBox>::box(o.box); }
  static ClassId label(const MyObject& o) { return detection_traits<MyBox>::label(o.box); }
  static double confidence(const MyObject& o) { return o.box.score; }
  static std::optional<double> depth(const MyObject& o) { return o.metres; }
};

namespace {

static_assert(is_detection_v<MyBox> && !is_ranged_detection_v<MyBox>);
static_assert(is_detection_v<MyObject> && is_ranged_detection_v<MyObject>);
static_assert(is_detection_v<Detection> && is_ranged_detection_v<RangedDetection>);
static_assert(!is_detection_v<int>);

// ---- Depth
// ---------------------------------------------------------------------------------------

struct Wall {
  double metres;
  std::optional<double> operator()(const Eigen::Vector2d&) const { return metres; }
};

struct LowestPixel {
  template <typename Depth>
  std::optional<double> operator()(const Depth& depth, const BoundingBox& box) const {
    return depth(Eigen::Vector2d(box.center().x(), box.y2));
  }
};

static_assert(is_depth_source_v<Wall>);
static_assert(is_depth_source_v<DepthView<float>> && is_depth_source_v<DepthView<std::uint16_t>>);
static_assert(is_depth_source_v<DisparityDepth<Wall>> && is_depth_source_v<SparseDepth> &&
              is_depth_source_v<DepthGrid>);
static_assert(!is_depth_source_v<double>);

static_assert(is_depth_sampling_v<LowestPixel, Wall> && is_depth_sampling_v<RobustBoxDepth, Wall> &&
              is_depth_sampling_v<CenterDepth, Wall> &&
              is_depth_sampling_v<SparseBoxDepth, SparseDepth>);
static_assert(!is_depth_sampling_v<SparseBoxDepth, Wall> && !is_depth_sampling_v<Wall, Wall>);

// ---- Edges and similarities
// ----------------------------------------------------------------------

struct Chain {
  template <typename Scalar>
  EdgeList operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    EdgeList edges;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      edges.push_back(make_edge(node_index(i - 1), node_index(i)));
    }
    return edges;
  }
};

static_assert(is_edge_builder_v<Chain, double> && is_edge_builder_v<Chain, float>);
static_assert(is_edge_builder_v<CompleteEdges, double> && is_edge_builder_v<KnnEdges, double> &&
              is_edge_builder_v<RadiusEdges, double>);

struct NodeCount {
  std::size_t descriptor(const TopologyGraph<>& graph) const { return graph.size(); }
  double similarity(std::size_t n, std::size_t k) const {
    if (n == 0 || k == 0) return 0.0;
    return static_cast<double>(std::min(n, k)) / static_cast<double>(std::max(n, k));
  }
  double operator()(const TopologyGraph<>& p, const TopologyGraph<>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }
};

static_assert(is_similarity_v<NodeCount, TopologyGraph<>>);
static_assert(has_descriptor_v<NodeCount, TopologyGraph<>>);
static_assert(std::is_same_v<descriptor_t<NodeCount, TopologyGraph<>>, std::size_t>);

/// A graph of one's own in `BagOfTopologyGraphs`.
using Sentence = std::string;
struct SameLength {
  double operator()(const Sentence& p, const Sentence& q) const { return p.size() == q.size(); }
};
static_assert(is_similarity_v<SameLength, Sentence> && !has_descriptor_v<SameLength, Sentence>);

// ---- Bags
// ----------------------------------------------------------------------------------------

class ListBag {
 public:
  using Graph = TopologyGraph<>;

  std::vector<Candidate> query(const Graph& graph, const QueryOptions& options = {}) const {
    std::vector<Candidate> found;
    for (const auto& [id, entry] : entries_) {
      const double score = NodeCount{}(graph, entry.first);
      if (options.admits(id, entry.second) && score >= options.min_similarity) {
        found.push_back({id, score});
      }
    }
    std::sort(found.begin(), found.end());
    found.resize(std::min(found.size(), options.max_results));
    return found;
  }
  std::optional<Graph> find(KeyframeId id) const {
    if (!contains(id)) return std::nullopt;
    return entries_.at(id).first;
  }
  std::optional<EntryInfo> info(KeyframeId id) const {
    if (!contains(id)) return std::nullopt;
    return entries_.at(id).second;
  }

  void add(KeyframeId id, Graph graph, EntryInfo info = {}) {
    if (contains(id)) throw InvalidId("it is there already");
    entries_.emplace(id, std::make_pair(std::move(graph), std::move(info)));
  }

  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (const auto& [id, entry] : entries_) visit(id, entry.second, entry.first);
  }

  bool contains(KeyframeId id) const { return entries_.count(id) != 0; }
  void update(KeyframeId id, Graph graph, EntryInfo info = {}) {
    entries_.at(id) = {std::move(graph), std::move(info)};
  }
  bool erase(KeyframeId id) { return entries_.erase(id) != 0; }

 private:
  std::map<KeyframeId, std::pair<Graph, EntryInfo>> entries_;
};

/// One that others read while it changes: it hands out a view.
class SharedBag {
 public:
  using Graph = TopologyGraph<>;
  std::shared_ptr<const ListBag> view() const { return view_; }
  void add(KeyframeId id, Graph graph, EntryInfo info = {}) {
    auto next = std::make_shared<ListBag>(*view_);
    next->add(id, std::move(graph), std::move(info));
    view_ = std::move(next);
  }
  std::optional<EntryInfo> info(KeyframeId id) const { return view_->info(id); }

 private:
  std::shared_ptr<const ListBag> view_ = std::make_shared<ListBag>();
};

static_assert(is_searchable_bag_v<ListBag> && !is_searchable_bag_v<SharedBag>);
static_assert(is_growing_bag_v<ListBag> && is_growing_bag_v<SharedBag>);
static_assert(is_stored_bag_v<ListBag> && !is_stored_bag_v<SharedBag>);
static_assert(is_durable_bag_v<ListBag> && !is_durable_bag_v<SharedBag>);

// ---- A host
// --------------------------------------------------------------------------------------

struct HostMap {
  bool IsBad() { return false; }
};

struct HostPose {
  std::array<float, 16> numbers{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  template <typename T>
  T at(int row, int column) const {
    return numbers[static_cast<std::size_t>(4 * row + column)];
  }
};

struct HostKeyFrame {
  unsigned long mnId = 0;
  double mTimeStamp = 0.0;
  bool isBad() { return false; }
  HostPose GetPoseInverse() { return {}; }
  std::set<HostKeyFrame*> GetConnectedKeyFrames() { return {}; }
};

struct HostFrame {};

/// Of a host with several maps, whose poses have a `matrix()`.
struct MultiMapKeyFrame {
  unsigned long mnId = 0;
  double mTimeStamp = 0.0;
  HostMap* map = nullptr;
  bool isBad() { return false; }
  Eigen::Isometry3f GetPoseInverse() { return Eigen::Isometry3f::Identity(); }
  std::set<MultiMapKeyFrame*> GetConnectedKeyFrames() { return {}; }
  HostMap* GetMap() { return map; }
};

static_assert(!has_maps_v<HostKeyFrame> && has_maps_v<MultiMapKeyFrame>);
static_assert(is_host_key_frame_v<HostKeyFrame> && is_host_key_frame_v<MultiMapKeyFrame>);
static_assert(is_host_pose_v<HostPose> && is_host_pose_v<Eigen::Isometry3f>);

}  // namespace

template class topobag::OrbSlamDatabase<MultiMapKeyFrame, HostFrame, HostMap>;

// ---- What the page says
// --------------------------------------------------------------------------

namespace {

const PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, 640, 480};

/// Ten nodes of one room, and of a random other one for another seed.
TopologyGraph<> room(unsigned seed = 1) {
  std::mt19937 random(seed);
  return random_graph(random, 10, 5);
}

}  // namespace

TEST_CASE("concepts: a detection, a depth source, a sampling policy", "[docs]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  const std::vector<MyBox> boxes{{100.0F, 100.0F, 200.0F, 180.0F, 62, 0.9F}};
  const Wall wall{2.0};
  const auto lifted = lift_detections(boxes, wall, camera, catalog, LiftOptions{}, LowestPixel{});
  REQUIRE(lifted.nodes.size() == 1);
  CHECK(lifted.nodes[0].position->z() == 2.0);
  CHECK(range_detections(boxes, wall, camera, CenterDepth{}).at(0).z == 2.0);

  const std::vector<MyObject> objects{{boxes[0], 3.0}, {boxes[0], 0.0}};
  const auto ranged = lift_detections(objects, camera, catalog);
  REQUIRE(ranged.nodes.size() == 1);
  CHECK(ranged.nodes[0].z == 3.0);
  CHECK(ranged.dropped.out_of_range == 1);
  CHECK(DisparityDepth<Wall>({10.0}, 500.0, 0.1)(Eigen::Vector2d(0.0, 0.0)) == Approx(5.0));
}

TEST_CASE("concepts: an edge builder and a similarity", "[docs]") {
  const TopologyGraph<> graph = make_topology_graph(room().nodes(), Chain{});
  CHECK(graph.edges().size() == 9);
  CHECK(LocalGraph<>().graph(Chain{}).empty());

  BagOfTopologyGraphs<TopologyGraph<>, NodeCount> bag{NodeCount{}};
  bag.add(KeyframeId{1}, graph);
  CHECK(bag.query(room(2)).at(0).similarity == 1.0);

  BagOfTopologyGraphs<Sentence, SameLength> sentences;
  sentences.add(KeyframeId{1}, "two words");
  CHECK(sentences.query("twowords!").at(0).similarity == 1.0);
}

TEMPLATE_TEST_CASE("concepts: a bag to look up in, and one to add to", "[docs]", ListBag,
                   SharedBag) {
  Relocalizer<TestType> relocalizer;
  relocalizer.map().add(KeyframeId{7}, room(), {1.0, 0, Eigen::Isometry3d::Identity(), ""});
  const Recognition found = relocalizer.localize(room());
  REQUIRE(found);
  CHECK(found.accepted->id == KeyframeId{7});
  CHECK(relocalizer.T_world_query(found)->T.isApprox(Eigen::Isometry3d::Identity(), 1e-6));

  LoopDetector<TestType> loops;
  loops.detect_and_add(KeyframeId{1}, 0.0, room());
  CHECK(loops.detect_and_add(KeyframeId{2}, 60.0, room()));
}

TEST_CASE("concepts: a bag to explain, calibrate, save and rebuild", "[docs]") {
  Relocalizer<ListBag> relocalizer;
  relocalizer.map().add(KeyframeId{7}, room());
  const Recognition found = relocalizer.localize(room());
  CHECK(explain(found, relocalizer.map(), room(), ClassCatalog::coco80(), relocalizer.options())
            .usable);
  const OtherPlaces never = [](KeyframeId, KeyframeId) { return false; };
  CalibrateOptions few;
  few.null_queries = 2;
  CHECK(calibrate(relocalizer, {KeyframeId{7}}, never, few).queries() == 2);

  std::stringstream file;
  save(relocalizer.map(), file);
  CHECK(load<ListBag>(file).contains(KeyframeId{7}));
  CHECK(build_indexed_bag(relocalizer.map()).size() == 1);
}

#ifdef TOPOBAG_HAS_SQLITE
TEST_CASE("concepts: a durable bag", "[docs]") {
  const ScratchFolder folder;
  SqliteBag<ListBag> map(folder.path("map.db"));
  map.add(KeyframeId{1}, room());
  map.update(KeyframeId{1}, room(2));
  CHECK(map.contains(KeyframeId{1}));
  CHECK(map.erase(KeyframeId{1}));
}
#endif

TEST_CASE("concepts: a detector on a thread of its own", "[docs]") {
  std::size_t seen = 0;
  TopologyThread<std::string> thread([&](const std::string& image) { seen = image.size(); }, {},
                                     [](const std::string&, const std::string&) {});
  CHECK(thread.push("image"));
  thread.wait_idle();
  CHECK(seen == 5);
}

TEST_CASE("concepts: a host", "[docs]") {
  OrbSlamDatabase<HostKeyFrame, HostFrame, HostMap> database(
      {}, [](const HostFrame&) { return std::optional(room()); });
  HostKeyFrame key_frame;
  database.observe(database.epoch(), key_frame.mnId, {0.0, room().nodes(), {}});
  database.add(&key_frame);
  HostFrame lost;
  CHECK(database.DetectRelocalizationCandidates(&lost) == std::vector<HostKeyFrame*>{&key_frame});
  CHECK(database.DetectLoopCandidates(&key_frame, 0.0F).empty());
  database.erase(&key_frame);
  CHECK(database.size() == 0);
  CHECK(host_pose(HostPose{}).isApprox(host_pose(Eigen::Isometry3f::Identity())));
}

TEST_CASE("concepts: the small callables", "[docs]") {
  QueryOptions options;
  options.filter = [](KeyframeId id, const EntryInfo& info) {
    return info.session == 0 && id != KeyframeId{7};
  };
  CHECK_FALSE(options.admits(KeyframeId{7}, {}));
  const TemporalConsistency::SamePlace neighbors = [](KeyframeId a, KeyframeId b) {
    return value(a) + 1 == value(b);
  };
  CHECK(TemporalConsistency({}, neighbors).matches() == 0);
}
