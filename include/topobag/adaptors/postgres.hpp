// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/detail/postgres_append.hpp>
#include <topobag/adaptors/detail/postgres_catalog.hpp>
#include <topobag/adaptors/detail/postgres_connection.hpp>
#include <topobag/adaptors/detail/postgres_parameters.hpp>
#include <topobag/adaptors/detail/postgres_rows.hpp>
#include <topobag/adaptors/detail/postgres_schema.hpp>
#include <topobag/adaptors/fleet/fleet_cursor.hpp>
#include <topobag/adaptors/fleet/fleet_site.hpp>
#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/adaptors/fleet/uuid.hpp>
#include <topobag/bag/described_catalog.hpp>
#include <topobag/error.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

namespace topobag {
inline namespace v0 {

/// The fleet's system of record on PostgreSQL: every version of every key frame, appended, never
/// changed, partitioned by site. It connects when it is asked something and again after a
/// connection was lost; a call that throws has changed nothing, but for an `append` whose
/// acknowledgement was lost, which can be repeated. Not for two threads at once. Every error begins
/// with the server's address. (Tables and roles: `examples/docs/fleet.md`.)
class PostgresStore {
 public:
  /// @param conninfo  as libpq reads it: postgresql://host/base, or host=… dbname=…; passwords and
  ///                  TLS are libpq's
  /// @param silence   how long the server may say nothing before it counts as lost
  explicit PostgresStore(std::string conninfo,
                         std::chrono::milliseconds silence = std::chrono::seconds(30))
      : conninfo_(std::move(conninfo)), silence_(silence) {}

  /// Makes an empty data base a fleet's map, or an older one of the present schema; for its owner.
  /// Throws FormatError for a later schema, Error for who may not.
  void prepare() {
    detail::PostgresConnection connection(conninfo_, silence_);
    detail::migrate_schema(connection, detail::postgres_migrations);
  }

  /// Makes a site; for the owner.
  /// @param catalog  fingerprint of the classes of its maps; 0 where they state none
  void add_site(const std::string& name, std::uint64_t catalog) {
    connection().run("SELECT topobag.add_site($1, $2)", detail::PostgresParameters()
                                                            .add(detail::postgres_text, name)
                                                            .add(detail::postgres_int8, catalog));
  }

  /// The same, and keeps what is said of the classes with the site.
  void add_site(const std::string& name, const DescribedCatalog& classes) {
    detail::PostgresConnection& server = connection();
    detail::PostgresTransaction transaction(server);
    add_site(name, fingerprint(classes.catalog));
    detail::write_classes(server, name, classes);
    transaction.commit();
  }

  /// What a site that may be read says of its classes; nothing where that is no more than their
  /// fingerprint. Throws FormatError when it is damaged. O(classes).
  std::optional<DescribedCatalog> site_catalog(const std::string& name) {
    return detail::read_classes(connection(), name);
  }

  /// Throws FormatError for a site whose classes have other names, or of which it says something
  /// else; what either leaves unsaid is not compared. O(classes · log classes).
  void require_classes(const std::string& name, const DescribedCatalog& classes) {
    detail::require_site_classes(connection(), name, classes);
  }

  /// Lets a role read a site, and add versions of one robot there where one is named; for the
  /// owner.
  void admit(const std::string& role, const std::string& site,
             const std::optional<Uuid>& robot = std::nullopt) {
    detail::PostgresParameters parameters;
    parameters.add(detail::postgres_text, role).add(detail::postgres_text, site);
    if (!robot) {
      connection().run("INSERT INTO topobag.access VALUES ($1::name, $2)", parameters);
    } else {
      parameters.add(detail::postgres_uuid, *robot);
      connection().run(
          "INSERT INTO topobag.access VALUES ($1::name, $2, $3) ON CONFLICT DO NOTHING",
          parameters);
    }
  }

  /// Whether the server knows a role of this name.
  bool has_role(const std::string& name) {
    return connection()
        .run("SELECT EXISTS (SELECT FROM pg_roles WHERE rolname = $1::name)",
             detail::PostgresParameters().add(detail::postgres_text, name))
        .flag(0, 0);
  }

  /// The sites that may be read. O(sites).
  std::vector<std::string> site_names() {
    const auto rows = connection().run("SELECT site FROM topobag.site ORDER BY site");
    std::vector<std::string> names;
    for (int row = 0; row < rows.rows(); ++row) names.push_back(rows.text(row, 0));
    return names;
  }

  /// The sites that may be read, by name, and what is there. O(versions).
  std::vector<FleetSite> sites() {
    const auto rows = connection().run(
        "SELECT s.site, s.catalog, count(v), count(DISTINCT v.robot) FROM topobag.site AS s"
        " LEFT JOIN topobag.version AS v USING (site) GROUP BY s.site ORDER BY s.site");
    std::vector<FleetSite> sites;
    for (int row = 0; row < rows.rows(); ++row) {
      sites.push_back({rows.text(row, 0), rows.bits(row, 1),
                       static_cast<std::size_t>(rows.bits(row, 2)),
                       static_cast<std::size_t>(rows.bits(row, 3))});
    }
    return sites;
  }

  /// The greatest `seq` of a robot's sessions that the server holds; 0 = none.
  /// O(sessions · log versions).
  std::int64_t last_seq(const std::string& site, const Uuid& robot,
                        const std::vector<Uuid>& sessions) {
    const auto rows = connection().run(
        "SELECT coalesce(max(last), 0) FROM unnest($3) AS s(session), LATERAL (SELECT max(seq)"
        " FROM topobag.version AS v WHERE v.site = $1 AND v.robot = $2 AND v.session = s.session)"
        " AS of_session(last)",
        detail::PostgresParameters()
            .add(detail::postgres_text, site)
            .add(detail::postgres_uuid, robot)
            .add_array(detail::postgres_uuid, sessions, [](const Uuid& uuid) { return uuid; }));
    return rows.integer(0, 0);
  }

  /// Adds those of the versions that the server lacks, in one transaction: durable when the call
  /// returns. Returns how many. Throws Error for a site that is not there or a robot that is not
  /// the role's, FormatError for other classes than the site's, InvalidId when the server holds
  /// another content under the same number: two copies of one map are in use.
  std::size_t append(const std::vector<FleetVersion>& versions) {
    if (versions.empty()) return 0;
    detail::PostgresConnection& server = connection();
    detail::PostgresTransaction transaction(server);
    const std::size_t added = detail::append_versions(server, versions);
    transaction.commit();
    return added;
  }

  /// Throws what `append` would of a version like this one, and adds nothing either way.
  void require_taken(const FleetVersion& version) {
    detail::PostgresConnection& server = connection();
    const detail::PostgresTransaction undone(server);
    detail::append_versions(server, {version});
  }

  /// The next versions of a site after the cursor, which goes on behind them: in the order of the
  /// transactions that brought them, of those alone before which none is still open, so that what
  /// commits late is read later and never passed over.
  std::vector<ReadVersion> read(const std::string& site, FleetCursor& cursor,
                                std::size_t max_versions = 5000) {
    detail::PostgresConnection& server = connection();
    FleetCursor next = cursor;
    if (next.history != history_) next = FleetCursor{history_, 0, {}, {}, -1};
    const auto rows = server.run(detail::postgres_read,
                                 detail::PostgresParameters()
                                     .add(detail::postgres_text, site)
                                     .add(detail::postgres_xid8, next.arrival)
                                     .add(detail::postgres_uuid, next.robot)
                                     .add(detail::postgres_uuid, next.session)
                                     .add(detail::postgres_int8, next.seq)
                                     .add(detail::postgres_int8, std::uint64_t{max_versions}));
    std::vector<ReadVersion> versions;
    for (int row = 0; row < rows.rows(); ++row) {
      versions.push_back(detail::read_row(rows, row, site));
      next.arrival = rows.bits(row, 0);
      next.robot = rows.uuid(row, 1);
      next.session = rows.uuid(row, 2);
      next.seq = rows.integer(row, 3);
    }
    cursor = next;
    return versions;
  }

  /// Has the server say from now on when there is something new.
  void listen() {
    listening_ = true;
    if (is_open()) greet();
  }
  /// To be polled, with `notified`; -1 while there is no connection.
  int socket() const noexcept { return is_open() ? connection_->socket() : -1; }
  /// Whether the server has said so since it was asked last.
  bool notified() { return is_open() && connection_->notified(); }

 private:
  bool is_open() const noexcept { return connection_ && connection_->is_open(); }

  detail::PostgresConnection& connection() {
    if (is_open()) return *connection_;
    connection_.emplace(conninfo_, silence_);
    try {
      greet();
    } catch (...) {
      connection_.reset();
      throw;
    }
    return *connection_;
  }

  /// What has to hold of a server before it is asked anything.
  void greet() {
    detail::require_schema(*connection_);
    const auto rows = connection_->run(
        "SELECT s.system_identifier || '/' || c.timeline_id, (EXISTS (SELECT FROM topobag.version"
        " WHERE arrival >= pg_snapshot_xmax(pg_current_snapshot()))), pg_is_in_recovery()"
        " FROM pg_control_system() AS s, pg_control_checkpoint() AS c");
    history_ = rows.text(0, 0);
    if (rows.flag(0, 1)) {
      throw FormatError(connection_->name() +
                        ": its versions were copied with another server's column `arrival`, by "
                        "which followers read; copy them again without it");
    }
    const bool standby = rows.flag(0, 2);  // cannot notify; it is asked from time to time
    if (listening_ && !standby) connection_->run("LISTEN topobag");
  }

  std::string conninfo_;
  std::chrono::milliseconds silence_;
  std::optional<detail::PostgresConnection> connection_;
  bool listening_ = false;
  std::string history_;  ///< of the server: a standby that takes over begins another one
};

}  // namespace v0
}  // namespace topobag
