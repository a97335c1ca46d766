// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/recognition/detail/session_order.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the next of a session are its nearest ids, whoever else is between", "[recognition]") {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    BagOfTopologyGraphs<> bag;
    std::map<KeyframeId, std::uint32_t> sessions;
    for (std::size_t i = random() % 40; i > 0; --i) {
      sessions[KeyframeId{random() % 100}] = static_cast<std::uint32_t>(random() % 2);
    }
    for (const auto& [id, session] : sessions) {
      EntryInfo info;
      info.session = session;
      bag.add(id, {}, info);
    }
    const KeyframeId of{random() % 100};
    const std::size_t count = random() % 5;
    EntryInfo own;
    own.session = static_cast<std::uint32_t>(random() % 2);
    for (const bool above : {true, false}) {
      std::vector<KeyframeId> expected;
      for (const auto& [id, session] : sessions) {
        if (session == own.session && (above ? id > of : id < of)) expected.push_back(id);
      }
      if (!above) std::reverse(expected.begin(), expected.end());
      expected.resize(std::min(expected.size(), count));
      const auto found = detail::next_of_session(bag, of, own, above, count);
      // One that many of another session hide is not found; none is made up.
      REQUIRE(found.size() <= expected.size());
      CHECK(std::equal(found.begin(), found.end(), expected.begin()));
      if (sessions.size() < 16) CHECK(found == expected);
    }
  }
}

TEST_CASE("a bag that does not tell its ids is asked for the next numbers", "[recognition]") {
  struct Plain {
    std::optional<EntryInfo> info(KeyframeId id) const {
      return value(id) % 10 < 7 ? std::optional<EntryInfo>(EntryInfo{}) : std::nullopt;
    }
  };
  const std::vector<KeyframeId> above{KeyframeId{6}, KeyframeId{10}, KeyframeId{11}};
  const std::vector<KeyframeId> below{KeyframeId{4}, KeyframeId{3}};
  CHECK(detail::next_of_session(Plain{}, KeyframeId{5}, {}, true, 3) == above);
  CHECK(detail::next_of_session(Plain{}, KeyframeId{5}, {}, false, 2) == below);
}
