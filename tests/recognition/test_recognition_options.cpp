// SPDX-License-Identifier: MIT
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the options for a catalog join what detectors mix up", "[recognition]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  const RecognitionOptions options = recognition_options(catalog);
  CHECK(options.matching.consistency.classes.compatible(*catalog.find("tv"),
                                                        *catalog.find("laptop")));
  CHECK_FALSE(RecognitionOptions{}.matching.consistency.classes.compatible(
      *catalog.find("tv"), *catalog.find("laptop")));
}
