// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include "catch.hpp"
#include "error_text.hpp"
#include "place_run.hpp"
#include "scratch_folder.hpp"
#include "shared_runs.hpp"

namespace {

const std::string head =
    "name,kind,min_gap,map,query,map_camera,query_camera,window,interval,min_confidence,world_up\n";

/// The text of the error of a list with this one row, without the folder.
std::string error_of_row(const std::string& row) {
  const ScratchFolder folder;
  const std::string path = folder.write("runs.csv", head + row + "\n");
  const std::string text = error_text([&] { read_place_runs(path); });
  return text.substr(std::min(text.size(), path.size()));
}

}  // namespace

TEST_CASE("a list of runs is read with its tables beside it", "[benchmarks]") {
  const ScratchFolder folder;
  const std::string path =
      folder.write("runs.csv", head +
                                   "a,same,,map,query,1 2 3 4,5 6 7 8,3,0.4,0.3,none\n"
                                   "b,loops,15,/all/way,/all/way,1 2 3 4,1 2 3 4,0,0,0.5,0 0 1\n");
  const auto runs = read_place_runs(path);
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].name == "a");
  CHECK(runs[0].kind == PlaceKind::same);
  CHECK(runs[0].map == folder.path("map"));
  CHECK(runs[0].query == folder.path("query"));
  CHECK(runs[0].map_camera.cy == 4.0);
  CHECK(runs[0].query_camera.fx == 5.0);
  CHECK(runs[0].window == 3.0);
  CHECK(runs[0].interval == 0.4);
  CHECK_FALSE(runs[0].world_up);
  CHECK(runs[1].kind == PlaceKind::loops);
  CHECK(runs[1].min_gap == 15.0);
  CHECK(runs[1].map == "/all/way");
  CHECK(runs[1].min_confidence == 0.5);
  REQUIRE(runs[1].world_up);
  CHECK(*runs[1].world_up == Eigen::Vector3d::UnitZ());
  CHECK(runs[1].places.empty());

  std::string named = head + "a,same,,map,query,1 2 3 4,5 6 7 8,3,0.4,0.3,none,desk kitchen\n";
  named.insert(head.size() - 1, ",places");
  CHECK(read_place_runs(folder.write("named.csv", named)).at(0).places ==
        std::vector<std::string>{"desk", "kitchen"});
}

TEST_CASE("what is wrong in a list of runs is said with its line", "[benchmarks]") {
  CHECK(error_of_row("a,near,,m,q,1 2 3 4,5 6 7 8,3,0.4,0.3,none") ==
        ":2: 'near' is not same, other or loops");
  CHECK(error_of_row("a,same,,m,q,1 2 3,5 6 7 8,3,0.4,0.3,none") ==
        ":2: '1 2 3' is not 4 numbers between blanks");
  CHECK(error_of_row("a,same,,m,q,1 2 3 4 5,5 6 7 8,3,0.4,0.3,none") ==
        ":2: '1 2 3 4 5' is not 4 numbers between blanks");
  CHECK(error_of_row("a,same,,m,q,0 2 3 4,5 6 7 8,3,0.4,0.3,none") ==
        ":2: a focal length is not above 0");
  CHECK(error_of_row("a,same,,m,q,1 2 3 4,5 6 7 8,3,0.4,0.3,0 0 0") ==
        ":2: the world's up has no direction");
  CHECK(error_of_row("a,loops,20,m,q,1 2 3 4,5 6 7 8,3,0.4,0.3,none") ==
        ":2: loops are looked for in one table: map and query differ");
}

TEST_CASE("the shared sets meet as other places only where they are", "[benchmarks]") {
  SharedRunsOptions options;
  options.windows = {0.0};
  options.rooms_stride = 3;
  const auto runs = shared_runs("data", options);
  const auto count = [&](PlaceKind kind, bool gravity) {
    return std::count_if(runs.begin(), runs.end(), [&](const PlaceRun& run) {
      return run.kind == kind && run.world_up.has_value() == gravity;
    });
  };
  for (const bool gravity : {false, true}) {
    CHECK(count(PlaceKind::same, gravity) == 7);
    CHECK(count(PlaceKind::loops, gravity) == 2);
    CHECK(count(PlaceKind::other, gravity) == 29);  // 4 x 2, 4 x 1 and 2 x 1, both ways, and rooms
  }
  for (const PlaceRun& run : runs) {
    CHECK(run.stride == (run.name.find("rooms") == std::string::npos ? 1U : 3U));
    if (run.kind != PlaceKind::other) continue;
    const auto place = [](const std::string& table) { return table.substr(0, 14); };
    CHECK((place(run.map) != place(run.query) || run.map.find("rooms") != std::string::npos));
  }
}
