// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include <Eigen/Core>

#include <topobag/types/image_descriptor.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

TEST_CASE("a whole image's descriptor keeps its direction", "[types]") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const std::size_t length : {1U, 7U, 768U, 8448U, 65535U}) {
    const ImageKind kind("a network", length);
    const auto n = static_cast<Eigen::Index>(length);
    const Eigen::VectorXd a = Eigen::VectorXd::NullaryExpr(n, [&] { return normal(random); });
    const Eigen::VectorXd b =
        a + 0.5 * Eigen::VectorXd::NullaryExpr(n, [&] { return normal(random); });
    const ImageDescriptor p(kind, a), q(kind, b), scaled(kind, Eigen::VectorXd(1e-20 * a));
    CHECK(p.known());
    CHECK(p.bytes().size() == length);
    CHECK(p == scaled);
    CHECK(p == ImageDescriptor(kind, p.bytes()));
    CHECK((length == 1 || p != q));
    CHECK(cosine_similarity(p, p) == Approx(1.0));
    CHECK(cosine_similarity(p, q) == cosine_similarity(q, p));
    CHECK(cosine_similarity(p, q) == Approx(a.dot(b) / a.norm() / b.norm()).margin(0.02));
  }
}

TEST_CASE("the greatest bytes do not overflow a whole image's norm", "[types]") {
  const ImageKind kind("bytes", ImageKind::max_length);
  const ImageDescriptor least(kind, ImageDescriptor::Bytes(kind.length(), -128));
  CHECK(least.squared_norm() == 65535 * 128 * 128);
  CHECK(cosine_similarity(least, least) == Approx(1.0));
}

TEST_CASE("a whole image's descriptor that has no direction is refused", "[types]") {
  const ImageKind kind("network", 3);
  CHECK_FALSE(ImageDescriptor().known());
  CHECK(ImageDescriptor() == ImageDescriptor());
  CHECK_THROWS_AS(ImageDescriptor(kind, Eigen::Vector3d::Zero()), InvalidValue);
  CHECK_THROWS_AS(ImageDescriptor(kind, Eigen::Vector2d(1, 2)), InvalidValue);
  CHECK_THROWS_AS(ImageDescriptor(kind, ImageDescriptor::Bytes{1, 2}), InvalidValue);
  CHECK_THROWS_AS(
      ImageDescriptor(kind, Eigen::Vector3d(1, std::numeric_limits<double>::infinity(), 0)),
      InvalidValue);
  CHECK_THROWS_AS(ImageKind("network", 0), InvalidValue);
  CHECK_THROWS_AS(ImageKind("network", 65536), InvalidValue);
}

TEST_CASE("images described by two methods do not mix", "[types]") {
  const ImageKind a("one", 3), b("other", 3), longer("one", 4), none;
  CHECK(a != b);
  CHECK(a != longer);
  CHECK(common_kind(none, a, "it") == a);
  CHECK(common_kind(a, none, "it") == a);
  CHECK(common_kind(a, a, "it") == a);
  CHECK(error_text([&] { common_kind(a, longer, "the key frame"); }) ==
        "the key frame has an image's descriptor of another kind (4 numbers) than those in the bag "
        "(3): describe all images by one method");
}
