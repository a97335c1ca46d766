// SPDX-License-Identifier: MIT
// What a calibration makes of the number of places that were asked.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <topobag/recognition/calibrate.hpp>
#include <topobag/recognition/calibration_text.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

TEST_CASE("what a calibration asks for grows with the places of the map", "[recognition]") {
  // Scores of a map of 20 places: the best of 20 draws of what chance gives one place.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(1e-9, 1.0);
  const auto best_of = [&](std::size_t places) {
    double best = -10.0;
    for (std::size_t i = 0; i < places; ++i) best = std::max(best, -std::log10(uniform(random)));
    return best;
  };
  Calibration calibration;
  for (int i = 0; i < 4000; ++i) calibration.add_negative(best_of(20), false, 20);
  CHECK(calibration.asked_places().mean() == 20.0);
  for (const double rate : {0.1, 0.02}) {
    const double learnt = calibration.threshold(rate).score;
    CHECK(calibration.threshold(rate, 20).score == learnt);
    CHECK(calibration.threshold(rate, 5).score == learnt);  // never less
    double last = learnt;
    for (const std::size_t places : {40U, 200U, 2000U}) {
      const double asked = calibration.threshold(rate, places).score;
      CHECK(asked > last);
      CHECK(calibration.false_accept_rate(asked, places).rate <= rate * (1.0 + 1e-9));
      // Chance's own tail: log10(places / places learnt) more, as the decision's formula.
      CHECK(asked - learnt == Approx(std::log10(static_cast<double>(places) / 20.0)).margin(0.25));
      last = asked;
    }
    // And the rate holds: no more of a larger map's queries get through.
    for (const std::size_t places : {20U, 200U}) {
      int accepted = 0;
      const double asked = calibration.threshold(rate, places).score;
      for (int i = 0; i < 2000; ++i) accepted += best_of(places) >= asked ? 1 : 0;
      CHECK(accepted < 1.4 * rate * 2000);
    }
  }
}

TEST_CASE("P(true) falls with the places of the map", "[recognition]") {
  Calibration calibration;
  for (int i = 0; i < 400; ++i) calibration.add_null(-2.0 + 0.01 * i, i % 2 == 0 ? 10U : 30U);
  CHECK(calibration.asked_places().mean() == 20.0);
  for (double score = -3.0; score < 9.0; score += 0.5) {
    CAPTURE(score);
    const double learnt = calibration.probability(score);
    CHECK(calibration.probability(score, 20) == learnt);
    CHECK(calibration.probability(score, 3) == learnt);
    const double rate =
        std::min(1.0, 10.0 * std::max(calibration.false_accept_rate(score).rate, 1.0 / 401.0));
    CHECK(calibration.probability(score, 200) == Approx(0.5 / (0.5 + 0.5 * rate)));
    CHECK(calibration.is_extrapolated(score) == calibration.false_accept_rate(score).extrapolated);
  }
}

TEST_CASE("queries that do not tell their places leave a calibration as it was", "[recognition]") {
  Calibration calibration;
  for (int i = 0; i < 300; ++i) calibration.add_negative(0.01 * i);
  CHECK(calibration.asked_places().queries == 0);
  CHECK(calibration.threshold(1e-3, 100000).score == calibration.threshold(1e-3).score);
  CHECK(calibration.probability(2.0, 100000) == calibration.probability(2.0));
  calibration.add_negative(std::nullopt, false, 50);  // of those that tell
  CHECK(calibration.asked_places().mean() == 50.0);
  CHECK(calibration.threshold(1e-3, 500).score > calibration.threshold(1e-3, 50).score);
  for (const double rate : {0.0, -1.0, 1.5, std::nan("")}) {
    CHECK_THROWS_AS(calibration.threshold(rate, 500), InvalidValue);
  }
  CHECK_THROWS_AS(calibration.set_asked_places({302, 900}), InvalidValue);
  CHECK_THROWS_AS(calibration.set_asked_places({3, 2}), InvalidValue);
}

TEST_CASE("the places that were asked are saved with the calibration", "[recognition]") {
  for (const bool with_appearance : {false, true}) {
    Calibration was;
    for (std::size_t places = 1; places < 5; ++places) was.add_null(0.1, 7 * places);
    was.add_negative(2.5);
    if (with_appearance) was.set_appearance(AppearanceModel());
    const std::string text = to_string(was);
    CHECK(text.find("topobag calibration 3\n") == 0);
    const Calibration is = parse_calibration(text);
    CHECK(to_string(is) == text);
    CHECK(is.asked_places().queries == 4);
    CHECK(is.asked_places().places == 70);
    CHECK(is.appearance().has_value() == with_appearance);
    for (const std::size_t places : {0U, 1U, 40U, 1000U}) {
      CHECK(is.threshold(0.01, places).score == was.threshold(0.01, places).score);
    }
    for (std::size_t size = 0; size < text.size(); ++size) {
      CHECK_THROWS_AS(parse_calibration(text.substr(0, size)), FormatError);
    }
    const auto refused = [&](const std::string& from, const std::string& to) {
      std::string other = text;
      other.replace(other.find(from), from.size(), to);
      return error_text([&] { parse_calibration(other); });
    };
    const std::string no_places = "cannot have asked so many places";
    CHECK(refused("places_look_ups 4", "places_look_ups 6").find(no_places) != std::string::npos);
    CHECK(refused("places_asked 70", "places_asked 3").find(no_places) != std::string::npos);
    CHECK(refused("calibration 3", "calibration 2").find("'appearance_kind'") != std::string::npos);
    CHECK(refused("calibration 3", "calibration 1").find("'end' is missing") != std::string::npos);
  }
}

TEST_CASE("a map that has grown since it taught asks for more", "[recognition]") {
  std::mt19937 random(12);
  Relocalizer<> relocalizer;
  const auto add_rooms = [&](unsigned from, unsigned to) {
    for (unsigned i = from; i < to; ++i) {
      const Eigen::Isometry3d T_room_camera = random_camera(random);
      relocalizer.map().add(KeyframeId{i}, SyntheticRoom(i, 8, 4).seen_from(T_room_camera),
                            standing_at(Eigen::Translation3d(20.0 * i, 0, 0) * T_room_camera));
    }
  };
  add_rooms(0, 8);
  std::vector<KeyframeId> ids;
  for (unsigned i = 0; i < 8; ++i) ids.push_back(KeyframeId{i});
  RecognitionOptions options = relocalizer.options();
  options.decision.false_accept_rate = 0.02;
  const Calibration learnt = calibrate(relocalizer, ids);
  CHECK(learnt.asked_places().mean() == static_cast<double>(relocalizer.map().places()));
  options.decision.calibration = learnt;
  const auto query = SyntheticRoom(3, 8, 4).seen_from(random_camera(random));
  const Recognition before = relocalizer.localize(query, options);
  REQUIRE(before);
  CHECK(before.accepted->threshold == learnt.threshold(0.02).score);
  CHECK(*before.accepted->confidence == learnt.probability(before.accepted->score()));
  add_rooms(8, 80);
  const Recognition after = relocalizer.localize(query, options);
  REQUIRE(after.places > 5 * before.places);
  REQUIRE_FALSE(after.candidates.empty());
  for (const CandidateReport& report : after.candidates) {
    CHECK(report.threshold == learnt.threshold(0.02, after.places).score);
    CHECK(report.threshold > before.accepted->threshold);
    if (!report.confidence) continue;
    CHECK(*report.confidence == learnt.probability(report.score(), after.places));
    CHECK(*report.confidence < *before.accepted->confidence);
  }
}
