// SPDX-License-Identifier: MIT
#include <locale>
#include <string>

#include <topobag/recognition/explanation.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// Groups digits for as long as it lives, as a host's locale may.
class GroupingLocale {
 public:
  GroupingLocale() : before_(std::locale::global(std::locale(std::locale(), new Grouping))) {}
  ~GroupingLocale() { std::locale::global(before_); }

 private:
  struct Grouping : std::numpunct<char> {
    std::string do_grouping() const override { return "\3"; }
    char do_thousands_sep() const override { return '.'; }
    char do_decimal_point() const override { return ','; }
  };
  std::locale before_;
};

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a threshold is missed from below or from above", "[recognition]") {
  CHECK(ExplainedStage{"score", false, 1.5, 2.0, true, {}}.missed_by() == 0.5);
  CHECK(ExplainedStage{"deviation", false, 0.5, 0.25, false, " rad"}.missed_by() == 0.25);
  CHECK(ExplainedStage{"score", true, 3.0, 2.0, true, {}}.missed_by() == -1.0);
}

TEST_CASE("the threshold that decided is the first that failed", "[recognition]") {
  CandidateExplanation candidate;
  CHECK(candidate.failed() == nullptr);
  candidate.stages = {
      {"a", true, 3, 3, true, {}}, {"b", false, 1, 2, true, {}}, {"c", false, 1, 9, true, {}}};
  REQUIRE(candidate.failed() != nullptr);
  CHECK(candidate.failed()->name == "b");
}

TEST_CASE("an explanation in words", "[recognition]") {
  CandidateExplanation candidate;
  candidate.id = KeyframeId{42};
  candidate.verdict = Verdict::insignificant;
  candidate.similarity = 0.5;
  candidate.confidence = 0.75;
  candidate.stages = {{"objects that agree", true, 4, 3, true, {}},
                      {"score", false, -0.4, 0.05, true, {}}};
  candidate.matched = {{node_index(0), node_index(1), "tv", "laptop", 0.04, 1.25, -0.6},
                       {node_index(1), node_index(2), "cup", "cup", 0.04, 1.25, 0.35},
                       {node_index(2), node_index(3), "book", "book", 0.04, 1.25, {}}};
  candidate.missing = {{node_index(3), true, "vase", {0, 0, 3}, 2, 0, 0.3},
                       {node_index(2), false, "cup", {0, 0, 3}, 1, 1, 0.25}};
  ObjectChange change;
  change.before = Eigen::Vector3d(1, 0, 3);
  candidate.changes = {{change, "vase"}};
  const std::string text = to_string(Explanation{7, true, {candidate}});
  CHECK(says(text, "7 objects"));
  CHECK(says(text, "key frame 42: may well be chance"));
  CHECK(says(text, "P(true) 0.7500"));
  CHECK(says(text, "passed  objects that agree"));
  CHECK(says(text, "failed  score: -0.40 of at least 0.05, missed by 0.45"));
  CHECK(says(text, "matched tv as laptop, off by 0.04 m (1.25 deviations), looks unlike, -0.60\n"));
  CHECK(says(text, "matched cup, off by 0.04 m (1.25 deviations), looks alike, +0.35\n"));
  CHECK(says(text, "matched book, off by 0.04 m (1.25 deviations)\n"));
  CHECK(says(text,
             "missing vase of the candidate, expected in 2 views by detected boxes, costs 0.30"));
  CHECK(says(text, "missing cup of the query, expected in 1 view by measured depth, costs 0.25"));
  CHECK(says(text, "gone vase from"));
}

TEST_CASE("a query with nothing to say is explained, too", "[recognition]") {
  CHECK(says(to_string(Explanation{2, false, {}}), "a query takes three"));
  CHECK(says(to_string(Explanation{5, true, {}}), "nothing to compare with"));
}

TEST_CASE("numbers are told apart, and are not grouped by the locale", "[recognition]") {
  CandidateExplanation candidate;
  candidate.id = KeyframeId{1234567};
  candidate.stages = {{"score", false, 0.8996, 0.9004, true, {}},
                      {"distance", true, 1234567.5, 2.0, true, " m"}};
  const GroupingLocale grouped;
  const std::string text = to_string(candidate);
  CHECK(says(text, "key frame 1234567: "));
  CHECK(says(text, "score: 0.8996 of at least 0.9004, missed by 0.001"));
  CHECK(says(text, "distance: 1234567.50 m of at least 2.00 m"));
}

TEST_CASE("a stage that fails by nothing is a tie", "[recognition][regression]") {
  CandidateExplanation candidate;
  candidate.stages = {{"lead", false, 7.58, 7.58, true, {}}};
  CHECK(says(to_string(candidate),
             "failed  lead: 7.58 of at least 7.58, a tie, which goes to the one before\n"));
}

TEST_CASE("a host names its key frames", "[recognition]") {
  CandidateExplanation candidate;
  candidate.id = KeyframeId{97};
  candidate.rival = RivalPlace{KeyframeId{98}, 1.0, 2.0};
  const auto name = [](KeyframeId id) { return "Tuesday, " + std::to_string(value(id) - 67); };
  const std::string text = to_string(Explanation{7, true, {candidate}}, name);
  CHECK(says(text, "Tuesday, 30: "));
  CHECK(says(text, "another place fits about as well: Tuesday, 31, with the query at "));
}

TEST_CASE("a rival is told with where it puts the query", "[recognition]") {
  CandidateExplanation candidate;
  candidate.rival = RivalPlace{KeyframeId{98}, 1.0, 2.0};
  candidate.rival->T_candidate_query.translation() = Eigen::Vector3d(1.0, -2.0, 0.126);
  CHECK(says(to_string(candidate),
             "key frame 98, with the query at (1.00, -2.00, 0.13) m of its camera frame\n"));
  candidate.rival->T_world_query = Eigen::Translation3d(40, 0, 0) * Eigen::Isometry3d::Identity();
  CHECK(says(to_string(candidate),
             "key frame 98, with the query at (40.00, 0.00, 0.00) m of the world\n"));
}
