// SPDX-License-Identifier: MIT
// The program beside an ORB-SLAM, built for a small host, from its command line to what it prints.
#include <sys/wait.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "catch.hpp"
#include "scratch_folder.hpp"

namespace {

struct BesideRun {
  int exit_code = -1;
  std::string out, err;

  bool says(const std::string& text) const { return out.find(text) != std::string::npos; }
};

/// Six images of a wall with seven objects, along which a camera goes; with depth images, right
/// images 100 px off, truth and a node table.
class WallSequence {
 public:
  explicit WallSequence(const std::string& more_settings = "") {
    folder_.write("settings.yaml",
                  "%YAML:1.0\nCamera.fx: 500.0\nCamera.fy: 500.0\nCamera.cx: 319.5\n"
                  "Camera.cy: 239.5\nCamera.width: 640\nCamera.height: 480\n"
                  "DepthMapFactor: 1000.0\n" +
                      more_settings);
    std::ostringstream list, pairs, truth, frames, nodes;
    list << "# stamp image\n";
    frames << "idx,frame,timestamp\n";
    nodes << "idx,class_id,class,conf,u,v,w,h,z\n";
    for (int i = 0; i < 6; ++i) {
      const std::string stamp = std::to_string(i) + ".5", image = std::to_string(i) + ".png";
      cv::imwrite(folder_.path(image), cv::Mat(480, 640, CV_8UC1, 90));
      cv::imwrite(folder_.path("depth" + image), cv::Mat(480, 640, CV_16UC1, 2500));
      list << stamp << ' ' << image << '\n';
      pairs << stamp << ' ' << image << ' ' << stamp << " depth" << image << '\n';
      truth << stamp << ' ' << 0.2 * (i + 0.5) << " 0 0 0 0 0 1\n";  // 2 m in a unit of the host
      frames << i << ',' << image << ',' << stamp << '\n';
      const char* const labels[] = {"56,chair",    "62,tv",   "58,potted plant", "63,laptop",
                                    "66,keyboard", "73,book", "56,chair"};
      const int v[] = {100, 240, 150, 330, 380, 90, 290};
      for (int k = 0; k < 7; ++k) {
        nodes << i << ',' << labels[k] << ",0.9," << 160 + 65 * k - 20 * i << ',' << v[k]
              << ",50,60,2.5\n";
      }
    }
    folder_.write("rgb.txt", list.str());
    folder_.write("pairs.txt", pairs.str());
    folder_.write("groundtruth.txt", truth.str());
    folder_.write("set.frames.csv", frames.str());
    folder_.write("set.nodes.csv", nodes.str());
  }

  BesideRun run(const std::string& associations, const std::string& options) const {
    const std::string at = folder_.path() + "/";
    const std::string command = std::string("'") + TOPOBAG_BESIDE + "' voc.txt " + at +
                                "settings.yaml " + at + " " + at + associations +
                                " --no-wait --out " + at + "out " + options + " >" + at +
                                "said 2>" + at + "complained";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(at + "said"),
            content_of(at + "complained")};
  }
  std::string table() const { return "--detections " + folder_.path("set"); }
  /// Shows the sequence to the lost camera.
  std::string kidnap(const std::string& associations) const {
    return " --kidnap " + folder_.path() + " --kidnap-associations " + folder_.path(associations) +
           " --kidnap-every 2";
  }
  bool has(const std::string& file) const {
    return std::filesystem::exists(folder_.path("out/" + file));
  }

 private:
  ScratchFolder folder_;
};

}  // namespace

TEST_CASE("the program maps an RGB-D sequence, and finds a kidnapped camera in it", "[hooks]") {
  const WallSequence wall;
  const BesideRun run = wall.run("pairs.txt", wall.table() + wall.kidnap("pairs.txt"));
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.says("frames: 6, tracked: 6\n"));
  CHECK(run.says("6 in the bag; exceptions: 0"));
  CHECK(run.says("kidnapped: 3 of 3 re-localized"));
  CHECK_FALSE(run.says("metres in a unit of the host"));
  CHECK_FALSE(run.says("by directions: "));
  CHECK(wall.has("loops.csv"));
  CHECK(wall.has("relocalizations.csv"));
}

TEST_CASE("the program maps the images of one camera, and finds it by directions", "[hooks]") {
  const WallSequence wall;
  const BesideRun run =
      wall.run("rgb.txt", "--sensor mono " + wall.table() + wall.kidnap("rgb.txt"));
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.says("frames: 6, tracked: 6\nmetres in a unit of the host: 2\n"));
  CHECK(run.says("6 in the bag; exceptions: 0"));
  CHECK(run.says("without depth, by directions: 3 frames asked, 3 verified, 0 of them not within"));
  CHECK(run.err.empty());
}

TEST_CASE("the program takes grey stereo pairs", "[hooks][regression]") {
  const WallSequence wall("Camera.bf: 50.0\n");
  const BesideRun run = wall.run("pairs.txt", "--depth stereo " + wall.table());
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.says("frames: 6, tracked: 6\n"));
  CHECK(run.says("6 through the topology thread, 0 failed"));
}

TEST_CASE("the program spares the detector still views", "[hooks]") {
  const WallSequence wall;
  const BesideRun run = wall.run("pairs.txt", "--still 0.15 " + wall.table());
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.says("  3 key frames without objects: the view hardly changed\n"));
}

TEST_CASE("what the program cannot do it refuses in a sentence", "[hooks]") {
  const WallSequence wall;
  const auto complaint = [&wall](const std::string& options) {
    const BesideRun run = wall.run("pairs.txt", options);
    CHECK(run.exit_code == 2);
    return run.err;
  };
  CHECK(complaint("") == "give --detections or --model, or --stock\n");
  CHECK(complaint("--depth stereo " + wall.table())
            .find("--depth stereo needs the distance of the two cameras") == 0);
  CHECK(complaint("--sensor mono --depth rgbd " + wall.table()) ==
        "--sensor mono has no --depth rgbd: give points, or leave it out\n");
}

TEST_CASE("the program runs the host as it is", "[hooks]") {
  const WallSequence wall;
  const BesideRun run = wall.run("pairs.txt", "--stock");
  CHECK(run.exit_code == 0);
  CHECK(run.says("frames: 6, tracked: 6\n"));
  CHECK_FALSE(run.says("in the bag"));
}
