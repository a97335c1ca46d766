// SPDX-License-Identifier: MIT
#include <topobag/types/catalog_fingerprint.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a fingerprint tells catalogs apart by ids and names alone", "[types]") {
  ClassCatalog catalog;
  catalog.add(ClassId{3}, "Potted Plant", Dynamics::low);
  catalog.add(ClassId{7}, "cup", Dynamics::medium);
  ClassCatalog same;
  same.add(ClassId{7}, "Cup", Dynamics::high);
  same.add(ClassId{3}, "potted_plant", Dynamics::low);
  same.add_alias("mug", "cup");
  CHECK(fingerprint(catalog) == fingerprint(same));

  ClassCatalog renumbered;
  renumbered.add(ClassId{7}, "potted plant", Dynamics::low);
  renumbered.add(ClassId{3}, "cup", Dynamics::medium);
  CHECK(fingerprint(renumbered) != fingerprint(catalog));
  same.add(ClassId{8}, "book", Dynamics::medium);
  CHECK(fingerprint(same) != fingerprint(catalog));
}

TEST_CASE("the built-in catalogs' fingerprints stay as files have them", "[types]") {
  CHECK(fingerprint(ClassCatalog::coco80()) == 0xad8ee642db396a5c);
  CHECK(fingerprint(ClassCatalog::paper()) == 0x7c16f08779a64da1);
}
