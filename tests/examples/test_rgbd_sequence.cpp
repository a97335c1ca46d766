// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "catch.hpp"
#include "rgbd_sequence.hpp"
#include "scratch.hpp"

using namespace program;

TEST_CASE("associations pair images, the ground truth is interpolated at the colour stamp",
          "[examples]") {
  const ScratchFolder folder;
  folder.write("associations.txt",
               "# time rgb time depth\n"
               "2.05 rgb/b.png 2.06 depth/b.png\n"
               "1.05 rgb/a.png 1.06 depth/a.png\n\n");
  folder.write("groundtruth.txt", "# ground truth\n1.00 0 0 0 0 0 0 1\n1.08 8 0 0 0 0 0 1\n");
  const RgbdSequence sequence = read_tum_sequence(folder.path(""));
  const std::vector<RgbdFrame>& frames = sequence.frames;
  REQUIRE(frames.size() == 2);
  CHECK(frames[0].timestamp == 1.05);
  CHECK(frames[0].rgb == folder.path("rgb/a.png"));
  CHECK(frames[0].depth == folder.path("depth/a.png"));
  REQUIRE(frames[0].T_world_camera);
  CHECK(frames[0].T_world_camera->translation().isApprox(Eigen::Vector3d(5, 0, 0), 1e-9));
  CHECK_FALSE(frames[1].T_world_camera);  // a second from the nearest pose
}

TEST_CASE("without associations the nearest depth within 20 ms is taken", "[examples]") {
  const ScratchFolder folder;
  folder.write("rgb.txt", "1.000 rgb/a.png\n2.000 rgb/b.png\n");
  folder.write("depth.txt", "0.985 depth/x.png\n1.010 depth/y.png\n2.021 depth/z.png\n");
  const RgbdSequence sequence = read_tum_sequence(folder.path(""));
  const std::vector<RgbdFrame>& frames = sequence.frames;
  REQUIRE(frames.size() == 1);
  CHECK(frames[0].depth == folder.path("depth/y.png"));
  CHECK_FALSE(frames[0].T_world_camera);
  CHECK(sequence.without_depth == 1);
}

TEST_CASE("a broken list of images is refused with file and line", "[examples]") {
  const ScratchFolder folder;
  const auto error = [&] { return error_in(folder, [&] { read_tum_sequence(folder.path("")); }); };
  CHECK(error().find(": it is no sequence in the TUM RGB-D layout") == 0);
  folder.write("rgb.txt", "1.0 rgb/a.png\n");
  CHECK(error() == "depth.txt: the file cannot be opened; check the path");
  folder.write("associations.txt", "#\n1.0 rgb/a.png\n");
  CHECK(error() == "associations.txt:2: the line does not hold 2 times 'timestamp file'");
  folder.write("associations.txt", "now rgb/a.png 1.0 depth/a.png\n");
  CHECK(error() == "associations.txt:1: 'now' is not a number.");
  folder.write("associations.txt", "#\n");
  CHECK(error() == ": no colour image has a depth image");
}

TEST_CASE("lists are read with a mark, and stamps and poses of another clock are refused",
          "[examples]") {
  const ScratchFolder folder;
  const auto error = [&] { return error_in(folder, [&] { read_tum_sequence(folder.path("")); }); };
  folder.write("associations.txt",
               "\xEF\xBB\xBF"
               "1.0 a.png 1.0 b.png\r\n");
  CHECK(read_tum_sequence(folder.path("")).frames.size() == 1);
  folder.write("groundtruth.txt", "1001 0 0 0 0 0 0 1\n1002 0 0 0 0 0 0 1\n");
  CHECK(error() ==
        "groundtruth.txt: 2 poses from 1001 to 1002 s reach none of the images, from 1.000000 to "
        "1.000000 s; are both of one clock?");
  folder.write("associations.txt", "1305031102175304000 a.png 1305031102175304000 b.png\n");
  CHECK(error().find("associations.txt:1: the time stamp") == 0);
  CHECK(error().find("nanoseconds") != std::string::npos);
}

TEST_CASE("an image twice and a depth image of another moment are refused",
          "[examples][regression]") {
  const ScratchFolder folder;
  const auto told = [&](const std::string& list, const std::string& text) {
    folder.write(list, text);
    return error_in(folder, [&] { read_tum_sequence(folder.path("")); });
  };
  const std::string pair = "1.0 a.png 1.02 b.png\n";
  CHECK(told("associations.txt", pair + "2 c.png 2.1 d.png\n" + pair) ==
        "associations.txt:3: an image of this time is there already; write each once");
  CHECK(told("associations.txt", pair + "2 c.png 9 d.png\n") ==
        "associations.txt:2: the two images are 7 s apart, farther than 0.1 s; pair those of one "
        "moment");
  CHECK(told("associations.txt", pair + "2 c.png 2.0999 d.png\n") == "nothing was thrown");
  const ScratchFolder lists;
  lists.write("depth.txt", "1.0 b.png\n");
  lists.write("rgb.txt", "1.0 a.png\n1.0 a.png\n");
  CHECK(error_in(lists, [&] { read_tum_sequence(lists.path("")); }) ==
        "rgb.txt:2: an image of this time is there already; write each once");
}
