// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/place_contents.hpp>
#include <topobag/bag/query.hpp>

namespace reading_calls {

template <typename Bag, typename Call>
auto compiles(const Call& call, int) -> decltype(call(std::declval<const Bag&>()), true) {
  return true;
}
template <typename Bag, typename Call>
bool compiles(const Call&, long) {
  return false;
}

}  // namespace reading_calls

/// Which of the calls that every bag has to answer `Bag` does not have.
template <typename Bag>
std::string missing_calls_of() {
  using namespace topobag;
  std::string missing;
  const auto need = [&](const char* name, const auto& call) {
    if (!reading_calls::compiles<Bag>(call, 0)) missing += std::string(name) + ' ';
  };
#define TOPOBAG_TESTS_CALL(name, ...) \
  need(name, [](const auto& bag) -> decltype(bag.__VA_ARGS__) { return bag.__VA_ARGS__; })
  TOPOBAG_TESTS_CALL("size", size());
  TOPOBAG_TESTS_CALL("empty", empty());
  TOPOBAG_TESTS_CALL("contains", contains(KeyframeId{}));
  TOPOBAG_TESTS_CALL("find", find(KeyframeId{}));
  TOPOBAG_TESTS_CALL("info", info(KeyframeId{}));
  TOPOBAG_TESTS_CALL("after", after(KeyframeId{}));
  TOPOBAG_TESTS_CALL("before", before(KeyframeId{}));
  TOPOBAG_TESTS_CALL("within", within(MapRegion{}));
  TOPOBAG_TESTS_CALL("query", query(TopologyGraph<>{}, QueryOptions{}));
  TOPOBAG_TESTS_CALL("places", places());
  TOPOBAG_TESTS_CALL("places_holding", places_holding(ClassCounts{}, ClassGroups{}));
  TOPOBAG_TESTS_CALL("appearance_kind", appearance_kind());
  TOPOBAG_TESTS_CALL("image_kind", image_kind());
#undef TOPOBAG_TESTS_CALL
  return missing;
}
