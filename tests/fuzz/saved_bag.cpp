// SPDX-License-Identifier: MIT
// Bytes that claim to be a saved bag: refused with an Error, or a bag that is saved and loaded
// again.
#include <sstream>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/bag/snapshot.hpp>

#include "fuzz/fuzz_input.hpp"

namespace {

template <typename Bag, typename Saved>
void load_and_save(const std::string& bytes, const Saved& saved_of) {
  std::istringstream stream(bytes);
  std::string once;
  try {
    once = saved_of(topobag::load<Bag>(stream));
  } catch (const topobag::Error&) {
    return;
  }
  std::istringstream again(once);
  require(saved_of(topobag::load<Bag>(again)) == once, "what was loaded is saved and loaded");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = FuzzInput(data, size).rest();
  load_and_save<topobag::BagOfTopologyGraphs<>>(bytes, [](const auto& bag) {
    std::ostringstream out;
    topobag::save(bag, out);
    return out.str();
  });
  load_and_save<topobag::IndexedBag>(bytes, [](const auto& bag) {
    std::ostringstream out;
    topobag::save(*bag.view(), out);
    return out.str();
  });
  return 0;
}
