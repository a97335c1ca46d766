// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/version.hpp>

/// Forward declarations of the types that cross an interface.
namespace topobag {
inline namespace v0 {

struct BoundingBox;
struct Detection;
class ClassCatalog;
template <typename Scalar>
struct SemanticNode;
template <typename Scalar>
struct PinholeCamera;
template <typename Pixel>
class DepthView;
class DepthGrid;
struct Edge;
template <typename Scalar>
struct View;
template <typename Scalar>
struct Gravity;
template <typename Scalar>
class TopologyGraph;
struct KeyframeSighting;
template <typename Scalar>
class LocalGraph;
class ClassConfusion;
struct RelativePose;
struct GraphMatch;
struct EntryInfo;
struct QueryOptions;
template <typename Graph, typename Similarity>
class BagOfTopologyGraphs;
struct ClassPairDistanceHistogram;
template <typename Similarity>
class BasicBagView;
/// The view of an `IndexedBag`.
using BagView = BasicBagView<ClassPairDistanceHistogram>;
template <typename Similarity>
class BasicIndexedBag;
/// The bag for the default similarity.
using IndexedBag = BasicIndexedBag<ClassPairDistanceHistogram>;
struct Recognition;
class Calibration;
struct Explanation;
template <typename Bag>
class Relocalizer;
template <typename Bag>
class LoopDetector;

}  // namespace v0
}  // namespace topobag
