// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/recognition/changes.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/verdict.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// One thing that was asked of a candidate.
struct ExplainedStage {
  std::string name;      ///< of the stage
  bool passed = false;   ///< whether the candidate did
  double value = 0.0;    ///< what the candidate has
  double asked = 0.0;    ///< what it should have
  bool at_least = true;  ///< whether it should have so much at least, or at most
  std::string unit{};    ///< of both

  /// By how much the threshold was missed, in `unit`; not positive when it was reached.
  double missed_by() const noexcept { return at_least ? asked - value : value - asked; }
};

/// Two objects taken for one.
struct ExplainedMatch {
  NodeIndex candidate{};        ///< node of the candidate graph
  NodeIndex query{};            ///< node of the query graph
  std::string candidate_class;  ///< class of the candidate's node
  std::string query_class;      ///< class of the query's node
  double distance = 0.0;        ///< under the pose, m
  double deviations = 0.0;      ///< the same in standard deviations
  std::optional<double> looks;  ///< log10 odds of what they look like; nothing where not known
};

/// An object that was expected and is missing.
struct ExplainedMissing {
  NodeIndex node{};          ///< in its own graph
  bool of_candidate = true;  ///< whether the candidate holds it, or the query
  std::string class_name;    ///< name of the object's class
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the candidate's frame, m
  std::size_t views = 0;           ///< cameras of the other graph that should have shown it
  std::size_t measured_views = 0;  ///< of those, the ones whose measured depth says so
  double cost = 0.0;               ///< what the score loses
};

/// What changed, with the class by name.
struct ExplainedChange {
  ObjectChange change;     ///< the change itself
  std::string class_name;  ///< name of the object's class
};

/// The scale that was found where the query's was not known.
struct ExplainedScale {
  double value = 1.0;      ///< candidate's metres in a unit of the query
  double deviation = 0.0;  ///< one standard deviation
};

/// "up to scale: 1 unit of the query is 0.71 ± 0.02 m of the map"
inline std::string to_string(const ExplainedScale& scale) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(2) << "up to scale: 1 unit of the query is " << scale.value
      << " ± " << scale.deviation << " m of the map";
  return out.str();
}

/// Why one candidate was or was not accepted.
struct CandidateExplanation {
  KeyframeId id{};                          ///< of the candidate
  Verdict verdict = Verdict::no_agreement;  ///< how far it came
  double similarity = 0.0;                  ///< of the retrieval
  std::optional<double> confidence;         ///< P(true), when the decision is calibrated
  std::optional<double> place_support;      ///< of the pose by the place around the candidate
  std::optional<ExplainedScale> scale;      ///< of the pose that was judged, where not known before
  std::optional<RivalPlace> rival;          ///< the other place that fits about as well
  bool complete = true;                     ///< false when a budget ended the search for poses
  std::vector<ExplainedStage> stages;       ///< in the order in which they are asked
  std::vector<ExplainedMatch> matched;      ///< under the pose that was judged
  std::vector<ExplainedMissing> missing;    ///< expected and not seen
  std::vector<ExplainedChange> changes;     ///< of a candidate that passed every stage

  /// The threshold that decided against it; null when all were reached.
  const ExplainedStage* failed() const noexcept {
    const auto stage = std::find_if(stages.begin(), stages.end(),
                                    [](const ExplainedStage& s) { return !s.passed; });
    return stage == stages.end() ? nullptr : &*stage;
  }
};

/// Why a query was or was not recognised.
struct Explanation {
  std::size_t objects = 0;  ///< of the query
  bool usable = false;      ///< three of them have a position, as is asked of a query
  std::vector<CandidateExplanation> candidates;  ///< best first
};

/// How a reader knows a key frame: "key frame 7", unless the host has a better name.
using KeyframeName = std::function<std::string(KeyframeId)>;

/// The name of a key frame by its id.
inline std::string id_name(KeyframeId id) { return "key frame " + std::to_string(value(id)); }

/// Two numbers with the decimals that tell them apart, two at least: 0.904 and 0.896, not twice
/// 0.90.
inline std::pair<std::string, std::string> told_apart(double a, double b) {
  const auto text = [](double number, int decimals) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::fixed << std::setprecision(decimals) << number;
    return out.str();
  };
  int decimals = 2;
  const int most = 17;
  while (a != b && decimals < most && text(a, decimals) == text(b, decimals)) ++decimals;
  return {text(a, decimals), text(b, decimals)};
}

namespace detail {

inline constexpr const char* cut_short =
    "the search was cut short (max_pairs, max_steps or max_hypotheses)";

/// Where a rival puts the query: ", with the query at (1.00, 2.00, -0.50) m of the world".
inline std::string place_text(const RivalPlace& rival) {
  const Eigen::Vector3d at = rival.T_world_query.value_or(rival.T_candidate_query).translation();
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(2) << ", with the query at (" << at.x() << ", " << at.y()
      << ", " << at.z() << ") m of " << (rival.T_world_query ? "the world" : "its camera frame");
  return out.str();
}

}  // namespace detail

/// In lines, for a log.
inline std::string to_string(const CandidateExplanation& candidate,
                             const KeyframeName& name_of = id_name) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(2);
  out << std::fixed << name_of(candidate.id) << ": " << to_string(candidate.verdict)
      << " (similarity " << candidate.similarity;
  out.precision(4);
  if (candidate.confidence) out << ", P(true) " << *candidate.confidence;
  out.precision(2);
  out << ")\n";
  if (!candidate.complete) {
    out << "  " << detail::cut_short << '\n';
  }
  if (candidate.scale) out << "  " << to_string(*candidate.scale) << '\n';
  for (const ExplainedStage& stage : candidate.stages) {
    const auto [has, asked] = told_apart(stage.value, stage.asked);
    out << "  " << (stage.passed ? "passed" : "failed") << "  " << stage.name << ": " << has
        << stage.unit << " of " << (stage.at_least ? "at least " : "at most ") << asked
        << stage.unit;
    if (!stage.passed && stage.missed_by() == 0.0) {
      out << ", a tie, which goes to the one before";
    } else if (!stage.passed) {
      out << ", missed by " << told_apart(stage.missed_by(), 0.0).first << stage.unit;
    }
    out << '\n';
  }
  if (candidate.place_support) {
    out << "  the place around it supports the pose with " << *candidate.place_support << '\n';
  }
  if (candidate.rival) {
    out << "  another place fits about as well: " << name_of(candidate.rival->id)
        << detail::place_text(*candidate.rival) << '\n';
  }
  for (const ExplainedMatch& match : candidate.matched) {
    out << "  matched " << match.candidate_class;
    if (match.query_class != match.candidate_class) out << " as " << match.query_class;
    out << ", off by " << match.distance << " m (" << match.deviations << " deviations)";
    if (match.looks) {
      out << ", looks " << (*match.looks < 0.0 ? "unlike, " : "alike, ") << std::showpos
          << *match.looks << std::noshowpos;
    }
    out << '\n';
  }
  for (const ExplainedMissing& missing : candidate.missing) {
    const bool by_depth = missing.measured_views > 0;
    const bool by_boxes = missing.measured_views < missing.views;
    out << "  missing " << missing.class_name << " of the "
        << (missing.of_candidate ? "candidate" : "query") << ", expected in " << missing.views
        << (missing.views == 1 ? " view" : " views") << " by " << (by_depth ? "measured depth" : "")
        << (by_depth && by_boxes ? " and " : "") << (by_boxes ? "detected boxes" : "") << ", costs "
        << missing.cost << '\n';
  }
  for (const ExplainedChange& explained : candidate.changes) {
    const ObjectChange& change = explained.change;
    out << "  " << to_string(change.kind) << ' ' << explained.class_name;
    if (change.before) out << " from (" << change.before->transpose() << ")";
    if (change.after) out << " to (" << change.after->transpose() << ")";
    out << " m\n";
  }
  return out.str();
}

/// For a reader: a block for each candidate.
inline std::string to_string(const Explanation& explanation,
                             const KeyframeName& name_of = id_name) {
  std::string text = std::to_string(explanation.objects) + " objects";
  if (!explanation.usable) return text + ": a query takes three with a position\n";
  if (explanation.candidates.empty()) return text + ": there is nothing to compare with\n";
  text += '\n';
  for (const CandidateExplanation& candidate : explanation.candidates) {
    text += to_string(candidate, name_of);
  }
  return text;
}

}  // namespace v0
}  // namespace topobag
