// SPDX-License-Identifier: MIT
#include <topobag/matching/consistency_similarity.hpp>
#include <topobag/similarity/affinity_cosine.hpp>
#include <topobag/similarity/class_histogram.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>
#include <topobag/similarity/class_triangles.hpp>
#include <topobag/similarity/label_walks.hpp>
#include <topobag/similarity/padded_cosine.hpp>
#include <topobag/similarity/semantic_subgraph.hpp>
#include <topobag/similarity/surrounding_labels.hpp>
#include <topobag/similarity/weisfeiler_lehman.hpp>

#include "fields.hpp"
#include "rooms.hpp"
#include "similarities.hpp"

namespace python {
namespace {

using Graphs = std::vector<const Graph*>;

/// Throws InvalidValue where one is None.
const Graphs& present(const Graphs& graphs) {
  for (std::size_t i = 0; i < graphs.size(); ++i) {
    if (!graphs[i]) throw topobag::InvalidValue("graph " + std::to_string(i) + " is None", i);
  }
  return graphs;
}

/// A matrix as an array, by copy.
py::array_t<double> array_of_scores(const topobag::ScoreMatrix& scores) {
  return py::array_t<double>({scores.rows(), scores.cols()}, scores.data());
}

py::array_t<double> score_matrix(const Similarity& similarity, const Graphs& queries,
                                 const Graphs& map) {
  topobag::ScoreMatrix scores;
  {
    const py::gil_scoped_release unlocked;
    scores = similarity.matrix(present(queries), present(map));
  }
  return array_of_scores(scores);
}

template <typename S>
auto bind_one(py::module_& module, const char* name) {
  return Fields<SimilarityOf<S>, Similarity, std::shared_ptr<SimilarityOf<S>>>(module, name);
}

void bind_enums(py::module_& module) {
  using topobag::HistogramMeasure;
  using topobag::RowOrder;
  using topobag::Surroundings;
  py::enum_<RowOrder>(module, "RowOrder", doc("RowOrder"))
      .value("detection", RowOrder::detection)
      .value("class_then_position", RowOrder::class_then_position)
      .value("assignment", RowOrder::assignment);
  py::enum_<HistogramMeasure>(module, "HistogramMeasure", doc("HistogramMeasure"))
      .value("cosine", HistogramMeasure::cosine)
      .value("jaccard", HistogramMeasure::jaccard);
  py::enum_<Surroundings>(module, "Surroundings", doc("Surroundings"))
      .value("neighbors", Surroundings::neighbors)
      .value("neighbor_pairs", Surroundings::neighbor_pairs);
}

}  // namespace

void bind_similarity(py::module_& module) {
  bind_enums(module);
  using topobag::ClassWeights;
  py::class_<ClassWeights>(module, "ClassWeights", doc("ClassWeights"))
      .def(py::init<>())
      .def_static(
          "idf",
          [](const Graphs& background) {
            std::vector<Graph> graphs;
            for (const Graph* graph : present(background)) graphs.push_back(*graph);
            return ClassWeights::idf(graphs);
          },
          py::arg("background"), doc("ClassWeights.idf"))
      .def("__call__", &ClassWeights::operator(), py::arg("label"), "The weight of a class.");
  py::class_<Similarity, std::shared_ptr<Similarity>>(
      module, "Similarity", "How alike two graphs are: a callable (p, q) -> number in [0, 1].")
      .def("__call__", &Similarity::operator(), py::arg("p"), py::arg("q"),
           py::call_guard<py::gil_scoped_release>(), "In [0, 1].")
      .def("matrix", &score_matrix, py::arg("queries"), py::arg("map"),
           "Of every pair: a row per query, a column per graph of the map. What can be worked out "
           "of one graph is worked out once.");
  using namespace topobag;
  bind_one<PaddedCosine>(module, "PaddedCosine")
      .field("row_order", &SimilarityOf<PaddedCosine>::row_order)
      .field("depth_scale", &SimilarityOf<PaddedCosine>::depth_scale);
  bind_one<AffinityCosine>(module, "AffinityCosine")
      .field("sigma", &SimilarityOf<AffinityCosine>::sigma)
      .field("weights", &SimilarityOf<AffinityCosine>::weights);
  bind_one<ClassHistogram>(module, "ClassHistogram")
      .field("measure", &SimilarityOf<ClassHistogram>::measure)
      .field("weights", &SimilarityOf<ClassHistogram>::weights);
  using Pairs = SimilarityOf<ClassPairDistanceHistogram>;
  bind_one<ClassPairDistanceHistogram>(module, "ClassPairDistanceHistogram")
      .field("bin_width", &Pairs::bin_width)
      .field("max_distance", &Pairs::max_distance)
      .field("class_vote", &Pairs::class_vote)
      .field("size_vote", &Pairs::size_vote)
      .field("size_bin", &Pairs::size_bin)
      .field("weights", &Pairs::weights);
  bind_one<ClassTriangles>(module, "ClassTriangles")
      .field("bin_width", &SimilarityOf<ClassTriangles>::bin_width)
      .field("max_distance", &SimilarityOf<ClassTriangles>::max_distance)
      .field("class_vote", &SimilarityOf<ClassTriangles>::class_vote);
  bind_one<LabelWalks>(module, "LabelWalks")
      .field("length", &SimilarityOf<LabelWalks>::length)
      .field("weights", &SimilarityOf<LabelWalks>::weights);
  bind_one<SurroundingLabels>(module, "SurroundingLabels")
      .field("counted", &SimilarityOf<SurroundingLabels>::counted)
      .field("weights", &SimilarityOf<SurroundingLabels>::weights);
  bind_one<WeisfeilerLehman>(module, "WeisfeilerLehman")
      .field("iterations", &SimilarityOf<WeisfeilerLehman>::iterations);
  bind_one<SemanticSubgraph>(module, "SemanticSubgraph")
      .field("bin_width", &SimilarityOf<SemanticSubgraph>::bin_width)
      .field("max_distance", &SimilarityOf<SemanticSubgraph>::max_distance);
  bind_one<ConsistencySimilarity>(module, "ConsistencySimilarity")
      .field("sigma", &SimilarityOf<ConsistencySimilarity>::sigma);
}

}  // namespace python
