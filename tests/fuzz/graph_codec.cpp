// SPDX-License-Identifier: MIT
// Bytes that claim to be a graph: refused with an Error, or a graph that is encoded to bytes which
// give the same bytes for ever.
#include <vector>

#include <topobag/bag/graph_codec.hpp>

#include "fuzz/fuzz_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> once;
  try {
    once = topobag::encode(topobag::decode<double>(data, size));
  } catch (const topobag::Error&) {
    return 0;
  }
  require(topobag::encode(topobag::decode<double>(once)) == once, "encoding settles");
  return 0;
}
