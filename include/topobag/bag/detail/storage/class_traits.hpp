// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <topobag/bag/described_catalog.hpp>
#include <topobag/error.hpp>
#include <topobag/types/detail/value_lines.hpp>
#include <topobag/types/dynamics.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// What files keep of a class beside its name, taken in by `describe_class`.
struct ClassTraits {
  std::int64_t dynamics = 0;                  ///< as in `Dynamics`
  std::optional<ClassId> lookalike;           ///< the least class of its group
  std::optional<std::array<double, 2>> size;  ///< 0 = it has none
};

/// Whether it is a width and a height, m, that a class may have.
inline bool is_size(const std::array<double, 2>& size) {
  const auto [width, height] = size;
  return width > 0.0 && height > 0.0 && std::isfinite(width) && std::isfinite(height);
}

/// Throws FormatError for what no class has.
inline void describe_class(DescribedCatalog& classes, ClassId id, const ClassTraits& traits) {
  if (traits.dynamics < 0 || traits.dynamics > 2) {
    throw FormatError("its classes' dynamics are damaged");
  }
  classes.catalog.set_dynamics(id, static_cast<Dynamics>(traits.dynamics));
  if (traits.lookalike) {
    if (!classes.lookalikes) classes.lookalikes.emplace();
    if (!classes.catalog.contains(*traits.lookalike)) {
      throw FormatError("its classes' look-alikes are damaged");
    }
    if (*traits.lookalike != id) classes.lookalikes->join(id, *traits.lookalike);
  }
  if (traits.size) {
    if (!classes.sizes) classes.sizes.emplace();
    if (*traits.size == std::array<double, 2>{}) return;
    if (!is_size(*traits.size)) throw FormatError("its classes' typical sizes are damaged");
    (*classes.sizes)[id] = *traits.size;
  }
}

/// Of a class of the catalog. Throws InvalidValue for a size that could not be read again.
inline ClassTraits traits_of(const DescribedCatalog& classes, ClassId id) {
  ClassTraits traits;
  traits.dynamics = static_cast<std::int64_t>(classes.catalog.dynamics(id));
  if (classes.lookalikes) {
    const std::vector<ClassId> others = lookalikes_of(classes, id);
    traits.lookalike = others.empty() ? id : std::min(id, others.front());
  }
  if (!classes.sizes) return traits;
  traits.size = typical_size(classes, id);
  if (*traits.size != std::array<double, 2>{} && !is_size(*traits.size)) {
    const auto [width, height] = *traits.size;
    throw InvalidValue("class '" + classes.catalog.name(id) + "' is said to be " +
                       exact_text(width) + " x " + exact_text(height) +
                       " m; give a width and a height above 0, or leave its size out");
  }
  return traits;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
