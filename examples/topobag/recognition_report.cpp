// SPDX-License-Identifier: MIT
#include "recognition_report.hpp"

#include <iomanip>
#include <map>
#include <set>
#include <sstream>

#include <topobag/recognition/explanation.hpp>
#include <topobag/types/class_catalog.hpp>

#include "calibration_report.hpp"
#include "json_output.hpp"
#include "keyframe_json.hpp"
#include "pose_numbers.hpp"
#include "run_conditions.hpp"

namespace program {
namespace {

Json times_json(const std::optional<QueryTimes>& ms) {
  if (!ms) return nullptr;
  return {{"median", ms->median},
          {"mean", ms->mean},
          {"percentile_95", ms->percentile_95},
          {"worst", ms->worst}};
}

Json match_json(const RecognitionRun& run, std::size_t i, const topobag::ClassCatalog& catalog) {
  const QueryRecord& record = run.records[i];
  const topobag::CandidateReport& match = *record.recognition.accepted;
  Json objects = Json::object();
  for (const auto& [label, count] : match.matched) objects[catalog.name(label)] = count;
  Json json{{"query_idx", run.queries[i].idx}};
  json.update(keyframe_json(run.map[topobag::value(match.id)], "map_"));
  json["score"] = match.score();
  json["matched"] = objects;
  json["pose_candidate_query"] = pose_numbers(match.pose->T_candidate_query);
  if (match.pose->scale_deviation > 0.0) {
    json["scale"] = match.pose->scale;
    json["scale_deviation"] = match.pose->scale_deviation;
  }
  if (record.error) {
    json["translation_error_m"] = record.error->translation_m;
    json["rotation_error_deg"] = record.error->rotation_deg;
  }
  if (record.verdict) json["verdict"] = to_string(*record.verdict);
  if (match.confidence) json["confidence"] = *match.confidence;
  if (match.confidence && run.calibrated) {
    json["confidence_extrapolated"] = run.calibrated->calibration.is_extrapolated(match.score());
  }
  return json;
}

/// "2 book, 1 tv"
template <typename Counts>
std::string count_text(const Counts& counts, const topobag::ClassCatalog& catalog) {
  std::string text;
  for (const auto& [label, count] : counts) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + catalog.name(label);
  }
  return text;
}

/// What should have been seen under the candidate's pose, and was not.
std::string missing_text(const topobag::CandidateReport& report,
                         const topobag::TopologyGraph<>& candidate,
                         const topobag::TopologyGraph<>& query,
                         const topobag::ClassCatalog& catalog) {
  std::map<topobag::ClassId, std::size_t> counts;
  for (const topobag::MissingObject& missing : report.pose->missing) {
    ++counts[(missing.of_candidate ? candidate : query).node(missing.node).label];
  }
  return counts.empty() ? "" : "; missing " + count_text(counts, catalog);
}

void write_sequence(std::ostream& out, const char* role, const std::string& set,
                    const std::vector<Keyframe>& keyframes) {
  std::size_t usable = 0;
  std::size_t objects = 0;
  std::set<topobag::ClassId> classes;
  for (const Keyframe& keyframe : keyframes) {
    if (keyframe.graph.is_matchable()) ++usable;
    objects += keyframe.graph.size();
    for (const auto& node : keyframe.graph.nodes()) classes.insert(node.label);
  }
  out << std::left << std::setw(7) << role << set << ": " << keyframes.size() << " key frames in "
      << std::fixed << std::setprecision(1)
      << keyframes.back().timestamp - keyframes.front().timestamp << " s, " << usable << " usable, "
      << static_cast<double>(objects) / static_cast<double>(keyframes.size()) << " objects each, "
      << classes.size() << " classes\n";
}

/// By which motion the worlds were laid over each other, and how many matches say so.
std::string worlds_text(const RecognitionRun& run, const RunSummary& summary) {
  std::ostringstream out;
  out << "aligned by the motion that " << summary.correct << " of " << summary.accepted
      << " agree on, to the map's from the queries':";
  for (const double number : pose_numbers(*run.T_map_query_world)) out << ' ' << number;
  return out.str();
}

}  // namespace

const char* to_string(topobag::PoseVerdict verdict) {
  switch (verdict) {
    case topobag::PoseVerdict::correct:
      return "correct";
    case topobag::PoseVerdict::imprecise:
      return "imprecise";
    case topobag::PoseVerdict::wrong:
      return "wrong";
  }
  return "";
}

std::string times_text(const QueryTimes& ms) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << "median " << ms.median << " ms, mean " << ms.mean
      << " ms, 95 % within " << ms.percentile_95 << " ms, worst " << ms.worst << " ms";
  return out.str();
}

std::string to_json(const RecognitionRun& run) {
  const topobag::ClassCatalog& catalog = run.classes.catalog;
  const RunSummary summary = summarize(run);
  Json json{{"keyframes", run.queries.size()},
            {"map_keyframes", run.map.size()},
            {"queries", summary.queries},
            {"queries_in_map", run.in_map},
            {"accepted", summary.accepted},
            {"correct", summary.correct},
            {"imprecise", summary.imprecise},
            {"wrong", summary.wrong},
            {"unscored", summary.unscored},
            {"median_translation_error_m", or_null(summary.median_translation_error_m)},
            {"median_rotation_error_deg", or_null(summary.median_rotation_error_deg)},
            {"query_ms", times_json(summary.query_ms)},
            {"matches", Json::array()}};
  if (run.T_map_query_world) {
    json["T_map_query_world"] = pose_numbers(*run.T_map_query_world);
  }
  json.update(conditions_json(run));
  if (run.calibrated) json["calibration"] = calibration_json(*run.calibrated);
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    if (run.records[i].recognition) json["matches"].push_back(match_json(run, i, catalog));
  }
  return output_text(json, true);
}

std::string to_table(const RecognitionRun& run, const topobag::PoseLimits& limits) {
  const RunSummary summary = summarize(run);
  std::ostringstream out;
  write_sequence(out, "map", run.map_set, run.map);
  write_sequence(out, "query", run.query_set, run.queries);
  const std::string left_out = left_out_text(run);
  if (!left_out.empty()) out << "left out: " << left_out << '\n';
  const auto row = [&](const char* name, std::size_t count) -> std::ostream& {
    return out << "  " << std::left << std::setw(12) << name << std::right << std::setw(5) << count
               << "  ";
  };
  out << '\n';
  row("queries", summary.queries) << "key frames with a usable graph and a candidate\n";
  if (run.in_map > 0)
    row("in the map", run.in_map) << "they are the map's own, and find themselves\n";
  row("accepted", summary.accepted);
  if (summary.queries > 0) {
    out << std::setprecision(0)
        << 100.0 * static_cast<double>(summary.accepted) / static_cast<double>(summary.queries)
        << " % of the queries";
  }
  out << '\n' << std::defaultfloat << std::setprecision(6);
  row("correct", summary.correct) << "within " << limits.correct_translation_m << " m and "
                                  << limits.correct_rotation_deg << "° of the truth\n";
  row("imprecise", summary.imprecise) << "between: the right objects, a loose pose\n";
  row("wrong", summary.wrong) << wrong_text(run) << '\n';
  if (summary.unscored > 0) row("unscored", summary.unscored) << "the truth is not known\n";
  out << '\n' << std::fixed;
  if (summary.median_translation_error_m) {
    out << "  median error  " << std::setprecision(3) << *summary.median_translation_error_m
        << " m, " << std::setprecision(1) << *summary.median_rotation_error_deg << "°\n";
  }
  if (run.T_map_query_world) out << "  worlds        " << worlds_text(run, summary) << '\n';
  if (run.calibrated) out << calibration_lines(*run.calibrated);
  if (summary.query_ms) out << "  query         " << times_text(*summary.query_ms) << '\n';
  return out.str();
}

std::string to_lines(const RecognitionRun& run) {
  const topobag::ClassCatalog& catalog = run.classes.catalog;
  std::ostringstream out;
  out << std::fixed;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const QueryRecord& record = run.records[i];
    const Keyframe& query = run.queries[i];
    out << name_of(query) << ", " << query.graph.size() << " objects: ";
    if (!record.is_query()) {
      out << (record.recognition.usable ? "nothing to compare with" : "no usable graph") << '\n';
      continue;
    }
    const topobag::CandidateReport& best = record.best();
    const Keyframe& candidate = run.map[topobag::value(best.id)];
    out << to_string(best.verdict);
    if (best.pose) {
      const auto [score, asked] = topobag::told_apart(best.score(), best.threshold);
      out << std::setprecision(2) << ", map " << name_of(candidate) << ", score " << score << " of "
          << asked << ", " << count_text(best.matched, catalog)
          << missing_text(best, candidate.graph, query.graph, catalog);
      if (best.pose->scale_deviation > 0.0) {
        out << "; "
            << to_string(topobag::ExplainedScale{best.pose->scale, best.pose->scale_deviation});
      }
      if (best.rival) {
        out << "; as well: map " << name_of(run.map[topobag::value(best.rival->id)]);
      }
    }
    if (record.error) {
      out << "; off by " << record.error->translation_m << " m, " << std::setprecision(1)
          << record.error->rotation_deg << "°";
    }
    if (record.verdict) out << ": " << to_string(*record.verdict);
    out << '\n';
  }
  return out.str();
}

}  // namespace program
