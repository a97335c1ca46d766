// SPDX-License-Identifier: MIT
#include <topobag/evaluation/place_truth.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/evaluation/precision_recall.hpp>
#include <topobag/evaluation/protocol_text.hpp>
#include <topobag/evaluation/recall_at_k.hpp>

#include "fields.hpp"
#include "rooms.hpp"
#include "trajectory_array.hpp"

namespace python {
namespace {

using namespace topobag;

PlaceTruth truth_from(const std::string& protocol, const TrajectoryArray& queries,
                      const std::optional<TrajectoryArray>& map) {
  const PlaceProtocol parsed = parse_protocol(protocol);
  return map ? PlaceTruth(parsed, queries.poses, map->poses) : PlaceTruth(parsed, queries.poses);
}

LabelledScores labelled(const ArrayLike& scores, const PlaceTruth& truth) {
  const auto given = numbers(scores, "scores", {any, any});
  const auto entry = given.unchecked<2>();
  ScoreMatrix matrix(given.shape(0), given.shape(1));
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    for (py::ssize_t k = 0; k < given.shape(1); ++k) matrix(i, k) = entry(i, k);
  }
  return label_scores(matrix, truth);
}

/// Thresholds, precisions and recalls of a curve, falling thresholds.
py::tuple curve_of(const LabelledScores& scores) {
  std::vector<double> thresholds, precisions, recalls;
  for (const OperatingPoint& point : precision_recall_curve(scores)) {
    thresholds.push_back(point.threshold);
    precisions.push_back(point.precision());
    recalls.push_back(point.recall());
  }
  return py::make_tuple(array_from(precisions), array_from(recalls), array_from(thresholds));
}

void bind_truth(py::module_& module) {
  py::enum_<PairRelation>(module, "PairRelation", doc("PairRelation"))
      .value("positive", PairRelation::positive, doc("PairRelation.positive"))
      .value("negative", PairRelation::negative, doc("PairRelation.negative"))
      .value("ignored", PairRelation::ignored, doc("PairRelation.ignored"))
      .value("excluded", PairRelation::excluded, doc("PairRelation.excluded"));
  py::class_<PlaceTruth>(module, "PlaceTruth", doc("BasicPlaceTruth"))
      .def(py::init(&truth_from), py::arg("protocol"), py::arg("queries"),
           py::arg("map") = py::none(),
           "`protocol` as in the program, such as 'distance=0.5,angle=30'. Without `map`: loops "
           "within one trajectory.")
      .def_property_readonly(
          "protocol", [](const PlaceTruth& truth) { return to_string(truth.protocol()); },
          "As a text.")
      .def_property_readonly(
          "shape",
          [](const PlaceTruth& truth) {
            return py::make_tuple(truth.num_queries(), truth.num_candidates());
          },
          "Queries and candidates.")
      .def(
          "relation",
          [](const PlaceTruth& truth, std::size_t query, std::size_t candidate) {
            return truth.relation(query, candidate);
          },
          py::arg("query"), py::arg("candidate"), doc("BasicPlaceTruth.relation"));
}

}  // namespace

void bind_evaluation(py::module_& module) {
  bind_truth(module);
  py::class_<LabelledScores>(module, "LabelledScores", doc("LabelledScores"))
      .def("__len__", [](const LabelledScores& scores) { return scores.scores.size(); });
  module.def("label_scores", &labelled, py::arg("scores"), py::arg("truth"), doc("label_scores"));
  module.def("single_best", &single_best, py::arg("labelled"), doc("single_best"));
  module.def("precision_recall_curve", &curve_of, py::arg("labelled"),
             "Precisions, recalls and thresholds, a point per distinct score, falling; empty "
             "without a positive pair.");
  py::class_<RetrievalMetrics> metrics(module, "RetrievalMetrics", doc("RetrievalMetrics"));
  Attributes(metrics, "RetrievalMetrics")
      .attribute("average_precision", &RetrievalMetrics::average_precision)
      .attribute("auc_pr", &RetrievalMetrics::auc_pr)
      .attribute("recall_at_100p", &RetrievalMetrics::recall_at_100p)
      .attribute("lowest_recall_p", &RetrievalMetrics::lowest_recall_p)
      .attribute("extended_precision", &RetrievalMetrics::extended_precision)
      .attribute("f1_max", &RetrievalMetrics::f1_max)
      .attribute("f1_max_threshold", &RetrievalMetrics::f1_max_threshold)
      .attribute("precision_at_100r", &RetrievalMetrics::precision_at_100r)
      .attribute("roc_auc", &RetrievalMetrics::roc_auc);
  module.def(
      "retrieval_metrics", [](const LabelledScores& scores) { return retrieval_metrics(scores); },
      py::arg("labelled"), doc("retrieval_metrics"));
  py::class_<RecallAtK> recall(module, "RecallAtK", doc("RecallAtK"));
  Attributes(recall, "RecallAtK")
      .attribute("hits", &RecallAtK::hits)
      .attribute("queries_with_positive", &RecallAtK::queries_with_positive)
      .attribute("queries", &RecallAtK::queries)
      .attribute("of_queries_with_positive", &RecallAtK::of_queries_with_positive)
      .attribute("of_all_queries", &RecallAtK::of_all_queries);
  module.def("recall_at_k", &recall_at_k, py::arg("labelled"), py::arg("k"), doc("recall_at_k"));
  module.def(
      "pose_error",
      [](const Eigen::Isometry3d& T_true, const Eigen::Isometry3d& T_estimate) {
        const PoseError error = pose_error(T_true, T_estimate);
        return std::make_pair(error.translation_m, error.rotation_deg);
      },
      py::arg("T_true"), py::arg("T_estimate"),
      "Of E = inverse(T_true) T_estimate: translation, m, and rotation, degrees in [0, 180].");
}

}  // namespace python
