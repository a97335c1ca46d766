// SPDX-License-Identifier: MIT
#include "camera_option.hpp"

#include <string>

#include "catch.hpp"
#include "error_text.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

std::string camera_complaint(const topobag::PinholeCamera<>& camera) {
  return error_text([&] { program::with_size(camera, {640, 480}); });
}

}  // namespace

TEST_CASE("focal lengths that differ as no pixels do are refused", "[examples][regression]") {
  CHECK(camera_complaint({100.0, 516.5, 318.6, 255.3}) ==
        "--camera: fx 100 and fy 516.5 px differ by more than any image's pixels do in width and "
        "height; is there a digit too few or too many?");
  CHECK(camera_complaint({516.5, 100.0, 318.6, 255.3}).find("fx 516.5 and fy 100 px differ") !=
        std::string::npos);
}

TEST_CASE("px times ten are refused, telephoto and wide-angle cameras are not",
          "[examples][regression]") {
  CHECK(camera_complaint({5173.0, 5165.0, 318.6, 255.3}) ==
        "--camera: fx 5173 px is a field of view of 7.1° over 640 px; give the focal length in px");
  const std::string fine = "nothing was thrown";
  CHECK(camera_complaint({4800.0, 4800.0, 318.6, 255.3}) == fine);  // 200 mm on APS-C
  CHECK(camera_complaint({120.0, 120.0, 318.6, 255.3}) == fine);    // 139 degrees
  CHECK(camera_complaint({520.0, 390.0, 318.6, 255.3}) == fine);    // 16:9 squeezed into 4:3
  const auto of = [](const topobag::PinholeCamera<>& camera) {
    return error_text([&] { program::with_size(camera, {}); });
  };
  CHECK(of({458.654, 457.296, 367.215, 248.375, 752, 480}) == fine);   // EuRoC
  CHECK(of({718.856, 718.856, 607.193, 185.216, 1241, 376}) == fine);  // KITTI
  CHECK(of({600.0, 600.0, 240.0, 320.0, 480, 640}) == fine);           // upright
}

TEST_CASE("cx and cy the other way round are refused", "[examples][regression]") {
  CHECK(
      camera_complaint({517.3, 516.5, 255.3, 318.6}) ==
      "--camera: the principal point 255.3, 318.6 is that of an image of 640 x 480 px with cx and "
      "cy swapped; the order is fx,fy,cx,cy");
}

TEST_CASE("an image has whole pixels", "[examples][regression]") {
  const std::string loops = "loops --nodes " + sample_map;
  CHECK(refusal(loops + sample_options + "--image-size 640.5,480").find("whole px") !=
        std::string::npos);
  CHECK(refusal(loops + " --camera 517.3,516.5,318.6,255.3,640,480.5").find("whole px") !=
        std::string::npos);
}
