// SPDX-License-Identifier: MIT
#include "object_classes.hpp"

#include <string>

#include "catch.hpp"
#include "scratch.hpp"
#include "warehouse_files.hpp"

using topobag::ClassId;
using topobag::Dynamics;

namespace {

/// What is said of a file of classes.
std::string class_complaint(const std::string& text) {
  const ScratchFolder folder;
  return error_in(folder, [&] { program::read_object_classes(folder.write("c.txt", text)); });
}

}  // namespace

TEST_CASE("a file of classes numbers them, and says what moves and what looks alike",
          "[examples]") {
  const ScratchFolder folder;
  const auto classes = program::read_object_classes(folder.write("classes.txt", warehouse_classes));
  const topobag::ClassCatalog& catalog = classes.catalog;
  CHECK(catalog.size() == 20);
  CHECK(catalog.at("forklift") == ClassId{0});
  CHECK(catalog.at("Pallet_Jack") == ClassId{1});
  CHECK(catalog.name(ClassId{19}) == "safety mirror");
  CHECK(catalog.dynamics(ClassId{0}) == Dynamics::high);
  CHECK(catalog.dynamics(catalog.at("crate")) == Dynamics::medium);
  CHECK(catalog.dynamics(catalog.at("loaded pallet")) == Dynamics::low);
  const auto alike = [&](const char* a, const char* b) {
    return classes.lookalikes.compatible(catalog.at(a), catalog.at(b));
  };
  CHECK(alike("crate", "loaded pallet"));
  CHECK(alike("carton", "tote"));
  CHECK_FALSE(alike("carton", "crate"));
}

TEST_CASE("a file of names alone is one of classes", "[examples]") {
  const ScratchFolder folder;
  const auto classes = program::read_object_classes(folder.write("c.txt", "pallet jack\r\ntv\n"));
  CHECK(classes.catalog.ids() == std::vector<ClassId>{ClassId{0}, ClassId{1}});
  CHECK(classes.catalog.name(ClassId{0}) == "pallet jack");
}

TEST_CASE("look-alikes are what the file says, and no others", "[examples]") {
  const ScratchFolder folder;
  const auto one_object = [](const program::ObjectClasses& classes) {
    return program::recognition_options_for(classes).matching.consistency.classes.compatible(
        classes.catalog.at("tv"), classes.catalog.at("laptop"));
  };
  CHECK(one_object({}));
  CHECK(one_object(program::read_object_classes(folder.write("a", "tv,,laptop\nlaptop\n"))));
  CHECK_FALSE(one_object(program::read_object_classes(folder.write("b", "tv\nlaptop\n"))));
}

TEST_CASE("what is wrong in a file of classes is told with its line", "[examples]") {
  CHECK(class_complaint("# none\n\n") == "c.txt: there is no class in the file");
  CHECK(class_complaint("fire_hose\ntote\nFire Hose\n") ==
        "c.txt:3: 'Fire Hose' is class 0 already; give each class a name of its own");
  CHECK(class_complaint("tote\n\ndrum, fast\n") ==
        "c.txt:3: the dynamics 'fast' are none of low, medium and high");
  CHECK(class_complaint("tote, low, drums\ndrum\n") ==
        "c.txt:1: unknown class 'drums'; nearest known: 'drum' 'tote'");
  CHECK(class_complaint("tote, low, drum |\ndrum\n").find("c.txt:1: unknown class ''") == 0);
  CHECK(class_complaint("tote, low, , 1 x 1, 0.4\n") ==
        "c.txt:1: a line is: name[, dynamics[, look-alikes[, typical size]]]");
  CHECK(class_complaint("tote\n, low\n").find("c.txt:2: a class name needs a character") == 0);
}

TEST_CASE("sizes in centimetres and names that are none are refused", "[examples][regression]") {
  CHECK(class_complaint("tv, low, , 50 x 30\n") ==
        "c.txt:1: the typical size '50 x 30' is larger than 20 m: sizes are in metres, 50 cm is "
        "0.5");
  CHECK(class_complaint("lorry, high, , 18.75 x 4\n") == "nothing was thrown");
  const std::string line = ": a line is name[, dynamics[, look-alikes[, typical size]]]";
  CHECK(class_complaint("0\n1\n") == "c.txt:1: '0' has no letter, which a class's name has" + line);
  CHECK(class_complaint("tv\n1: person\n") ==
        "c.txt:2: '1: person' is a number and a name" + line +
            ", and a class has the number of its line, from 0");
  CHECK(class_complaint("tv;low\n") ==
        "c.txt:1: 'tv;low' holds a semicolon" + line + ", separated by commas");
  CHECK(class_complaint("tv\tlow\n").find("c.txt:1: 'tv\tlow' holds a tab") == 0);
  CHECK(class_complaint("3d printer\nM\xC3\xB6"
                        "bel\n\xE6\xA4\x85\n") == "nothing was thrown");
}
