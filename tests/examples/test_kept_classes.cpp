// SPDX-License-Identifier: MIT
#include <string>

#include <topobag/bag/snapshot_file.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

#include "catch.hpp"
#include "own_classes.hpp"
#include "saved_map.hpp"

TEST_CASE("a map brings its classes along", "[examples]") {
  const OwnClasses own;
  const std::string map = own.first.write_table(own.folder, "map");
  const std::string query = own.second.write_table(own.folder, "query");
  for (const std::string& name : own_maps) {
    const std::string file = own.folder.path(name);
    REQUIRE(run_program("map --nodes " + map + own.options + "--out " + file).exit_code == 0);
    CHECK(own_json("info " + file + ' ') == own_json("info " + file + own.option + ' '));
    const std::string look_up = "localize --map " + file + " --query " + query;
    const auto with = own_json(look_up + own.options);
    auto without = own_json(look_up + warehouse_camera);
    CHECK(without.at("matches") == with.at("matches"));
    CHECK(without.at("accepted") > 0);
    REQUIRE(run_program("map --append --nodes " + query + warehouse_camera + "--out " + file)
                .exit_code == 0);
    CHECK(own_json("info " + file + ' ').at("sessions").size() == 2);
    const std::string page = own.folder.path("page.html");
    CHECK(run_program("view " + file + " --out " + page).exit_code == 0);
    CHECK(content_of(page).find("fire extinguisher") != std::string::npos);
  }
}

TEST_CASE("maps of one's own classes are merged with them, and keep them", "[examples]") {
  const OwnClasses own;
  for (const std::string& name : own_maps) {
    const std::string first = own.folder.path("first_" + name);
    const std::string second = own.folder.path("second_" + name), both = own.folder.path(name);
    const std::string map = "map --nodes " + own.first.write_table(own.folder, "map");
    const std::string other = "map --nodes " + own.second.write_table(own.folder, "query");
    REQUIRE(run_program(map + own.options + "--out " + first).exit_code == 0);
    REQUIRE(run_program(other + own.options + "--out " + second).exit_code == 0);
    const ProgramRun run = run_program("merge " + first + ' ' + second + " --out " + both);
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
    const program::ObjectClasses kept = program::classes_of_maps({both}, {});
    CHECK(kept.file == both);
    CHECK_FALSE(topobag::difference(program::described(kept), program::described(own.classes)));
  }
}

TEST_CASE("a map refuses classes of which another thing is said", "[examples]") {
  const OwnClasses own;
  const std::string table = own.first.write_table(own.folder, "map");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = warehouse_classes;
    return own.folder.write("changed.txt", text.replace(text.find(from), from.size(), to));
  };
  for (const std::string& name : own_maps) {
    const std::string file = own.folder.path(name);
    REQUIRE(run_program("map --nodes " + table + own.options + "--out " + file).exit_code == 0);
    const std::string before = content_of(file);
    const auto refused = [&](const std::string& from, const std::string& to) {
      const std::string option = " --classes " + changed(from, to);
      const std::string said = refusal("info " + file + option);
      CHECK(refusal("localize --map " + file + " --query " + table + warehouse_camera + option) ==
            said);
      CHECK(refusal("map --append --nodes " + table + warehouse_camera + option + " --out " +
                    file) == said);
      return said;
    };
    const std::string end = " in " + own.folder.path("changed.txt") +
                            "; open it with the classes that it was made with";
    CHECK(refused("forklift, high", "forklift, low") ==
          file + ": class 'forklift' is of high dynamics in the map and of low" + end);
    CHECK(refused("loaded pallet | crate", "crate") ==
          file +
              ": class 'pallet' looks like 'loaded pallet' and 'crate' in the map and like "
              "'crate'" +
              end);
    CHECK(refused("0.3 x 0.3", "0.3 x 0.4") ==
          file + ": class 'crate' is typically 0.3 x 0.3 m in the map and typically 0.3 x 0.4 m" +
              end);
    CHECK(content_of(file) == before);
  }
}

TEST_CASE("a map that says no more than its classes' names takes what is said of them",
          "[examples]") {
  const OwnClasses own;
  const std::string table = own.first.write_table(own.folder, "map");
  const std::string file = own.folder.path("own.bag");
  REQUIRE(run_program("map --nodes " + table + own.options + "--out " + file).exit_code == 0);
  topobag::SaveOptions names;
  names.catalog_fingerprint = topobag::fingerprint(own.classes.catalog);
  topobag::save(topobag::load(file), file, names);
  CHECK(refusal("info " + file).find("its class numbers mean other names") != std::string::npos);
  const std::string still = own.folder.write(
      "still.txt",
      "forklift, low" + warehouse_classes.substr(warehouse_classes.find("\npallet j")));
  CHECK(own_json("info --classes " + still + ' ' + file + ' ').at("keyframes") > 0);
  const std::string query = own.second.write_table(own.folder, "query");
  REQUIRE(run_program("map --append --nodes " + query + own.options + "--out " + file).exit_code ==
          0);
  CHECK(topobag::inspect(file).format_version == 1);
}
