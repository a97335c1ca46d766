// SPDX-License-Identifier: MIT
#include <clocale>
#include <set>
#include <string>

#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// What `call` throws as an `Exception`.
template <typename Exception, typename Call>
std::string thrown(const Call& call) {
  try {
    call();
  } catch (const Exception& error) {
    return error.what();
  }
  FAIL("nothing was thrown");
  return {};
}

}  // namespace

TEST_CASE("Table 3: the paper's sixteen classes and their numbers", "[types][paper]") {
  const ClassCatalog catalog = ClassCatalog::paper();
  const char* const names[] = {"tv",     "keyboard",   "chair",        "book",
                               "mouse",  "teddy_bear", "potted_plant", "cup",
                               "vase",   "car",        "desk",         "water_dispenser",
                               "bucket", "door",       "bag",          "bookshelf"};
  REQUIRE(catalog.size() == 16);
  for (std::int32_t i = 0; i < 16; ++i) {
    CHECK(catalog.at(names[i]) == ClassId{i + 1});
    CHECK(catalog.name(ClassId{i + 1}) == names[i]);
  }
}

TEST_CASE("Table 2: the dynamics that the paper gives", "[types][paper]") {
  const ClassCatalog paper = ClassCatalog::paper();
  CHECK(paper.dynamics(paper.at("chair")) == Dynamics::medium);
  CHECK(paper.dynamics(paper.at("book")) == Dynamics::medium);
  CHECK(paper.dynamics(paper.at("desk")) == Dynamics::low);
  CHECK(paper.dynamics(paper.at("tv")) == Dynamics::low);
  const ClassCatalog coco = ClassCatalog::coco80();
  CHECK(coco.dynamics(coco.at("person")) == Dynamics::high);
}

TEST_CASE("COCO's eighty classes are numbered without a gap, each name once", "[types]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  REQUIRE(catalog.size() == 80);
  std::set<std::string> names;
  std::int32_t expected = 0;
  for (const ClassId id : catalog.ids()) {
    CHECK(value(id) == expected++);
    CHECK(catalog.at(catalog.name(id)) == id);
    names.insert(catalog.name(id));
  }
  CHECK(names.size() == 80);
  CHECK(catalog.at("person") == ClassId{0});
  CHECK(catalog.at("chair") == ClassId{56});
  CHECK(catalog.at("toothbrush") == ClassId{79});
}

TEST_CASE("class names match in any spelling", "[types]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  for (const char* name : {"potted plant", "Potted_Plant", "POTTED-PLANT", "  potted  plant\r",
                           "pottedplant", "potted _- plant"}) {
    CAPTURE(name);
    CHECK(catalog.find(name) == ClassId{58});
  }
  CHECK(catalog.find("tvmonitor") == catalog.find("tv"));
  CHECK(catalog.find("sofa") == catalog.find("couch"));
  CHECK(catalog.find("diningtable") == catalog.find("dining table"));
  CHECK(catalog.find("aeroplane") == catalog.find("airplane"));
  CHECK(catalog.find("motorbike") == catalog.find("motorcycle"));
}

TEST_CASE("a desk is not a dining table", "[types]") {
  CHECK_FALSE(ClassCatalog::coco80().find("desk"));
  CHECK_FALSE(ClassCatalog::paper().find("dining table"));
}

TEST_CASE("an unknown class names its nearest neighbours", "[types]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  const std::string message = thrown<UnknownClass>([&] { catalog.at("Keybord"); });
  CHECK(message.find("unknown class 'Keybord'; nearest known: 'keyboard'") == 0);
  CHECK_FALSE(catalog.find(""));
  CHECK(thrown<UnknownClass>([&] { catalog.name(ClassId{80}); }) ==
        "class id 80 is not in the catalog");
  CHECK(thrown<UnknownClass>([&] { catalog.dynamics(ClassId{-1}); }) ==
        "class id -1 is not in the catalog");
}

TEST_CASE("the three nearest neighbours of an unknown class come by their distance", "[types]") {
  ClassCatalog catalog;
  for (const char* const name : {"door", "affair", "stair", "hair"}) {
    catalog.add(ClassId{static_cast<std::int32_t>(catalog.size())}, name, Dynamics::low);
  }
  CHECK(thrown<UnknownClass>([&] { catalog.at("air"); }) ==
        "unknown class 'air'; nearest known: 'hair' 'stair' 'affair'");
}

TEST_CASE("edit distances on known pairs", "[types]") {
  CHECK(detail::edit_distance("", "") == 0);
  CHECK(detail::edit_distance("", "abc") == 3);
  CHECK(detail::edit_distance("abc", "") == 3);
  CHECK(detail::edit_distance("kitten", "sitting") == 3);
  CHECK(detail::edit_distance("flaw", "lawn") == 2);
}

TEST_CASE("a catalog of one's own", "[types]") {
  ClassCatalog catalog;
  catalog.add(ClassId{7}, "Fire door", Dynamics::low);
  catalog.add(ClassId{3}, "pallet", Dynamics::medium);
  catalog.add_alias("exit", "fire_door");
  CHECK(catalog.ids() == std::vector<ClassId>{ClassId{3}, ClassId{7}});
  CHECK(catalog.at("exit") == ClassId{7});
  CHECK(catalog.name(ClassId{7}) == "Fire door");
  catalog.set_dynamics(ClassId{3}, Dynamics::high);
  CHECK(catalog.dynamics(ClassId{3}) == Dynamics::high);
}

TEST_CASE("a refused addition leaves the catalog as it was", "[types]") {
  ClassCatalog catalog;
  catalog.add(ClassId{1}, "door", Dynamics::low);
  catalog.add_alias("gate", "door");
  CHECK(thrown<InvalidId>([&] { catalog.add(ClassId{1}, "window", Dynamics::low); }) ==
        "class id 1 is taken by 'door'");
  CHECK(thrown<InvalidId>([&] { catalog.add(ClassId{2}, "DOOR", Dynamics::low); }) ==
        "class name 'DOOR' is taken");
  CHECK(thrown<InvalidId>([&] { catalog.add(ClassId{2}, "gate", Dynamics::low); }) ==
        "class name 'gate' is taken");
  CHECK_THROWS_AS(catalog.add(ClassId{2}, " _-", Dynamics::low), InvalidValue);
  CHECK_THROWS_AS(catalog.add_alias("portal", "window"), UnknownClass);
  CHECK_THROWS_AS(catalog.add_alias("gate", "door"), InvalidId);
  CHECK_THROWS_AS(catalog.set_dynamics(ClassId{2}, Dynamics::low), UnknownClass);
  CHECK(catalog.size() == 1);
  CHECK_FALSE(catalog.find("window"));
  CHECK_FALSE(catalog.find("portal"));
}

TEST_CASE("the host's locale does not change what a name is", "[types][regression]") {
  CHECK(detail::normalized_class_name("DINING\tTable_\xC9") == "dining table \xC9");
  const std::string was = std::setlocale(LC_ALL, nullptr);
  for (const char* const name : {"tr_TR.UTF-8", "de_DE.ISO-8859-1", "C.UTF-8"}) {
    std::setlocale(LC_ALL, name);  // where the machine has it
    CHECK(ClassCatalog::coco80().at("DINING TABLE") == ClassId{60});
    CHECK(detail::normalized_class_name("\xC9") == "\xC9");
  }
  std::setlocale(LC_ALL, was.c_str());
}

TEST_CASE("an empty catalog says that it is", "[types]") {
  CHECK(thrown<UnknownClass>([] { ClassCatalog().at("door"); }) ==
        "unknown class 'door'; the catalog is empty");
}
