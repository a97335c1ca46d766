// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "csv_reader.hpp"
#include "examples/report/page_text.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

using Json = nlohmann::json;

const std::string sets = "compare --map " + sample_map + " --query " + sample_query;

Json compare(const std::string& arguments) {
  const ProgramRun run = run_program(arguments + sample_options + " --json");
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty());
  return Json::parse(run.out);
}

const Json& method(const Json& comparison, const std::string& name) {
  const Json& methods = comparison.at("methods");
  const auto it = std::find_if(methods.begin(), methods.end(),
                               [&](const Json& m) { return m.at("name") == name; });
  REQUIRE(it != methods.end());
  return *it;
}

}  // namespace

TEST_CASE("compare says how many pairs a method has no score for", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string list = folder.write("own.csv", "query,candidate,score\n0,0,1\n1,1,0.5\n");
  const Json comparison = compare(sets + " --scores " + list);
  const std::size_t pairs = comparison.at("true_pairs").get<std::size_t>() +
                            comparison.at("false_pairs").get<std::size_t>();
  const std::string meaning = method(comparison, "own.csv").at("meaning");
  CHECK(meaning.find("scores of " + list + ", without one for ") == 0);
  CHECK(meaning.find(" of the " + std::to_string(pairs) + " pairs that are true or false") !=
        std::string::npos);
}

TEST_CASE("compare gives every method the same pairs and the same numbers", "[examples]") {
  const Json comparison = compare(sets);
  CHECK(comparison.at("protocol") == "distance=0.5,angle=30,negative-distance=1,negative-angle=45");
  CHECK(comparison.at("methods").size() >= 17);
  std::set<std::string> names;
  for (const Json& row : comparison.at("methods")) {
    CAPTURE(row.at("name"));
    names.insert(row.at("name").get<std::string>());
    for (const char* metric : {"average_precision", "auc_pr", "recall_at_1", "recall_at_5",
                               "recall_at_100p", "f1_max"}) {
      CHECK(row.at(metric) >= 0.0);
      CHECK(row.at(metric) <= 1.0);
    }
    CHECK(row.at("recall_at_1") <= row.at("recall_at_5"));
    CHECK(row.at("pair_us") > 0.0);
    if (row.at("name") == "paper's whole pipeline") {
      CHECK(row.at("accepted").is_null());
      continue;
    }
    CHECK(row.at("accepted") == row.at("correct").get<int>() + row.at("imprecise").get<int>() +
                                    row.at("wrong").get<int>());
  }
  CHECK(names.size() == comparison.at("methods").size());
}

TEST_CASE("the default of compare is what localize does", "[examples]") {
  const ProgramRun run = run_program("localize --map " + sample_map + " --query " + sample_query +
                                     sample_options + " --json");
  const Json localized = Json::parse(run.out);
  const Json comparison = compare(sets);
  for (const char* count : {"accepted", "correct", "imprecise", "wrong"}) {
    CHECK(method(comparison, "default").at(count) == localized.at(count));
  }
}

TEST_CASE("all answers verified, every similarity accepts what the default does", "[examples]") {
  const Json comparison = compare(sets + " --verified 1000");
  for (const Json& row : comparison.at("methods")) {
    if (row.at("accepted").is_null()) continue;
    CHECK(row.at("accepted") == method(comparison, "default").at("accepted"));
  }
}

TEST_CASE("the paper's whole pipeline is of single frames whatever the window", "[examples]") {
  const Json fused = method(compare(sets), "paper's whole pipeline");
  const Json single = method(compare(sets + " --window 0"), "paper's whole pipeline");
  CHECK(fused.at("average_precision") == single.at("average_precision"));
  CHECK(fused.at("recall_at_1") == single.at("recall_at_1"));
}

TEST_CASE("compare looks for earlier places of one table", "[examples]") {
  const Json comparison =
      compare("compare --nodes " + sample_map + " --min-gap 5 --protocol distance=0.1,angle=10");
  CHECK(comparison.at("protocol").get<std::string>().find("exclude-seconds=5,past-only") !=
        std::string::npos);
  const ProgramRun run =
      run_program("loops --nodes " + sample_map + " --min-gap 5" + sample_options + " --json");
  CHECK(method(comparison, "default").at("accepted") == Json::parse(run.out).at("accepted"));
}

TEST_CASE("compare refuses what leaves nothing to compare", "[examples][regression]") {
  CHECK(refusal("compare --nodes " + sample_map + sample_options + "--min-gap 1000") ==
        refusal("loops --nodes " + sample_map + sample_options + "--min-gap 1000"));
  CHECK(refusal(sets + sample_options + "--protocol distance=0.00001") ==
        sample_query + ": no query has a true place in the map by the protocol distance=1e-05");
  const ScratchFolder folder;
  std::string frames = "idx,frame,timestamp\n", nodes = "idx,class,conf,u,v,w,h,z\n";
  for (int i = 0; i < 2; ++i) {
    const std::string idx = std::to_string(i);
    frames += idx + ",a.png," + std::to_string(i * 30) + "\n";
    for (const char* box : {",cup,0.9,200,200,40,40,1\n", ",tv,0.9,400,200,80,80,2\n",
                            ",chair,0.9,300,300,90,90,2\n"}) {
      nodes += idx + box;
    }
  }
  folder.write("s.frames.csv", frames);
  folder.write("s.nodes.csv", nodes);
  CHECK(refusal("compare --window 0 --nodes " + folder.path("s") + sample_options) ==
        folder.path("s.frames.csv") + ": not every key frame has a pose; give --trajectory");
}

TEST_CASE("compare refuses where no ranking could be wrong", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string report = folder.path("r.html");
  const std::string said =
      ": it calls no pair false, so that every ranking is right and nothing is compared; call "
      "fewer places true, or give a map that holds others too";
  for (const std::string output : {"", "--json ", "--markdown ", "--report "}) {
    CHECK(refusal(sets + " --protocol distance=500" + sample_options + output +
                  (output == "--report " ? report : "")) == "--protocol distance=500" + said);
  }
  CHECK_FALSE(std::filesystem::exists(report));
  CHECK(refusal("compare --nodes " + sample_map + " --min-gap 5 --protocol distance=500" +
                sample_options) == "--protocol distance=500,exclude-seconds=5,past-only" + said);
  const Json comparison = compare(sets);
  CHECK(comparison.at("false_pairs") > 0);
  CHECK(comparison.at("true_pairs") > 0);
}

TEST_CASE("two files of scores never share a row's name", "[examples][regression]") {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path("a"));
  const std::string list = "query,candidate,score\n0,0,0.5\n1,1,0.25\n";
  const std::string first = folder.write("x.csv", list), second = folder.write("a/x.csv", list);
  CHECK(refusal(sets + sample_options + "--scores " + first + ' ' + folder.path("a/../x.csv")) ==
        "--scores " + folder.path("a/../x.csv") + ": it is given twice; leave one out");
  const auto names = [&](const std::string& scores) {
    std::multiset<std::string> found;
    const Json comparison = compare(sets + " --scores " + scores);
    for (const Json& row : comparison.at("methods")) {
      found.insert(row.at("name").get<std::string>());
    }
    return found;
  };
  const auto both = names(first + ' ' + second), one = names(first);
  CHECK(both.count(first) == 1);
  CHECK(both.count(second) == 1);
  CHECK(both.count("x.csv") == 0);
  CHECK(one.count("x.csv") == 1);
}

TEST_CASE("compare prints a table and writes a report", "[examples][report]") {
  const ScratchFolder folder;
  const ProgramRun run = run_program(sets + sample_options + " --report " + folder.path("r.html") +
                                     " --report-data " + folder.path("r.json"));
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("paper's whole pipeline") != std::string::npos);
  const ProgramRun markdown = run_program(sets + sample_options + " --markdown");
  CHECK(markdown.out.find("| method | AP |") == 0);
  CHECK(times(markdown.out, "\n|") + 1 == times(markdown.out, "\n"));
  const std::string page = program::read_file(folder.path("r.html"));
  CHECK(references(page).empty());
  const Json data = Json::parse(program::read_file(folder.path("r.json")));
  const Json& figures = data.at("figures");
  CHECK(figures.at("comparison").at("rows").size() >= 17);
  CHECK(times(page, "<figure ") == figures.size());
  std::set<std::string> curves;
  for (const Json& row : figures.at("precision-recall").at("rows")) {
    curves.insert(row.at(0).get<std::string>());
  }
  CHECK(curves.size() == figures.at("comparison").at("rows").size());  // of every method
  const Json& shown = figures.at("comparison").at("rows").at(0);
  std::size_t correct = 0, wrong = 0;
  for (const Json& row : figures.at("trajectory").at("rows")) {
    if (row.at(4) == "correct") ++correct;
    if (row.at(4) == "wrong") ++wrong;
  }
  const Json& columns = figures.at("comparison").at("columns");
  const auto shown_as = [&](const char* column) {
    return shown.at(static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) -
                                             columns.begin()));
  };
  CHECK(shown_as("correct") == correct);
  CHECK(shown_as("wrong") == wrong);
}

TEST_CASE("a method of one's own is compared by its scores", "[examples]") {
  const ScratchFolder folder;
  const std::string pairs = folder.path("pairs.csv");
  REQUIRE(run_program("localize --map " + sample_map + " --query " + sample_query + sample_options +
                      "--pairs " + pairs)
              .exit_code == 0);
  program::CsvReader csv(pairs);
  const std::size_t query = csv.column("query"), candidate = csv.column("candidate"),
                    similarity = csv.column("similarity");
  std::string list = "query,candidate,score\n";
  while (csv.next()) {
    list += std::string(csv.text(query)) + ',' + std::string(csv.text(candidate)) + ',' +
            std::string(csv.text(similarity)) + '\n';
  }
  const Json comparison = compare(sets + " --scores " + folder.write("mine.csv", list));
  const Json& own = method(comparison, "mine.csv");
  const Json& bag = method(comparison, "class pairs x distance");  // whose scores they are
  CHECK(own.at("pair_us").is_null());
  for (const char* key : {"recall_at_1", "accepted", "correct", "wrong"}) {
    CHECK(own.at(key) == bag.at(key));
  }
  CHECK(refusal(sets + sample_options + " --scores " + folder.write("few.csv", "1,2\n")) ==
        folder.path("few.csv") +
            ": the scores are 1 × 2, but the poses make 61 queries × 67 candidates");
}

TEST_CASE("bad options end compare with one line", "[examples]") {
  CHECK(refusal("compare --camera 500,500,320,240") == "give either --nodes or --map and --query");
  refusal("compare --map a --camera 500,500,320,240");
  refusal("compare --nodes a --map b --query c --camera 500,500,320,240");
  refusal("compare --nodes a --verified 0 --camera 500,500,320,240");
  CHECK(refusal(sets + sample_options + " --protocol distance=x").find("distance") !=
        std::string::npos);
  const ScratchFolder folder;
  const std::string map = folder.write("map.bag", "");
  CHECK(refusal("compare --map " + map + " --query " + sample_query + sample_options) ==
        map + ": compare makes the graphs anew and needs a node table, not a saved map");
  folder.write("s.frames.csv", "idx,frame,timestamp\n0,a.png,1\n");
  folder.write("s.nodes.csv", "idx,class,conf,u,v,w,h,z\n");
  CHECK(refusal("compare --window 0 --nodes " + folder.path("s") + " --camera 500,500,320,240")
            .find(folder.path("s.nodes.csv") + ": none of the 1 key frames has three objects") ==
        0);
}
