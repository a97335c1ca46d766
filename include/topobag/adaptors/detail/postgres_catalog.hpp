// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <topobag/adaptors/detail/postgres_connection.hpp>
#include <topobag/adaptors/detail/postgres_parameters.hpp>
#include <topobag/adaptors/detail/postgres_result.hpp>
#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/detail/storage/class_traits.hpp>
#include <topobag/error.hpp>
#include <topobag/types/catalog_fingerprint.hpp>
#include <topobag/types/dynamics.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Notes what is said of the classes of a site that has none yet.
inline void write_classes(PostgresConnection& connection, const std::string& site,
                          const DescribedCatalog& classes) {
  const std::vector<ClassId> ids = classes.catalog.ids();
  const auto side = [&](std::size_t i) {
    return [&classes, i](ClassId id) {
      const ClassTraits traits = traits_of(classes, id);
      return traits.size ? std::optional<double>((*traits.size)[i]) : std::nullopt;
    };
  };
  PostgresParameters parameters;
  parameters.add(postgres_text, site)
      .add_array(postgres_int8, ids, [](ClassId id) { return std::int64_t{value(id)}; })
      .add_array(postgres_bytea, ids, [&](ClassId id) { return classes.catalog.name(id); })
      .add_array(postgres_int8, ids, [&](ClassId id) { return traits_of(classes, id).dynamics; })
      .add_array(postgres_int8, ids,
                 [&](ClassId id) {
                   const ClassTraits traits = traits_of(classes, id);
                   return traits.lookalike ? std::optional<std::int64_t>(value(*traits.lookalike))
                                           : std::nullopt;
                 })
      .add_array(postgres_float8, ids, side(0))
      .add_array(postgres_float8, ids, side(1));
  connection.run(
      "INSERT INTO topobag.class(site, id, name, dynamics, lookalike, width, height)"
      " SELECT $1, * FROM unnest($2, $3, $4, $5, $6, $7)",
      parameters);
}

/// What a site says of its classes; nothing of one that says no more than their fingerprint, or
/// that may not be read. Throws FormatError when it is damaged.
inline std::optional<DescribedCatalog> read_classes(PostgresConnection& connection,
                                                    const std::string& site) {
  const PostgresResult rows = connection.run(
      "SELECT id, name, dynamics, lookalike, width, height FROM topobag.class WHERE site = $1",
      PostgresParameters().add(postgres_text, site));
  if (rows.rows() == 0) return std::nullopt;
  const auto id_of = [&](int row, int column) {
    return ClassId{static_cast<std::int32_t>(rows.integer(row, column))};
  };
  try {
    DescribedCatalog classes;
    for (int row = 0; row < rows.rows(); ++row) {
      classes.catalog.add(id_of(row, 0), rows.text(row, 1), Dynamics::low);
    }
    for (int row = 0; row < rows.rows(); ++row) {
      ClassTraits traits;
      traits.dynamics = rows.integer(row, 2);
      if (!rows.is_null(row, 3)) traits.lookalike = id_of(row, 3);
      if (const auto width = rows.number(row, 4)) {
        traits.size = std::array<double, 2>{*width, rows.number(row, 5).value_or(0.0)};
      }
      describe_class(classes, id_of(row, 0), traits);
    }
    return classes;
  } catch (const Error& error) {
    throw FormatError(connection.name() + ": the classes of site '" + site +
                      "' cannot be read: " + error.what());
  }
}

/// Throws FormatError for a site whose classes have other names, or of which it says something
/// else.
inline void require_site_classes(PostgresConnection& connection, const std::string& site,
                                 const DescribedCatalog& classes) {
  const std::optional<DescribedCatalog> kept = read_classes(connection, site);
  if (!kept) return;
  const std::string where = connection.name() + ": site '" + site + "': ";
  if (fingerprint(kept->catalog) != fingerprint(classes.catalog)) {
    throw FormatError(where +
                      "its class numbers mean other names than yours; open it with the catalog "
                      "that it was made with");
  }
  require_same_classes(*kept, classes, where);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
