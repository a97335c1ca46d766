// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "catch.hpp"
#include "error_text.hpp"
#include "image_names.hpp"

using namespace program;

namespace {

using Paths = std::vector<std::string>;
using Found = std::vector<std::size_t>;

Found meant(const Paths& images, const Paths& names) {
  return ImageNames(images).find(names, "boxes.json");
}

}  // namespace

TEST_CASE("an image goes by its name, whatever its suffix and slashes", "[examples]") {
  CHECK(meant({"seq/rgb/a.png", "seq/rgb/b.png"}, {"x\\y\\b.jpg", "c.png", "a"}) == Found{2, 0});
  CHECK(meant({"rgb/1305.25.png"}, {"1305.5", "1305.25"}) == Found{1});
  CHECK(meant({"rgb/1305.25.png"}, {"1305.txt"}) == Found{ImageNames::none});
}

TEST_CASE("images of one name in two folders are told apart by them", "[examples]") {
  CHECK(meant({"seq/left/1.png", "seq/right/1.png"}, {"right/1.png", "left/1.png"}) == Found{1, 0});
  CHECK(meant({"seq/left/1.png"}, {"b/right/1.png", "b/left/1.png"}) == Found{1});
}

TEST_CASE("what folders do not tell apart is refused", "[examples]") {
  CHECK(error_text([] {
          meant({"seq/rgb/1.png"}, {"left/1.png", "right/1.png"});
        }) ==
        "boxes.json: 'left/1' and 'right/1' may both be the image 'rgb/1'; give the boxes of one "
        "camera, or folders of the same name");
  CHECK(error_text([] {
          meant({"left/1.png", "right/1.png"}, {"1.png"});
        }) == "boxes.json: '1' may be the image 'left/1' or 'right/1'; give its folder with it");
  CHECK_THROWS_AS(meant({"rgb/1.png"}, {"1.png", "1.png"}), topobag::Error);
}
