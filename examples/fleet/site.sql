-- At a site's server (wal_level = logical), once: what it holds may be read by a central server.
--   psql -f site.sql postgresql://site/fleet
-- All columns but `arrival`, the transaction that brought a row to this server: the central one
-- notes its own, by which its followers read.
CREATE PUBLICATION topobag
  FOR TABLE topobag.version (site, robot, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx,
                             qy, qz, qw, graph, catalog, appearance, checksum, tombstone,
                             image_kind, image, image_checksum)
  WITH (publish = 'insert', publish_via_partition_root = true);
