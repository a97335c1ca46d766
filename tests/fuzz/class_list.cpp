// SPDX-License-Identifier: MIT
// Text that claims to name a network's classes: refused with an Error, or classes of the catalog.
#include "class_list.hpp"

#include "fuzz/fuzz_input.hpp"
#include "scratch_folder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFolder folder;
  static const topobag::ClassCatalog catalog = topobag::ClassCatalog::coco80();
  const std::string path = folder.write("names.txt", FuzzInput(data, size).rest());
  try {
    const auto classes = program::read_class_list(path, catalog);
    require(!classes.empty(), "a list names a class");
    for (const topobag::ClassId id : classes) require(catalog.contains(id), "a class is known");
  } catch (const topobag::Error&) {
  }
  return 0;
}
