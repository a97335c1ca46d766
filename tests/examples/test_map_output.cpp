// SPDX-License-Identifier: MIT
#include <string>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

/// What `map` prints of a table.
std::string mapped(const std::string& table, const std::string& options, const std::string& map) {
  const ProgramRun run = run_program("map --nodes " + table + " --camera 517.3,516.5,318.6,255.3 " +
                                     options + " --out " + map);
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  return run.out;
}

}  // namespace

TEST_CASE("map counts the frames and the key frames that are left out", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string map = folder.path("a.bag");
  CHECK(mapped(sample_map, "", map) ==
        map + ": 62 key frames of fr1_xyz added to the snapshot\n" + map +
            ": 5 of 67 frames left out, nearer than --keyframe-interval 0.4 s\n");
  folder.write("s.frames.csv", "idx,frame,timestamp\n0,a,0\n1,b,1\n2,c,2\n");
  folder.write("s.nodes.csv",
               "idx,class,conf,u,v,w,h,z\n1,cup,1,100,100,20,20,2\n1,tv,1,300,100,20,20,2\n"
               "1,book,1,200,300,20,20,2\n2,cup,1,100,100,20,20,2\n");
  const std::string few = folder.path("few.bag");
  CHECK(mapped(folder.path("s"), "--window 0", few) ==
        few + ": 3 key frames of s added to the snapshot\n" + few +
            ": 2 of 3 key frames are not usable, with fewer than three objects with a position\n");
}

TEST_CASE("a session's name that the map cannot keep is told", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string monday = "--keyframe-interval 0 --session Monday";
  const std::string snapshot = folder.path("map.topobag");
  CHECK(mapped(sample_map, monday, snapshot) ==
        snapshot + ": 67 key frames of Monday added to the snapshot\n" + snapshot +
            ": a snapshot keeps no names of sessions, and so not Monday; a map FILE.db does\n");
#ifdef TOPOBAG_HAS_SQLITE
  const std::string database = folder.path("map.db");
  CHECK(mapped(sample_map, monday, database) ==
        database + ": 67 key frames of Monday added to the SQLite map\n");
#endif
}

TEST_CASE("each file of a table stands for it", "[examples][regression]") {
  const ScratchFolder folder;
  folder.write("c.frames.csv", "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw\n0,a,0,0,0,0,0,0,0,1\n");
  folder.write("c.clusters.csv",
               "idx,class,conf,x,y,z,dx,dy,dz\n0,bench,0.9,5,1,0,1,1,1\n"
               "0,chair,0.9,4,-1,0,1,1,1\n0,car,0.9,6,2,0,1,1,1\n0,tv,0.9,7,-2,0,1,1,1\n");
  for (const std::string ending : {"", ".frames.csv", ".clusters.csv"}) {
    const ProgramRun map =
        run_program("map --clusters --window 0 --nodes " + folder.path("c" + ending) + " --out " +
                    folder.path("m" + std::to_string(ending.size()) + ".bag"));
    CAPTURE(map.err);
    CHECK(map.exit_code == 0);
  }
  const ProgramRun view = run_program("view " + folder.path("c") + " --clusters --window 0 --out " +
                                      folder.path("c.html"));  // without a camera
  CAPTURE(view.err);
  CHECK(view.exit_code == 0);
}

TEST_CASE("a session's name can be shown and is no longer than a file's",
          "[examples][regression]") {
  const ScratchFolder folder;
  const std::string map = "map --nodes " + sample_map + sample_options + "--out " +
                          folder.path("m.bag") + " --session ";
  const auto said = [](int byte) {
    return "--session: byte " + std::to_string(byte) +
           " of the name begins a control character; give a name that can be shown";
  };
  CHECK(refusal(map + "'Mon\nday'") == said(4));
  CHECK(refusal(map + "'\x1b[31m'") == said(1));
  CHECK(refusal(map + "'a\x7f'") == said(2));
  CHECK(refusal(map + "'a\xC2\x85'") == said(2));
  CHECK(refusal(map + std::string(256, 'a')) ==
        "--session: the name has 256 bytes; give one of at most 255");
  for (const std::string& name : {std::string(255, 'a'), std::string("'\xC3\xA4 \xE6\x9C\x88'")}) {
    const ScratchFolder own;
    CHECK(run_program("map --nodes " + sample_map + sample_options + "--out " + own.path("m.bag") +
                      " --session " + name)
              .exit_code == 0);
  }
}
