// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detail/value_lines.hpp>
#include <topobag/types/dynamics.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Width and height, m, that the objects of a class usually have; of those for which it is said.
using TypicalSizes = std::map<ClassId, std::array<double, 2>>;

/// A class catalog and what else is said of its classes: what a map keeps of them. Aliases are not
/// kept.
struct DescribedCatalog {
  DescribedCatalog() = default;
  /// Without saying which classes look alike or how large they are.
  DescribedCatalog(ClassCatalog names) : catalog(std::move(names)) {}

  ClassCatalog catalog;                   ///< ids, names and dynamics
  std::optional<ClassGroups> lookalikes;  ///< taken for one another; nothing: not said
  std::optional<TypicalSizes> sizes;      ///< > 0, m; nothing: not said of any class
  std::string source = "yours";           ///< what a message calls it, such as the file's name
};

namespace detail {

inline const char* dynamics_name(Dynamics dynamics) {
  switch (dynamics) {
    case Dynamics::low:
      return "low";
    case Dynamics::medium:
      return "medium";
    case Dynamics::high:
      break;
  }
  return "high";
}

/// The other classes of the catalog that look like `id`, ascending.
inline std::vector<ClassId> lookalikes_of(const DescribedCatalog& classes, ClassId id) {
  std::vector<ClassId> others = classes.lookalikes->members(id);
  const auto left_out = [&](ClassId other) {
    return other == id || !classes.catalog.contains(other);
  };
  others.erase(std::remove_if(others.begin(), others.end(), left_out), others.end());
  return others;
}

/// Width and height, m; 0 of a class for which none is said.
inline std::array<double, 2> typical_size(const DescribedCatalog& classes, ClassId id) {
  const auto found = classes.sizes->find(id);
  return found == classes.sizes->end() ? std::array<double, 2>{} : found->second;
}

inline std::string lookalikes_text(const DescribedCatalog& classes, ClassId id) {
  std::string text;
  for (const ClassId other : lookalikes_of(classes, id)) {
    text += (text.empty() ? "" : " and ") + ("'" + classes.catalog.name(other) + "'");
  }
  return text.empty() ? "no other" : text;
}

inline std::string size_text(const DescribedCatalog& classes, ClassId id) {
  const std::array<double, 2> size = typical_size(classes, id);
  if (size[0] == 0.0) return "of no typical size";
  return "typically " + exact_text(size[0]) + " x " + exact_text(size[1]) + " m";
}

}  // namespace detail

/// The first class of which two catalogs with the same fingerprint say different things, in a
/// sentence ("class 'forklift' is of high dynamics in the map and of low in warehouse.txt");
/// nothing where they agree. What one of them leaves unsaid is not compared. O(n log n).
/// @param map    what is called "the map"
/// @param other  of the same ids, called by its source
inline std::optional<std::string> difference(const DescribedCatalog& map,
                                             const DescribedCatalog& other) {
  for (const ClassId id : map.catalog.ids()) {
    const auto differs = [&](const std::string& verb, const std::string& in_map,
                             const std::string& in_other) {
      return "class '" + map.catalog.name(id) + "' " + verb + in_map + " in the map and " +
             in_other + " in " + other.source;
    };
    if (map.catalog.dynamics(id) != other.catalog.dynamics(id)) {
      return differs("is of ",
                     std::string(detail::dynamics_name(map.catalog.dynamics(id))) + " dynamics",
                     "of " + std::string(detail::dynamics_name(other.catalog.dynamics(id))));
    }
    if (map.lookalikes && other.lookalikes &&
        detail::lookalikes_of(map, id) != detail::lookalikes_of(other, id)) {
      return differs("looks like ", detail::lookalikes_text(map, id),
                     "like " + detail::lookalikes_text(other, id));
    }
    if (map.sizes && other.sizes &&
        detail::typical_size(map, id) != detail::typical_size(other, id)) {
      return differs("is ", detail::size_text(map, id), detail::size_text(other, id));
    }
  }
  return std::nullopt;
}

namespace detail {

/// Throws FormatError where there is a `difference`, with `where` before it.
inline void require_same_classes(const DescribedCatalog& map, const DescribedCatalog& other,
                                 const std::string& where = {}) {
  const std::optional<std::string> what = difference(map, other);
  if (what) throw FormatError(where + *what + "; open it with the classes that it was made with");
}

}  // namespace detail

}  // namespace v0
}  // namespace topobag
