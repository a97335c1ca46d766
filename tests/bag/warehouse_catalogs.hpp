// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <topobag/bag/described_catalog.hpp>

/// Five classes of a warehouse, of which pallets and crates look alike and two have a size.
inline topobag::DescribedCatalog warehouse() {
  using topobag::ClassId;
  topobag::ClassCatalog names;
  names.add(ClassId{-3}, "forklift", topobag::Dynamics::high);
  names.add(ClassId{0}, "pallet", topobag::Dynamics::low);
  names.add(ClassId{2}, "crate", topobag::Dynamics::medium);
  names.add(ClassId{7}, "loaded pallet", topobag::Dynamics::low);
  names.add(ClassId{2000000000}, "safety mirror", topobag::Dynamics::low);
  topobag::DescribedCatalog classes(names);
  classes.lookalikes.emplace();
  classes.lookalikes->join(ClassId{7}, ClassId{0});
  classes.lookalikes->join(ClassId{7}, ClassId{2});
  classes.sizes = {{ClassId{0}, {1.2, 0.15}}, {ClassId{2}, {1.0 / 3.0, 0.3}}};
  return classes;
}

/// The warehouse with one thing said otherwise, and the sentence that tells it of a map of the
/// warehouse.
inline std::vector<std::pair<topobag::DescribedCatalog, std::string>> other_warehouses() {
  using topobag::ClassId;
  std::vector<std::pair<topobag::DescribedCatalog, std::string>> others;
  const auto add = [&](const auto& change, const std::string& sentence) {
    topobag::DescribedCatalog other = warehouse();
    other.source = "hall.txt";
    change(other);
    others.emplace_back(other, sentence);
  };
  add([](auto& other) { other.catalog.set_dynamics(ClassId{-3}, topobag::Dynamics::low); },
      "class 'forklift' is of high dynamics in the map and of low in hall.txt");
  add([](auto& other) { other.lookalikes->join(ClassId{7}, ClassId{2000000000}); },
      "class 'pallet' looks like 'crate' and 'loaded pallet' in the map and like 'crate' and "
      "'loaded pallet' and 'safety mirror' in hall.txt");
  add(
      [](auto& other) {
        other.lookalikes.emplace();
        other.lookalikes->join(ClassId{7}, ClassId{2});
      },
      "class 'pallet' looks like 'crate' and 'loaded pallet' in the map and like no other in "
      "hall.txt");
  add(
      [](auto& other) {
        (*other.sizes)[ClassId{0}] = {1.2, 0.2};
      },
      "class 'pallet' is typically 1.2 x 0.15 m in the map and typically 1.2 x 0.2 m in hall.txt");
  add([](auto& other) { other.sizes->erase(ClassId{0}); },
      "class 'pallet' is typically 1.2 x 0.15 m in the map and of no typical size in hall.txt");
  add(
      [](auto& other) {
        (*other.sizes)[ClassId{7}] = {1.0, 2.0};
      },
      "class 'loaded pallet' is of no typical size in the map and typically 1 x 2 m in hall.txt");
  return others;
}
