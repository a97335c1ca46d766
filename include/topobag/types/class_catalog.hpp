// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/types/detail/class_names.hpp>
#include <topobag/types/dynamics.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// The semantic classes in use: label number, name and dynamics of each.
///
/// Names match after lower-casing and unifying space, `_` and `-`, and through aliases
/// (tv = tvmonitor, couch = sofa, …). An unknown name is an error that lists the nearest known
/// ones.
class ClassCatalog {
 public:
  /// An empty catalog, to be filled with `add`.
  ClassCatalog() = default;

  /// The paper's Table 3, numbered 1–16. Dynamics: Table 2 for chair, book, tv and desk; the
  /// hand-held things mouse, teddy_bear, cup, bucket and bag are medium, a car is high, the rest
  /// low.
  static ClassCatalog paper() { return from(detail::paper_classes); }

  /// The 80 classes of COCO, numbered 0–79. People, animals and vehicles are high; chairs, books
  /// and hand-held things medium; the rest low.
  static ClassCatalog coco80() { return from(detail::coco80_classes); }

  /// Adds a class. Throws InvalidId if the id or the (normalised) name is taken, InvalidValue for a
  /// name without a character.
  void add(ClassId id, std::string name, Dynamics dynamics) {
    const std::string key = detail::normalized_class_name(name);
    if (classes_.count(id) != 0) {
      throw InvalidId("class id " + std::to_string(value(id)) + " is taken by '" +
                      classes_.at(id).name + "'");
    }
    require_free(key, name);
    classes_.emplace(id, Class{std::move(name), dynamics});
    ids_.emplace(key, id);
  }

  /// Adds a second name for a known class. Throws UnknownClass, InvalidId if `alias` is taken, or
  /// InvalidValue when it has no character.
  void add_alias(std::string_view alias, std::string_view name) {
    const ClassId id = at(name);
    const std::string key = detail::normalized_class_name(alias);
    require_free(key, alias);
    ids_.emplace(key, id);
  }

  /// The class of a name, or nothing. O(log n).
  std::optional<ClassId> find(std::string_view name) const {
    const auto it = ids_.find(detail::normalized_class_name(name));
    if (it == ids_.end()) return std::nullopt;
    return it->second;
  }

  /// The class of a name. Throws UnknownClass, which lists the nearest known names.
  ClassId at(std::string_view name) const {
    if (const std::optional<ClassId> id = find(name)) return *id;
    std::string message = "unknown class '" + std::string(name) + "'";
    message += classes_.empty() ? "; the catalog is empty" : "; nearest known:";
    for (const std::string& near : nearest(name)) message += " '" + near + "'";
    throw UnknownClass(message);
  }

  bool contains(ClassId id) const noexcept { return classes_.count(id) != 0; }
  std::size_t size() const noexcept { return classes_.size(); }

  /// Throws UnknownClass.
  const std::string& name(ClassId id) const { return get(id).name; }

  /// Throws UnknownClass.
  Dynamics dynamics(ClassId id) const { return get(id).dynamics; }

  /// Overrides the dynamics of a class. Throws UnknownClass.
  void set_dynamics(ClassId id, Dynamics dynamics) {
    get(id);
    classes_.at(id).dynamics = dynamics;
  }

  /// All ids, ascending.
  std::vector<ClassId> ids() const {
    std::vector<ClassId> all;
    all.reserve(classes_.size());
    for (const auto& entry : classes_) all.push_back(entry.first);
    return all;
  }

 private:
  struct Class {
    std::string name;
    Dynamics dynamics;
  };

  template <typename Table>
  static ClassCatalog from(const Table& table) {
    ClassCatalog catalog;
    for (const auto& row : table) catalog.add(ClassId{row.number}, row.name, row.dynamics);
    for (const auto& [alias, name] : detail::class_aliases) {
      if (catalog.find(name) && !catalog.find(alias)) catalog.add_alias(alias, name);
    }
    return catalog;
  }

  const Class& get(ClassId id) const {
    const auto it = classes_.find(id);
    if (it == classes_.end()) {
      throw UnknownClass("class id " + std::to_string(value(id)) + " is not in the catalog");
    }
    return it->second;
  }

  void require_free(const std::string& key, std::string_view name) const {
    if (key.empty())
      throw InvalidValue("a class name needs a character other than space, '_' and '-'");
    if (ids_.count(key) != 0) throw InvalidId("class name '" + std::string(name) + "' is taken");
  }

  /// The three known names at the smallest edit distance, nearest first.
  std::vector<std::string> nearest(std::string_view name) const {
    const std::string key = detail::normalized_class_name(name);
    std::vector<std::pair<std::size_t, std::string>> ranked;
    for (const auto& entry : ids_) {
      ranked.emplace_back(detail::edit_distance(key, entry.first), entry.first);
    }
    std::sort(ranked.begin(), ranked.end());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < ranked.size() && i < 3; ++i) names.push_back(ranked[i].second);
    return names;
  }

  std::map<ClassId, Class> classes_;
  std::map<std::string, ClassId> ids_;  ///< normalised names and aliases
};

namespace detail {

/// Throws UnknownClass with the detection's index when the catalog does not hold its class.
inline void require_known(const ClassCatalog& catalog, ClassId label, std::size_t detection) {
  if (catalog.contains(label)) return;
  throw UnknownClass("detection " + std::to_string(detection) + " has class id " +
                         std::to_string(value(label)) +
                         ", which the catalog does not hold: add it, or have detection_traits "
                         "number classes as the catalog does",
                     detection);
}

}  // namespace detail

}  // namespace v0
}  // namespace topobag
