// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <topobag/adaptors/detail/postgres_connection.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// The version of the tables that `PostgresStore` writes; it takes earlier ones along.
inline constexpr std::int64_t postgres_schema_version = 2;

namespace detail {

/// The first step, from nothing.
///
/// `arrival` is the server's own transaction, not replicated and not the robot's to say: by it
/// followers read what is new. A label and a run's name are bytes, since a text of PostgreSQL
/// cannot hold them all.
inline constexpr const char* postgres_first_step = R"sql(
CREATE SCHEMA topobag;
CREATE TABLE topobag.meta(schema_version bigint NOT NULL);
INSERT INTO topobag.meta VALUES (0);
CREATE TABLE topobag.site(
  site text PRIMARY KEY CHECK (site <> ''),
  catalog bigint NOT NULL);
CREATE TABLE topobag.access(
  role name NOT NULL,
  site text NOT NULL REFERENCES topobag.site,
  robot uuid,
  UNIQUE (role, site, robot));
CREATE TABLE topobag.version(
  site text NOT NULL,
  robot uuid NOT NULL,
  session uuid NOT NULL,
  seq bigint NOT NULL,
  keyframe bigint NOT NULL,
  run bytea NOT NULL,
  stamp double precision,
  label bytea NOT NULL,
  tx double precision, ty double precision, tz double precision,
  qx double precision, qy double precision, qz double precision, qw double precision,
  graph bytea NOT NULL,
  catalog bigint NOT NULL,
  appearance bigint NOT NULL,
  checksum bigint NOT NULL,
  tombstone boolean NOT NULL,
  arrival xid8 NOT NULL DEFAULT pg_current_xact_id(),
  PRIMARY KEY (site, robot, session, seq)) PARTITION BY LIST (site);
CREATE INDEX version_of_arrival ON topobag.version(arrival);

CREATE FUNCTION topobag.add_site(name text, classes bigint) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  INSERT INTO topobag.site VALUES (name, classes);
  EXECUTE format('CREATE TABLE topobag.%I PARTITION OF topobag.version'
                 ' (CONSTRAINT catalog_of_site CHECK (catalog = %L::bigint)) FOR VALUES IN (%L)',
                 'site_' || md5(name), classes, name);
END $$;

CREATE FUNCTION topobag.refuse_change() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  RAISE EXCEPTION 'a version is never changed in place: insert a later one';
END $$;
CREATE TRIGGER append_only BEFORE UPDATE OR DELETE ON topobag.version
  FOR EACH ROW EXECUTE FUNCTION topobag.refuse_change();

CREATE FUNCTION topobag.wake() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  NOTIFY topobag;
  RETURN NULL;
END $$;
CREATE TRIGGER wake AFTER INSERT ON topobag.version
  FOR EACH STATEMENT EXECUTE FUNCTION topobag.wake();
CREATE TRIGGER wake_replica AFTER INSERT ON topobag.version
  FOR EACH ROW EXECUTE FUNCTION topobag.wake();
ALTER TABLE topobag.version ENABLE REPLICA TRIGGER wake_replica;

ALTER TABLE topobag.access ENABLE ROW LEVEL SECURITY;
CREATE POLICY own ON topobag.access FOR SELECT USING (role = current_user);
ALTER TABLE topobag.site ENABLE ROW LEVEL SECURITY;
CREATE POLICY admitted ON topobag.site FOR SELECT USING (site IN (SELECT site FROM topobag.access));
ALTER TABLE topobag.version ENABLE ROW LEVEL SECURITY;
CREATE POLICY admitted ON topobag.version FOR SELECT
  USING (site IN (SELECT site FROM topobag.access));
CREATE POLICY own ON topobag.version FOR INSERT
  WITH CHECK ((site, robot) IN (SELECT site, robot FROM topobag.access));
GRANT USAGE ON SCHEMA topobag TO PUBLIC;
GRANT SELECT ON topobag.meta, topobag.site, topobag.access, topobag.version TO PUBLIC;
GRANT INSERT (site, robot, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx, qy, qz, qw,
              graph, catalog, appearance, checksum, tombstone) ON topobag.version TO PUBLIC;
)sql";

/// Images of key frames: NULL where there is none, and what is said of a site's classes. Each image
/// has a checksum of its own, so that what was pushed without its image is not taken for another
/// content. The rights and policies of a version are its image's; of classes, who reads a site
/// reads them.
inline constexpr const char* postgres_second_step = R"sql(
ALTER TABLE topobag.version
  ADD COLUMN image_kind bigint,
  ADD COLUMN image bytea,
  ADD COLUMN image_checksum bigint;
GRANT INSERT (image_kind, image, image_checksum) ON topobag.version TO PUBLIC;
CREATE TABLE topobag.class(
  site text NOT NULL REFERENCES topobag.site,
  id bigint NOT NULL,
  name bytea NOT NULL,
  dynamics bigint NOT NULL,
  lookalike bigint,
  width double precision,
  height double precision,
  PRIMARY KEY (site, id));
ALTER TABLE topobag.class ENABLE ROW LEVEL SECURITY;
CREATE POLICY admitted ON topobag.class FOR SELECT
  USING (site IN (SELECT site FROM topobag.access));
GRANT SELECT ON topobag.class TO PUBLIC;
)sql";

/// What takes a data base from one version of the schema to the next. Written once, never changed:
/// a new schema is a new step.
inline constexpr std::array<const char*, postgres_schema_version> postgres_migrations = {
    postgres_first_step, postgres_second_step};

/// The schema's version; 0 where there is none.
inline std::int64_t postgres_version(PostgresConnection& connection) {
  const PostgresResult found = connection.run("SELECT to_regclass('topobag.meta') IS NOT NULL");
  if (!found.flag(0, 0)) return 0;
  return connection.run("SELECT schema_version FROM topobag.meta").integer(0, 0);
}

/// Throws FormatError for a data base of another version.
inline void require_schema(PostgresConnection& connection,
                           std::int64_t known = postgres_schema_version) {
  const std::int64_t version = postgres_version(connection);
  if (version == known) return;
  if (version > known) {
    throw FormatError(connection.name() + ": it is of a later version of topobag (schema " +
                      std::to_string(version) + "): update topobag");
  }
  throw FormatError(connection.name() +
                    (version == 0 ? ": it holds no fleet's map"
                                  : ": its fleet's map is of an earlier version of topobag") +
                    "; its owner prepares it with `topobag fleet init`");
}

/// Makes an empty data base a fleet's map, or an older one of the schema that the steps end with,
/// in one transaction; two at a time are one after the other. Throws FormatError as
/// `require_schema`, Error for who may not; then nothing has changed.
template <std::size_t Count>
void migrate_schema(PostgresConnection& connection, const std::array<const char*, Count>& steps) {
  PostgresTransaction transaction(connection);
  connection.run("SELECT pg_advisory_xact_lock(1413628231)");  // "TBAG", as in SQLite
  for (auto step = static_cast<std::size_t>(postgres_version(connection)); step < Count; ++step) {
    connection.run_all(steps[step]);
  }
  PostgresParameters version;
  version.add(postgres_int8, static_cast<std::int64_t>(Count));
  connection.run("UPDATE topobag.meta SET schema_version = $1 WHERE schema_version < $1", version);
  require_schema(connection, static_cast<std::int64_t>(Count));
  transaction.commit();
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
