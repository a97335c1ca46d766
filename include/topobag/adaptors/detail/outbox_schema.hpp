// SPDX-License-Identifier: MIT
#pragma once

namespace topobag {
inline namespace v0 {
namespace detail {

/// What a map that belongs to a fleet keeps beside its key frames: whose it is, a number for each
/// session that no other robot has, and of each key frame the number of its last change. SQLite
/// writes them in the transaction of the change itself, whoever makes it; one that is still to be
/// sent is so by its number alone, and nothing has to be struck out when it was.
inline constexpr const char* outbox_schema = R"sql(
CREATE TABLE fleet_member(site TEXT NOT NULL, robot BLOB NOT NULL);
CREATE TABLE fleet_session(session INTEGER PRIMARY KEY, uuid BLOB NOT NULL);
CREATE TABLE fleet_change(
  seq INTEGER PRIMARY KEY AUTOINCREMENT,
  session INTEGER NOT NULL,
  keyframe INTEGER NOT NULL,
  UNIQUE (session, keyframe));
CREATE TRIGGER fleet_insert AFTER INSERT ON keyframe BEGIN
  INSERT OR IGNORE INTO fleet_session VALUES (NEW.session, randomblob(16));
  INSERT OR REPLACE INTO fleet_change(session, keyframe) VALUES (NEW.session, NEW.id);
END;
CREATE TRIGGER fleet_update AFTER UPDATE ON keyframe BEGIN
  INSERT OR REPLACE INTO fleet_change(session, keyframe) VALUES (OLD.session, OLD.id);
  INSERT OR IGNORE INTO fleet_session VALUES (NEW.session, randomblob(16));
  INSERT OR REPLACE INTO fleet_change(session, keyframe) VALUES (NEW.session, NEW.id);
END;
CREATE TRIGGER fleet_delete AFTER DELETE ON keyframe BEGIN
  INSERT OR REPLACE INTO fleet_change(session, keyframe) VALUES (OLD.session, OLD.id);
END;
INSERT INTO fleet_session SELECT DISTINCT session, randomblob(16) FROM keyframe GROUP BY session;
INSERT INTO fleet_change(session, keyframe) SELECT session, id FROM keyframe ORDER BY id;
)sql";

/// The next changes after one, in order, each with the key frame as it is now; a key frame that is
/// gone, or of another session, is NULL.
inline constexpr const char* outbox_select =
    "SELECT k.id, c.session, k.stamp, k.label, k.tx, k.ty, k.tz, k.qx, k.qy, k.qz, k.qw, k.graph,"
    " k.checksum, c.seq, c.keyframe, s.uuid, coalesce(r.name, '')"
    " FROM fleet_change AS c JOIN fleet_session AS s USING (session)"
    " LEFT JOIN keyframe AS k ON k.id = c.keyframe AND k.session = c.session"
    " LEFT JOIN session AS r ON r.id = c.session WHERE c.seq > ? ORDER BY c.seq LIMIT ?";

}  // namespace detail
}  // namespace v0
}  // namespace topobag
