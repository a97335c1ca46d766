// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam/saved_sightings.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

std::vector<SavedSighting> random_sightings(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  std::vector<SavedSighting> all(random() % 5);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].id = (std::uint64_t{random()} << 32) + i;
    all[i].session = static_cast<std::uint32_t>(random());
    KeyframeSighting& seen = all[i].sighting;
    seen.stamp = 1305031102.175304 + number(random);
    seen.nodes = random_nodes(random, random() % 9, 4, false);
    seen.view.camera = {525.0, 525.0, 319.5, 239.5, 640, 480};
    for (std::size_t k = random() % 4; k > 0; --k) {
      seen.view.occluders.push_back({{10.0, 20.0, 110.0, 220.0}, 4.0 * number(random)});
    }
    if (random() % 2 == 0) seen.gravity = normalized(Gravity<>{{0.1, 1.0, number(random)}, 0.02});
  }
  return all;
}

}  // namespace

TEST_CASE("sightings come back as they were saved, to the rounding of graphs", "[adaptors]") {
  std::size_t nodes = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const auto saved = random_sightings(seed);
    const std::vector<std::uint8_t> bytes = encode(saved);
    const auto back = decode_sightings(bytes);
    CHECK(encode(back) == bytes);
    REQUIRE(back.size() == saved.size());
    for (std::size_t i = 0; i < saved.size(); ++i) {
      CHECK(back[i].id == saved[i].id);
      CHECK(back[i].session == saved[i].session);
      const KeyframeSighting &was = saved[i].sighting, &is = back[i].sighting;
      CHECK(is.stamp == was.stamp);
      CHECK(is.view.occluders.size() == was.view.occluders.size());
      CHECK(is.view.camera.width == 640);
      CHECK(is.gravity.has_value() == was.gravity.has_value());
      REQUIRE(is.nodes.size() == was.nodes.size());
      for (std::size_t k = 0; k < was.nodes.size(); ++k, ++nodes) {
        CHECK(is.nodes[k].label == was.nodes[k].label);
        REQUIRE(is.nodes[k].position.has_value() == was.nodes[k].position.has_value());
        if (!was.nodes[k].position) continue;
        CHECK((*is.nodes[k].position - *was.nodes[k].position).norm() < 0.0035);
      }
    }
  }
  CHECK(nodes > 100);
}

TEST_CASE("damaged sightings are refused with a sentence, wherever the damage is", "[adaptors]") {
  std::vector<SavedSighting> saved;
  for (unsigned seed = 1; saved.size() < 3; ++seed) saved = random_sightings(seed);
  const std::vector<std::uint8_t> bytes = encode(saved);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK_THROWS_AS(decode_sightings({bytes.begin(), bytes.begin() + static_cast<long>(size)}),
                    FormatError);
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::vector<std::uint8_t> damaged = bytes;
    damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ (1U << at % 8));
    CHECK_THROWS_AS(decode_sightings(damaged), FormatError);
  }
  std::vector<std::uint8_t> longer = bytes;
  longer.push_back(0);
  CHECK_THROWS_AS(decode_sightings(longer), FormatError);
}

TEST_CASE("what is refused says why", "[adaptors]") {
  const auto said = [](std::vector<std::uint8_t> bytes) {
    return error_text([&] { decode_sightings(bytes); });
  };
  CHECK(said({}) == "these are no sightings of topobag, or they are cut off");
  std::vector<std::uint8_t> bytes = encode(std::vector<SavedSighting>{});
  CHECK(decode_sightings(bytes).empty());
  bytes[8] = 2;
  CHECK(said(bytes) == "sightings of format 2; this version of topobag reads 1: update topobag");
  bytes[8] = 1;
  bytes[12] = 1;
  CHECK(said(bytes) == "the sightings are damaged or cut off; take a complete copy");
  SavedSighting seen;
  seen.id = 7;
  CHECK(said(encode(std::vector<SavedSighting>{seen, seen})) ==
        "the sightings hold key frame 7 twice");
  seen.sighting.stamp = std::numeric_limits<double>::infinity();
  CHECK(said(encode(std::vector<SavedSighting>{seen})) ==
        "a sighting's stamp is not finite: it is damaged");
}

TEST_CASE("a saved map is recognised in after it was loaded", "[adaptors]") {
  using atlas_host::Pointers;
  atlas_host::Session before(11);
  before.mapped(0.0, before.first);
  before.mapped(50.0, before.first);
  const std::vector<std::uint8_t> bytes = encode(before.database.sightings());

  // The host has loaded its key frames before anybody could listen.
  const bool sightings_first = GENERATE(false, true);
  atlas_host::Session after(11);
  atlas_host::KeyFrame& a = after.made(0.0, after.first);
  atlas_host::KeyFrame& b = after.made(50.0, after.first);
  REQUIRE(a.T_world_camera.isApprox(before.key_frames[0]->T_world_camera));
  if (sightings_first) CHECK(after.database.restore(decode_sightings(bytes)) == 2);
  for (atlas_host::KeyFrame* key_frame : {&a, &b}) after.database.add(key_frame);
  if (!sightings_first) CHECK(after.database.restore(decode_sightings(bytes)) == 2);
  CHECK(after.database.size() == 2);

  // Its clock went on from where ours starts: never the present visit.
  atlas_host::KeyFrame& now = after.mapped(40.0, after.second);
  Pointers loops, merges;
  after.database.DetectNBestCandidates(&now, loops, merges, 3);
  CHECK(loops.empty());
  CHECK(merges.size() == 2);
  now.map = &after.first;  // merged
  loops.clear();
  merges.clear();
  after.database.DetectNBestCandidates(&now, loops, merges, 3);
  CHECK(loops.size() == 2);
  CHECK(merges.empty());
}

TEST_CASE("runs are told apart when they are saved and loaded again", "[adaptors]") {
  atlas_host::Session session(12);
  const auto sessions = [&] {
    std::vector<std::uint32_t> numbers;
    for (const SavedSighting& saved : session.database.sightings()) {
      numbers.push_back(saved.session);
    }
    return numbers;
  };
  session.mapped(0.0, session.first);
  std::vector<SavedSighting> first = session.database.sightings();
  first[0].id = 1;
  CHECK(session.database.restore(first) == 1);
  CHECK(sessions() == std::vector<std::uint32_t>{0, 1});
  std::vector<SavedSighting> both = session.database.sightings();
  both[0].id = 2;
  both[1].id = 3;
  CHECK(session.database.restore(both) == 2);
  CHECK(sessions() == std::vector<std::uint32_t>{0, 1, 2, 3});
}
