// SPDX-License-Identifier: MIT
#include <topobag/types/semantic_node.hpp>

#include "catch.hpp"

using namespace topobag;

TEMPLATE_TEST_CASE("a new node claims nothing that was not measured", "[types]", float, double) {
  const SemanticNode<TestType> node;
  CHECK_FALSE(node.pixel);
  CHECK_FALSE(node.position);
  CHECK(node.z == TestType(0));
  CHECK(node.covariance.isZero(0));
  CHECK(node.size.isZero(0));
  CHECK(node.confidence == TestType(1));
  CHECK(node.existence == TestType(1));
  CHECK_FALSE(node.appearance.known());
}
