// SPDX-License-Identifier: MIT
#include <string>

#include <topobag/adaptors/sqlite.hpp>
#include <topobag/adaptors/sqlite_catalog.hpp>

#include "adaptors/sqlite_maps.hpp"
#include "bag/warehouse_catalogs.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

SqliteOptions with_classes(const DescribedCatalog& classes, bool reading = false) {
  SqliteOptions options;
  options.catalog = classes;
  options.read_only = reading;
  return options;
}

}  // namespace

TEST_CASE("a map on disk keeps all that is said of its classes", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("hall.db");
  { SqliteBag<> map(path, with_classes(warehouse())); }
  const std::string before = content_of(path);
  const auto kept = sqlite_catalog(path);
  REQUIRE(kept);
  CHECK_FALSE(difference(*kept, warehouse()));
  CHECK(kept->catalog.ids() == warehouse().catalog.ids());
  CHECK(kept->catalog.name(ClassId{7}) == "loaded pallet");
  CHECK(*kept->sizes == *warehouse().sizes);
  CHECK(content_of(path) == before);
  CHECK(ask(path, "PRAGMA user_version") == "1");
  CHECK(ask(path, "SELECT count(*) FROM class JOIN class_trait USING(id)") == "5");
  CHECK(ask(path, "SELECT lookalike FROM class_trait WHERE id = 7") == "0");
  { SqliteBag<> map(path, with_classes(*kept)); }
  { SqliteBag<> map(path, with_classes(warehouse().catalog, true)); }
  { SqliteBag<> map(path); }
  CHECK_FALSE(difference(*sqlite_catalog(path), warehouse()));
}

TEST_CASE("a map on disk keeps nothing that was not said of its classes", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("hall.db"), nameless = folder.path("nameless.db");
  { SqliteBag<> map(path, with_classes(warehouse().catalog)); }
  REQUIRE(sqlite_catalog(path));
  CHECK_FALSE(sqlite_catalog(path)->lookalikes);
  CHECK_FALSE(sqlite_catalog(path)->sizes);
  { SqliteBag<> map(path, with_classes(warehouse())); }
  CHECK_FALSE(sqlite_catalog(path)->sizes);
  { SqliteBag<> map(nameless); }
  CHECK_FALSE(sqlite_catalog(nameless));
  { SqliteBag<> map(nameless, with_classes(warehouse())); }
  CHECK(sqlite_catalog(nameless));
}

TEST_CASE("a size that could not be read again leaves a map without classes", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("hall.db");
  DescribedCatalog classes = warehouse();
  (*classes.sizes)[ClassId{2}] = {1.0, -1.0};
  CHECK(error_text([&] {
          SqliteBag<> map(path, with_classes(classes));
        }).find("class 'crate' is said to be 1 x -1 m") != std::string::npos);
  { SqliteBag<> map(path, with_classes(warehouse())); }
  CHECK_FALSE(difference(*sqlite_catalog(path), warehouse()));
}

TEST_CASE("a map of classes of which something else is said is refused", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("hall.db");
  SqliteBag<>(path, with_classes(warehouse())).add(KeyframeId{1}, {});
  const std::string before = content_of(path);
  for (const auto& [classes, sentence] : other_warehouses()) {
    for (const bool reading : {false, true}) {
      const SqliteOptions options = with_classes(classes, reading);
      CHECK(error_text([&] { SqliteBag<> map(path, options); }) ==
            path + ": " + sentence + "; open it with the classes that it was made with");
    }
  }
  CHECK(SqliteBag<>(path, with_classes(warehouse())).size() == 1);
}

TEST_CASE("a map of names alone, as earlier ones are, is not asked what is said of them",
          "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("hall.db");
  SqliteBag<>(path, with_classes(warehouse())).add(KeyframeId{1}, {});
  detail::SqliteConnection(path, false).run("DROP TABLE class_trait");
  CHECK_FALSE(sqlite_catalog(path));
  for (const auto& [classes, sentence] : other_warehouses()) {
    CHECK(SqliteBag<>(path, with_classes(classes)).size() == 1);
  }
  CHECK_FALSE(sqlite_catalog(path));
}

TEST_CASE("classes damaged within the file are named", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("hall.db");
  { SqliteBag<> map(path, with_classes(warehouse())); }
  const std::string whole = content_of(path);
  const auto edited = [&](const std::string& change) {
    folder.write("hall.db", whole);
    detail::SqliteConnection(path, false).run(change.c_str());
    return error_text([&] { SqliteBag<> map(path, with_classes(warehouse(), true)); });
  };
  const std::string begin = path + ": its classes cannot be read: ";
  CHECK(edited("UPDATE class_trait SET dynamics = 3") ==
        begin + "its classes' dynamics are damaged");
  CHECK(edited("UPDATE class_trait SET lookalike = 5") ==
        begin + "its classes' look-alikes are damaged");
  CHECK(edited("UPDATE class_trait SET width = -1") ==
        begin + "its classes' typical sizes are damaged");
  CHECK(edited("UPDATE class_trait SET height = 'tall' WHERE id = 0") ==
        begin + "its 'height' is 'tall', which is no number");
  CHECK(edited("DELETE FROM class WHERE id = 0").find(begin + "class id 0 is not in") == 0);
  CHECK(edited("UPDATE class SET name = 'lorry' WHERE id = -3") ==
        begin + "their names are not those that it was made with");
  CHECK(edited("DELETE FROM class_trait WHERE id = 2") ==
        begin + "it does not say what each of its classes is");
}
