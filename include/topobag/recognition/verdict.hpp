// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// How far a candidate came. Later values passed the earlier stages.
enum class Verdict {
  no_agreement,   ///< too few objects of the same classes lie alike to give a pose
  insignificant,  ///< such a match would come about by chance too often, or too much is missing
  degenerate,     ///< the place is recognised and its pose is not: the matched objects lie nearly
                  ///< on a line, or too close together
  ambiguous,      ///< another pose in the same candidate fits about as well
  rivalled,       ///< another place of the map fits about as well
  not_best,       ///< good enough, but another candidate, of its place or another, is better
  accepted,
};

/// Whether the match passed every stage, so that its pose is to be believed: the best of them all,
/// or one beside it.
inline bool is_verified(Verdict verdict) noexcept {
  return verdict == Verdict::accepted || verdict == Verdict::not_best;
}

/// In words, for a log.
inline const char* to_string(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::no_agreement:
      return "no three objects agree";
    case Verdict::insignificant:
      return "may well be chance";
    case Verdict::degenerate:
      return "the matched objects leave the pose open";
    case Verdict::ambiguous:
      return "another pose fits about as well";
    case Verdict::rivalled:
      return "another place fits about as well";
    case Verdict::not_best:
      return "another candidate is better";
    case Verdict::accepted:
      return "accepted";
  }
  return "";
}

}  // namespace v0
}  // namespace topobag
