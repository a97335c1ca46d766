// SPDX-License-Identifier: MIT
// What the program writes in JSON, held against the schema in examples/docs.
#include <string>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

using valijson::adapters::NlohmannJsonAdapter;

/// What is wrong with the document by the definition of that name; empty when nothing is.
std::string faults(const nlohmann::json& document, const std::string& definition) {
  nlohmann::json rules = nlohmann::json::parse(
      program::read_file(TOPOBAG_SOURCES "/examples/docs/output.schema.json"));
  REQUIRE(rules.at("definitions").contains(definition));
  rules["allOf"] = {{{"$ref", "#/definitions/" + definition}}};
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7)
      .populateSchema(NlohmannJsonAdapter(rules), schema);
  valijson::ValidationResults results;
  valijson::Validator().validate(schema, NlohmannJsonAdapter(document), &results);
  std::string text;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& step : error.context) text += step;
    text += ": " + error.description + '\n';
  }
  return text;
}

nlohmann::json written(const std::string& arguments) {
  const ProgramRun run = run_program(arguments + " --json");
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  return nlohmann::json::parse(run.out);
}

void check(const nlohmann::json& document, const std::string& definition) {
  CAPTURE(definition);
  CHECK(document.at("schema") == 1);
  CHECK(faults(document, definition) == "");
  nlohmann::json foreign = document;
  foreign["unheard of"] = 1;
  CHECK_FALSE(faults(foreign, definition).empty());
  for (const auto& [key, value] : document.items()) {
    nlohmann::json other = document;
    other[key] = value.is_string() ? nlohmann::json(0) : nlohmann::json("text");
    CAPTURE(key);
    CHECK_FALSE(faults(other, definition).empty());
  }
}

const std::string schema_tables =
    " --map " + sample_map + " --query " + sample_query + sample_options;

}  // namespace

TEST_CASE("JSON of localize and loops is as its schema says", "[examples]") {
  const ScratchFolder folder;
  check(written("localize" + schema_tables + "--calibrate --report-data " + folder.path("r.json")),
        "localize");
  check(nlohmann::json::parse(program::read_file(folder.path("r.json"))), "report");
  check(written("localize" + schema_tables +
                "--place-radius 0.2 --leave-out-radius 0.05 --query-interval 1"),
        "localize");
  check(written("localize --different-places" + schema_tables), "localize");
  check(written("loops --min-gap 5 --nodes " + sample_map + sample_options), "loops");
  const std::string map = folder.path("map.bag");
  for (const std::string& table : {sample_map, sample_query}) {
    REQUIRE(
        run_program("map --append --nodes " + table + sample_options + "--out " + map).exit_code ==
        0);
  }
  check(written("info " + map), "info");
  check(written("localize --map " + map + " --query " + sample_query + sample_options), "localize");
  check(written("explain --frame 30 --map " + map + " --query " + sample_query + sample_options),
        "explain");
}

TEST_CASE("JSON of what scores methods and trajectories is as its schema says", "[examples]") {
  const ScratchFolder folder;
  check(written("explain --frame 30" + schema_tables), "explain");
  check(written("compare" + schema_tables + "--report-data " + folder.path("r.json")), "compare");
  check(nlohmann::json::parse(program::read_file(folder.path("r.json"))), "report");
  check(written("similarity --frames 0,1,2 --camera 517.3,516.5,318.6,255.3 --nodes " + sample_map),
        "similarity");
  const std::string poses =
      folder.write("poses.txt", "0 0 0 0 0 0 0 1\n10 0.1 0 0 0 0 0 1\n20 9 0 0 0 0 0 1\n");
  check(written("trajectory --groundtruth " + poses + " --estimate " + poses), "trajectory");
  const std::string scores = folder.write("s.csv", "nan,.9,.1\n.9,nan,.2\n.1,.2,nan\n");
  const std::string others = folder.write("o.csv", "nan,.7,.1\n.8,nan,.2\n.1,.2,nan\n");
  const std::string evaluate = "evaluate --poses " + poses + " --scores ";
  check(written(evaluate + scores), "evaluate");
  check(written(evaluate + scores + " --bootstrap 50 --against " + others), "evaluate");
  const std::string loops =
      folder.write("l.csv", "query,candidate,score,tx,ty,tz,qx,qy,qz,qw\n1,0,1,0.1,0,0,0,0,0,1\n");
  check(written(evaluate + loops + " --map-poses " + poses), "evaluate");
}
