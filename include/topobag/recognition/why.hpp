// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <topobag/recognition/explanation.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/verdict.hpp>

namespace topobag {
inline namespace v0 {

/// In one line, without its end, why a query was or was not recognised: the accepted candidate's
/// score, or the nearest one's and what was against it, and whether the search for its poses was
/// cut short. For all candidates, stage by stage: `explain`.
/// @param name_of  how a reader knows a key frame
inline std::string why(const Recognition& recognition, const KeyframeName& name_of = id_name) {
  if (!recognition.usable) return "not recognised: a query takes three objects with a position";
  if (recognition.candidates.empty()) return "not recognised: there is nothing to compare with";
  const CandidateReport& told =
      recognition ? *recognition.accepted : recognition.candidates.front();
  std::string line = recognition ? "recognised " : "not recognised; nearest is ";
  line += name_of(told.id);
  if (told.pose) {
    const auto [score, asked] = told_apart(told.score(), told.threshold);
    line += ": " + std::to_string(told.pose->inliers.size()) + " objects agree, score " + score +
            " of at least " + asked;
    if (told.pose->scale_deviation > 0.0) {
      line += ", " + to_string(ExplainedScale{told.pose->scale, told.pose->scale_deviation});
    }
  }
  if (!recognition) {
    line += std::string(": ") + to_string(told.verdict);
    if (told.rival) line += " (" + name_of(told.rival->id) + ")";
  }
  if (!told.complete) line += std::string("; ") + detail::cut_short;
  return line;
}

}  // namespace v0
}  // namespace topobag
