// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "run_program.hpp"

using nlohmann::json;

namespace {

std::string evaluate(const std::string& arguments) {
  const ProgramRun run = run_program("evaluate " + arguments);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  return run.out;
}

/// Four key frames at x = 0, 0.1, 9 and 9.1 m, 10 s apart.
const std::string poses =
    "0 0 0 0 0 0 0 1\n10 0.1 0 0 0 0 0 1\n20 9 0 0 0 0 0 1\n30 9.1 0 0 0 0 0 1\n";

}  // namespace

TEST_CASE("topobag evaluate: a matrix by hand", "[program][evaluation]") {
  const ScratchFolder folder;
  const std::string files =
      "--poses " + folder.write("poses.txt", poses) + " --scores " +
      folder.write("scores.csv", "nan,.9,.8,.1\n.9,nan,.2,.1\n.8,.2,nan,.7\n.1,.1,.7,nan\n");
  const json result = json::parse(evaluate(files + " --protocol distance=1 --k 1,2 --json"));
  CHECK(result.at("protocol") == "distance=1");
  CHECK(result.at("positive_pairs") == 4);
  CHECK(result.at("negative_pairs") == 8);
  // Falling: .9 ++, .8 --, .7 ++, …
  CHECK(result.at("pairs").at("average_precision") == Approx(0.5 + 0.5 * 4.0 / 6.0));
  CHECK(result.at("pairs").at("recall_at_100p") == 0.5);
  CHECK(result.at("pairs").at("f1_max") == Approx(0.8));
  CHECK(result.at("pairs").at("f1_max_threshold") == 0.7);
  CHECK(result.at("single_best").at("recall_at_100p") == 0.5);
  CHECK(result.at("single_best").at("precision_at_100r").is_null());
  CHECK(result.at("recall_at_k").at("of_queries_with_positive").at("1") == 0.75);
  CHECK(result.at("recall_at_k").at("of_all_queries").at("2") == 1.0);

  const std::string text = evaluate(files + " --protocol distance=1");
  CHECK(text.find("average_precision") != std::string::npos);
  CHECK(text.find("distance=1") != std::string::npos);
}

TEST_CASE("topobag evaluate: distances, the curve and the ranks", "[program][evaluation]") {
  const ScratchFolder folder;
  const std::string files = "--poses " + folder.write("poses.txt", poses) + " --scores " +
                            folder.write("d.csv", "0,1,5,6\n1,0,7,8\n5,7,0,2\n6,8,2,0\n") +
                            " --protocol distance=1";
  const json result =
      json::parse(evaluate(files + " --lower-is-better --json --curve " + folder.path("curve.csv") +
                           " --ranks " + folder.path("ranks.csv")));
  CHECK(result.at("pairs").at("average_precision") == 1.0);
  CHECK(result.at("pairs").at("f1_max_threshold") == 2.0);
  CHECK(program::read_file(folder.path("curve.csv"))
            .find("threshold,true_positives,false_positives,precision,recall,f1\n1,2,0,1,0.5,0."
                  "66666") == 0);
  CHECK(program::read_file(folder.path("ranks.csv")) ==
        "query,positives,negatives,first_positive_rank\n0,1,2,1\n1,1,2,1\n2,1,2,1\n3,1,2,1\n");
}

TEST_CASE("topobag evaluate: a list with relative poses gives the loops' verdicts",
          "[program][evaluation]") {
  const ScratchFolder folder;
  const std::string files =
      "--poses " + folder.write("poses.txt", poses) + " --scores " +
      folder.write("loops.csv",
                   "query,candidate,score,tx,ty,tz,qx,qy,qz,qw\n"
                   "1,0,0.9,0.1,0,0,0,0,0,1\n3,2,0.8,0.6,0,0,0,0,0,1\n3,1,0.5,0,0,0,0,0,0,1\n") +
      " --protocol distance=1,past-only --json";
  const json loops = json::parse(evaluate(files)).at("loops");
  CHECK(loops.at("correct") == 1);
  CHECK(loops.at("imprecise") == 1);
  CHECK(loops.at("wrong") == 1);
  CHECK(loops.at("precision") == Approx(1.0 / 3.0));
  const json strict =
      json::parse(evaluate(files + " --accept 0.8 --pose-limits 0.6,20,2,50")).at("loops");
  CHECK(strict.at("accepted") == 2);
  CHECK(strict.at("precision") == 1.0);
}

TEST_CASE("topobag evaluate: intervals and a paired test repeat with their seed",
          "[program][evaluation]") {
  const ScratchFolder folder;
  const std::string files =
      "--poses " + folder.write("poses.txt", poses) + " --scores " +
      folder.write("a.csv", "0,.9,.8,.1\n.9,0,.2,.1\n.8,.2,0,.7\n.1,.1,.7,0\n") + " --against " +
      folder.write("b.csv", "0,9,1,1\n9,0,1,1\n1,1,0,9\n1,1,9,0\n") +
      " --protocol distance=1 --bootstrap 200 --json";
  const json result = json::parse(evaluate(files));
  const json interval = result.at("pairs").at("intervals").at("average_precision");
  CHECK(interval.at(0).get<double>() <= result.at("pairs").at("average_precision").get<double>());
  CHECK(interval.at(1).get<double>() >= result.at("pairs").at("average_precision").get<double>());
  CHECK(result.at("comparison").at("recall_at_1").at("difference") == 0.25);
  CHECK(result.at("comparison").at("recall_at_1").at("p_value") == 1.0);
  CHECK(evaluate(files) == evaluate(files));
  CHECK(evaluate(files) != evaluate(files + " --seed 2"));
}

TEST_CASE("topobag evaluate: a map of its own", "[program][evaluation]") {
  const ScratchFolder folder;
  const json result = json::parse(
      evaluate("--poses " + folder.write("poses.txt", poses) + " --map-poses " +
               folder.write("map.txt", "5 9 0 0 0 0 0 1\n") + " --scores " +
               folder.write("scores.csv", "1\n2\n3\n4\n") + " --protocol distance=1 --json"));
  CHECK(result.at("queries_with_positive") == 2);
  CHECK(result.at("pairs").at("average_precision") == 1.0);
}

TEST_CASE("topobag evaluate: bad input is said in a sentence", "[program][evaluation]") {
  const ScratchFolder folder;
  const std::string with_poses = "--poses " + folder.write("poses.txt", poses);
  const std::string scores = " --scores " + folder.write("scores.csv", "1,2\n3,4\n");
  const auto refused = [](const std::string& arguments, const std::string& part) {
    const std::string said = refusal("evaluate " + arguments);
    CAPTURE(said);
    CHECK(said.find(part) != std::string::npos);
  };
  refused(with_poses + scores + " --protocol distance=1", "2 × 2");
  refused(with_poses + scores + " --protocol near=1", "'near' is not one of");
  refused(with_poses + " --scores " + folder.path("none.csv") + " --protocol distance=1",
          "none.csv");
  refused(with_poses + " --scores " + folder.write("x.npy", "x") + " --protocol distance=1",
          "x.npy");
  refused("--poses " + folder.write("empty.txt", "# none\n") + scores + " --protocol distance=1",
          "no pose");
  refused("--poses " + folder.write("two.txt", "seq: 1\n1 0 0 0 0 0 0 1\nseq: 2\n") + scores +
              " --protocol distance=1",
          "does not hold one trajectory");
  const std::string good = with_poses + scores + " --protocol distance=1";
  refused(good + " --level nan", "'nan' is not a number in [0.01, 0.999]");
  refused(good + " --accept nan", "'nan' is not a number in (-inf, inf)");
}

TEST_CASE("topobag evaluate: what leaves nothing to score is refused",
          "[program][evaluation][regression]") {
  const ScratchFolder folder;
  const std::string with_poses = "evaluate --poses " + folder.write("poses.txt", poses);
  const std::string matrix =
      folder.write("m.csv", "0,.9,.8,.1\n.9,0,.2,.1\n.8,.2,0,.7\n.1,.1,.7,0\n");
  CHECK(refusal(with_poses + " --scores " + matrix + " --protocol distance=500") ==
        "--protocol distance=500: it calls no pair false, so that there is nothing to score; call "
        "fewer places true, or give poses of other places too");
  const std::string empty = folder.write("list.csv", "query,candidate,score\n");
  CHECK(refusal(with_poses + " --scores " + empty) == empty + ": there is no score in the file");
  CHECK(refusal(with_poses + " --scores " + folder.path()) ==
        folder.path() + ": it is a folder; name a file in it");
}

TEST_CASE("topobag evaluate: options about poses do not go with scores that have none",
          "[program][evaluation][regression]") {
  const ScratchFolder folder;
  const std::string list = folder.write("list.csv", "query,candidate,score\n1,0,0.9\n3,2,0.8\n");
  const std::string files = "evaluate --protocol distance=1 --poses " +
                            folder.write("poses.txt", poses) + " --scores " + list;
  const std::string has_none = list + ": its scores have no poses, which ";
  const std::string needed = " is about: a list with the columns tx,ty,tz,qx,qy,qz,qw has them";
  CHECK(refusal(files + " --pose-limits 0.3,15,1,45") == has_none + "--pose-limits" + needed);
  CHECK(refusal(files + " --accept 0.85") == has_none + "--accept" + needed);
  CHECK(run_program(files + " --accept 0.85 --report " + folder.path("r.html")).exit_code == 0);
}

TEST_CASE("topobag evaluate: poses without times do not go with seconds", "[program][evaluation]") {
  const ScratchFolder folder;
  const std::string kitti =
      folder.write("kitti.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 9 0 1 0 0 0 0 1 0\n");
  const std::string files =
      "--poses " + kitti + " --scores " + folder.write("scores.csv", "nan,.9\n.9,nan\n");
  CHECK(refusal("evaluate " + files + " --protocol distance=1,exclude-seconds=5") ==
        kitti +
            ": exclude-seconds needs times, which a KITTI trajectory has not: give --times, or "
            "exclude-frames");
  CHECK(run_program("evaluate " + files + " --protocol distance=1,exclude-frames=1").exit_code ==
        0);
}
