// SPDX-License-Identifier: MIT
#include "class_list.hpp"

#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

TEST_CASE("a class list names known classes, and a file without one is refused", "[examples]") {
  const ScratchFolder folder;
  const auto catalog = topobag::ClassCatalog::coco80();
  const std::string list = folder.write("names.txt", "tv\r\nlaptop\r\n");
  CHECK(program::read_class_list(list, catalog) ==
        std::vector<topobag::ClassId>{catalog.at("tv"), catalog.at("laptop")});
  const std::string empty = folder.write("empty.txt", "\n");
  CHECK(error_text([&] { program::read_class_list(empty, catalog); }) ==
        empty + ": there is no class in the file");
  const std::string odd = folder.write("odd.txt", "tv\nlap top\n");
  CHECK(error_text([&] { program::read_class_list(odd, catalog); }).find(odd + ":2: ") == 0);
}
