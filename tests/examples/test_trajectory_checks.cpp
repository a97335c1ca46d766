// SPDX-License-Identifier: MIT
#include <string>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "run_program.hpp"

namespace {

/// Poses 1 s apart on a bent path, in units of `unit` m.
std::string bent_path(int poses, double unit) {
  std::string text;
  for (int i = 0; i < poses; ++i) {
    text += std::to_string(i) + ' ' + std::to_string(i / unit) + ' ' +
            std::to_string(0.1 * i * i / unit) + " 0 0 0 0 1\n";
  }
  return text;
}

/// A trajectory scored against the bent path of nine poses.
struct ScoredPath {
  ScratchFolder folder;
  std::string truth = folder.write("truth.txt", bent_path(9, 1.0));

  std::string arguments(const std::string& estimate, const std::string& options = "") const {
    return "trajectory --json --groundtruth " + truth + " --estimate " +
           folder.write("estimate.txt", estimate) + ' ' + options;
  }
  std::string told(const std::string& estimate, const std::string& options = "") const {
    return refusal(arguments(estimate, options));
  }
};

}  // namespace

TEST_CASE("a step of the relative pose error that no two poses are apart is refused",
          "[examples][regression]") {
  const ScoredPath path;
  const std::string estimate = bent_path(9, 1.0);
  CHECK(path.told(estimate, "--rpe-step 0.5") ==
        "--rpe-step 0.5: frames are whole numbers; give one, or --rpe-unit seconds or metres");
  CHECK(path.told(estimate, "--rpe-step 100") ==
        "--rpe-step 100: no two of the 9 matched poses are 100 frames apart");
  CHECK(path.told(estimate, "--rpe-step 9 --rpe-unit seconds") ==
        "--rpe-step 9: no two of the 9 matched poses are 9 seconds apart");
  CHECK(run_program(path.arguments(estimate, "--rpe-step 8")).exit_code == 0);
  CHECK(run_program(path.arguments(estimate, "--rpe-step 0.5 --rpe-unit metres")).exit_code == 2);
}

TEST_CASE("one matched pose is not aligned", "[examples][regression]") {
  const ScoredPath path;
  CHECK(path.told("3 7 0 0 0 0 0 1\n") ==
        path.folder.path("estimate.txt") +
            ": one pose alone is matched, which an alignment brings onto the truth wherever it is; "
            "give --alignment none");
  const ProgramRun run = run_program(path.arguments("3 7 0 0 0 0 0 1\n", "--alignment none"));
  CHECK(run.exit_code == 0);
  CHECK(nlohmann::json::parse(run.out).at("sequences").at("1").at("ate_rmse") > 4.0);
}

TEST_CASE("two matched poses are aligned by nothing but their distance", "[examples][regression]") {
  const ScoredPath path;
  const std::string two = "3 7 0 0 0 0 0 1\n4 9 0 0 0 0 0 1\n";
  for (const std::string alignment : {"", "--alignment se3", "--alignment sim3"}) {
    CHECK(path.told(two, alignment)
              .find(": two poses alone are matched, which an alignment brings onto the truth") !=
          std::string::npos);
  }
  CHECK(run_program(path.arguments(two, "--alignment none")).exit_code == 0);
  CHECK(run_program(path.arguments(bent_path(3, 1.0), "--alignment sim3")).exit_code == 0);
}

TEST_CASE("poses without a true one are counted where they are most", "[examples][regression]") {
  const ScoredPath path;
  const ProgramRun late = run_program(path.arguments(bent_path(20, 1.0)));
  CHECK(late.exit_code == 0);
  CHECK(late.err == "topobag: " + path.folder.path("estimate.txt") +
                        ": 11 of 20 poses have no true poses around them within --max-gap 0.5 s, "
                        "and are not scored\n");
  CHECK(run_program(path.arguments(bent_path(18, 1.0))).err.empty());
}

TEST_CASE("a trajectory in millimetres is told from one in metres", "[examples][regression]") {
  const ScoredPath path;
  const std::string in_metres =
      " is it in millimetres? Both are read in metres; --alignment sim3 "
      "scores an estimate of another unit";
  const std::string large = " its trajectory is 1000 times as large as that of the other file:";
  CHECK(path.told(bent_path(9, 0.001)) ==
        path.folder.path("estimate.txt") + ":" + large + in_metres);
  CHECK(path.told(bent_path(9, 0.001), "--alignment none").find(large) != std::string::npos);
  CHECK(path.told(bent_path(9, 1000.0)) == path.truth + ":" + large + in_metres);
  CHECK(run_program(path.arguments(bent_path(9, 0.001), "--alignment sim3")).exit_code == 0);
  CHECK(run_program(path.arguments(bent_path(9, 0.01))).exit_code == 0);  // of another scale
  std::string straight;  // as large, and of another shape
  for (int i = 0; i < 9; ++i) {
    straight += std::to_string(i) + ' ' + std::to_string(i % 2 * 7000) + " 0 0 0 0 0 1\n";
  }
  CHECK(run_program(path.arguments(straight)).exit_code == 0);
}

TEST_CASE("times that overlap but lie too far apart are told by --max-gap",
          "[examples][regression]") {
  const ScoredPath path;
  CHECK(path.told("0.5 0 0 0 0 0 0 1\n1.5 0 0 0 0 0 0 1\n", "--max-gap 0.01") ==
        path.folder.path("estimate.txt") +
            ": no pose lies between two true ones of its time: 2 poses from 0.5 to 1.5 s, the "
            "truth has 9 poses from 0 to 8 s; none of both are within --max-gap 0.01 s");
}
