-- A fleet's server as schema 1 kept it, as pg_dump writes it (--inserts --column-inserts --no-owner),
-- without comments and without the column arrival, which is that server's own. Never to be changed.
SET statement_timeout = 0;
SET lock_timeout = 0;
SET idle_in_transaction_session_timeout = 0;
SET client_encoding = 'UTF8';
SET standard_conforming_strings = on;
SELECT pg_catalog.set_config('search_path', '', false);
SET check_function_bodies = false;
SET xmloption = content;
SET client_min_messages = warning;
SET row_security = off;
CREATE SCHEMA topobag;
CREATE FUNCTION topobag.add_site(name text, classes bigint) RETURNS void
    LANGUAGE plpgsql
    AS $$
BEGIN
  INSERT INTO topobag.site VALUES (name, classes);
  EXECUTE format('CREATE TABLE topobag.%I PARTITION OF topobag.version'
                 ' (CONSTRAINT catalog_of_site CHECK (catalog = %L::bigint)) FOR VALUES IN (%L)',
                 'site_' || md5(name), classes, name);
END $$;
CREATE FUNCTION topobag.refuse_change() RETURNS trigger
    LANGUAGE plpgsql
    AS $$
BEGIN
  RAISE EXCEPTION 'a version is never changed in place: insert a later one';
END $$;
CREATE FUNCTION topobag.wake() RETURNS trigger
    LANGUAGE plpgsql
    AS $$
BEGIN
  NOTIFY topobag;
  RETURN NULL;
END $$;
SET default_tablespace = '';
SET default_table_access_method = heap;
CREATE TABLE topobag.access (
    role name NOT NULL,
    site text NOT NULL,
    robot uuid
);
CREATE TABLE topobag.meta (
    schema_version bigint NOT NULL
);
CREATE TABLE topobag.site (
    site text NOT NULL,
    catalog bigint NOT NULL,
    CONSTRAINT site_site_check CHECK ((site <> ''::text))
);
CREATE TABLE topobag.version (
    site text NOT NULL,
    robot uuid NOT NULL,
    session uuid NOT NULL,
    seq bigint NOT NULL,
    keyframe bigint NOT NULL,
    run bytea NOT NULL,
    stamp double precision,
    label bytea NOT NULL,
    tx double precision,
    ty double precision,
    tz double precision,
    qx double precision,
    qy double precision,
    qz double precision,
    qw double precision,
    graph bytea NOT NULL,
    catalog bigint NOT NULL,
    appearance bigint NOT NULL,
    checksum bigint NOT NULL,
    tombstone boolean NOT NULL,
    arrival xid8 DEFAULT pg_current_xact_id() NOT NULL
)
PARTITION BY LIST (site);
CREATE TABLE topobag.site_34ec85514fc8d58c148075f553a69851 (
    site text NOT NULL,
    robot uuid NOT NULL,
    session uuid NOT NULL,
    seq bigint NOT NULL,
    keyframe bigint NOT NULL,
    run bytea NOT NULL,
    stamp double precision,
    label bytea NOT NULL,
    tx double precision,
    ty double precision,
    tz double precision,
    qx double precision,
    qy double precision,
    qz double precision,
    qw double precision,
    graph bytea NOT NULL,
    catalog bigint NOT NULL,
    appearance bigint NOT NULL,
    checksum bigint NOT NULL,
    tombstone boolean NOT NULL,
    arrival xid8 DEFAULT pg_current_xact_id() NOT NULL,
    CONSTRAINT catalog_of_site CHECK ((catalog = '77'::bigint))
);
CREATE TABLE topobag.site_5ab06702d8b598415f7b095c130e1787 (
    site text NOT NULL,
    robot uuid NOT NULL,
    session uuid NOT NULL,
    seq bigint NOT NULL,
    keyframe bigint NOT NULL,
    run bytea NOT NULL,
    stamp double precision,
    label bytea NOT NULL,
    tx double precision,
    ty double precision,
    tz double precision,
    qx double precision,
    qy double precision,
    qz double precision,
    qw double precision,
    graph bytea NOT NULL,
    catalog bigint NOT NULL,
    appearance bigint NOT NULL,
    checksum bigint NOT NULL,
    tombstone boolean NOT NULL,
    arrival xid8 DEFAULT pg_current_xact_id() NOT NULL,
    CONSTRAINT catalog_of_site CHECK ((catalog = '0'::bigint))
);
ALTER TABLE ONLY topobag.version ATTACH PARTITION topobag.site_34ec85514fc8d58c148075f553a69851 FOR VALUES IN ('yard ''O"Neill''');
ALTER TABLE ONLY topobag.version ATTACH PARTITION topobag.site_5ab06702d8b598415f7b095c130e1787 FOR VALUES IN ('hall');
INSERT INTO topobag.access (role, site, robot) VALUES ('old_robot', 'hall', '52320000-0000-0000-0000-000000000000');
INSERT INTO topobag.access (role, site, robot) VALUES ('old_robot', 'yard ''O"Neill''', NULL);
INSERT INTO topobag.meta (schema_version) VALUES (1);
INSERT INTO topobag.site (site, catalog) VALUES ('hall', 0);
INSERT INTO topobag.site (site, catalog) VALUES ('yard ''O"Neill''', 77);
INSERT INTO topobag.site_34ec85514fc8d58c148075f553a69851 (site, robot, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx, qy, qz, qw, graph, catalog, appearance, checksum, tombstone) VALUES ('yard ''O"Neill''', '52320000-0000-0000-0000-000000000000', '73000000-0000-0000-0000-000000000000', 6, 1, '\x612077616c6b', 1.5, '\x6672616d652031', 6, 2, -0.5, 0, 0, 0, 1, '\x811c1001000080400339e01f60004800881200800c329600350a00002000015e0000000120400210923f', 77, 0, 9243183, false);
INSERT INTO topobag.site_5ab06702d8b598415f7b095c130e1787 (site, robot, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx, qy, qz, qw, graph, catalog, appearance, checksum, tombstone) VALUES ('hall', '52320000-0000-0000-0000-000000000000', '73000000-0000-0000-0000-000000000000', 1, 1, '\x612077616c6b', 1.5, '\x6672616d652031', 1, 2, -0.5, 0, 0, 0, 1, '\x611c10010000810612f00f30002400440800204306a85100000001a8000000011080903c', 0, 0, 2440525924, false);
INSERT INTO topobag.site_5ab06702d8b598415f7b095c130e1787 (site, robot, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx, qy, qz, qw, graph, catalog, appearance, checksum, tombstone) VALUES ('hall', '52320000-0000-0000-0000-000000000000', '73000000-0000-0000-0000-000000000000', 2, 2, '\x612077616c6b', 3, '\x6672616d652032', 2, 2, -0.5, 0, 0, 0, 1, '\x811c1001000080400339e01f60004800881200800c329600350a00002000015e0000000120400210923f', 0, 0, 1076924628, false);
INSERT INTO topobag.site_5ab06702d8b598415f7b095c130e1787 (site, robot, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx, qy, qz, qw, graph, catalog, appearance, checksum, tombstone) VALUES ('hall', '52320000-0000-0000-0000-000000000000', '73000000-0000-0000-0000-000000000000', 3, 3, '\x612077616c6b', 4.5, '\x6672616d652033', NULL, NULL, NULL, NULL, NULL, NULL, NULL, '\xa11c100100000060a001d108f80718001200a2040020838c2564809a05000020000218001900008000208004800084e4fd', 0, 0, 3596122629, false);
INSERT INTO topobag.site_5ab06702d8b598415f7b095c130e1787 (site, robot, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx, qy, qz, qw, graph, catalog, appearance, checksum, tombstone) VALUES ('hall', '52320000-0000-0000-0000-000000000000', '73000000-0000-0000-0000-000000000000', 4, 2, '\x612077616c6b', 3, '\x6672616d652032', 4, 2, -0.5, 0, 0, 0, 1, '\x811c1001000080400339e01f60004800881200800c329600350a00002000015e0000000120400210923f', 0, 0, 1991170240, false);
INSERT INTO topobag.site_5ab06702d8b598415f7b095c130e1787 (site, robot, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx, qy, qz, qw, graph, catalog, appearance, checksum, tombstone) VALUES ('hall', '52320000-0000-0000-0000-000000000000', '73000000-0000-0000-0000-000000000000', 5, 3, '\x612077616c6b', NULL, '\x', NULL, NULL, NULL, NULL, NULL, NULL, NULL, '\x', 0, 0, 2009335355, true);
ALTER TABLE ONLY topobag.access
    ADD CONSTRAINT access_role_site_robot_key UNIQUE (role, site, robot);
ALTER TABLE ONLY topobag.version
    ADD CONSTRAINT version_pkey PRIMARY KEY (site, robot, session, seq);
ALTER TABLE ONLY topobag.site_34ec85514fc8d58c148075f553a69851
    ADD CONSTRAINT site_34ec85514fc8d58c148075f553a69851_pkey PRIMARY KEY (site, robot, session, seq);
ALTER TABLE ONLY topobag.site_5ab06702d8b598415f7b095c130e1787
    ADD CONSTRAINT site_5ab06702d8b598415f7b095c130e1787_pkey PRIMARY KEY (site, robot, session, seq);
ALTER TABLE ONLY topobag.site
    ADD CONSTRAINT site_pkey PRIMARY KEY (site);
CREATE INDEX version_of_arrival ON ONLY topobag.version USING btree (arrival);
CREATE INDEX site_34ec85514fc8d58c148075f553a69851_arrival_idx ON topobag.site_34ec85514fc8d58c148075f553a69851 USING btree (arrival);
CREATE INDEX site_5ab06702d8b598415f7b095c130e1787_arrival_idx ON topobag.site_5ab06702d8b598415f7b095c130e1787 USING btree (arrival);
ALTER INDEX topobag.version_of_arrival ATTACH PARTITION topobag.site_34ec85514fc8d58c148075f553a69851_arrival_idx;
ALTER INDEX topobag.version_pkey ATTACH PARTITION topobag.site_34ec85514fc8d58c148075f553a69851_pkey;
ALTER INDEX topobag.version_of_arrival ATTACH PARTITION topobag.site_5ab06702d8b598415f7b095c130e1787_arrival_idx;
ALTER INDEX topobag.version_pkey ATTACH PARTITION topobag.site_5ab06702d8b598415f7b095c130e1787_pkey;
CREATE TRIGGER append_only BEFORE DELETE OR UPDATE ON topobag.version FOR EACH ROW EXECUTE FUNCTION topobag.refuse_change();
CREATE TRIGGER wake AFTER INSERT ON topobag.version FOR EACH STATEMENT EXECUTE FUNCTION topobag.wake();
CREATE TRIGGER wake_replica AFTER INSERT ON topobag.version FOR EACH ROW EXECUTE FUNCTION topobag.wake();
ALTER TABLE topobag.version ENABLE REPLICA TRIGGER wake_replica;
ALTER TABLE ONLY topobag.access
    ADD CONSTRAINT access_site_fkey FOREIGN KEY (site) REFERENCES topobag.site(site);
ALTER TABLE topobag.access ENABLE ROW LEVEL SECURITY;
CREATE POLICY admitted ON topobag.site FOR SELECT USING ((site IN ( SELECT access.site
   FROM topobag.access)));
CREATE POLICY admitted ON topobag.version FOR SELECT USING ((site IN ( SELECT access.site
   FROM topobag.access)));
CREATE POLICY own ON topobag.access FOR SELECT USING ((role = CURRENT_USER));
CREATE POLICY own ON topobag.version FOR INSERT WITH CHECK (((site, robot) IN ( SELECT access.site,
    access.robot
   FROM topobag.access)));
ALTER TABLE topobag.site ENABLE ROW LEVEL SECURITY;
ALTER TABLE topobag.version ENABLE ROW LEVEL SECURITY;
GRANT USAGE ON SCHEMA topobag TO PUBLIC;
GRANT SELECT ON TABLE topobag.access TO PUBLIC;
GRANT SELECT ON TABLE topobag.meta TO PUBLIC;
GRANT SELECT ON TABLE topobag.site TO PUBLIC;
GRANT SELECT ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(site) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(robot) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(session) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(seq) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(keyframe) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(run) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(stamp) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(label) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(tx) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(ty) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(tz) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(qx) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(qy) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(qz) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(qw) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(graph) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(catalog) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(appearance) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(checksum) ON TABLE topobag.version TO PUBLIC;
GRANT INSERT(tombstone) ON TABLE topobag.version TO PUBLIC;
