-- At the central server, once for each site's server, after `topobag fleet init` of its sites here:
--   psql -v name=hall -v from="host=site dbname=fleet" -f centre.sql postgresql://centre/fleet
-- It goes on by itself where a cut link or a restart stopped it. What a follower has read must
-- outlive a crash of this server, hence synchronous_commit.
CREATE SUBSCRIPTION :"name" CONNECTION :'from' PUBLICATION topobag
  WITH (synchronous_commit = 'on');
