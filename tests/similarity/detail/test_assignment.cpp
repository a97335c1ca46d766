// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <topobag/similarity/detail/assigned_gain.hpp>
#include <topobag/similarity/detail/assignment.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// The largest total gain, by trying every order of the longer side.
double brute_force(const Eigen::MatrixXd& gain) {
  if (gain.rows() > gain.cols()) return brute_force(gain.transpose());
  std::vector<Eigen::Index> columns(static_cast<std::size_t>(gain.cols()));
  std::iota(columns.begin(), columns.end(), Eigen::Index{0});
  double best = -1e300;
  do {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < gain.rows(); ++i) {
      sum += gain(i, columns[static_cast<std::size_t>(i)]);
    }
    best = std::max(best, sum);
  } while (std::next_permutation(columns.begin(), columns.end()));
  return best;
}

}  // namespace

TEST_CASE("assignments equal the best of all orders", "[similarity][assignment]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> real(-1.0, 1.0);
  for (int round = 0; round < 300; ++round) {
    Eigen::MatrixXd gain(1 + round % 6, 1 + round / 6 % 6);
    const bool ties = round % 2 == 0;
    for (double& g : gain.reshaped()) g = ties ? std::round(2.0 * real(random)) : real(random);

    const auto column_of = detail::best_assignment(gain);
    REQUIRE(column_of.size() == static_cast<std::size_t>(gain.rows()));
    std::set<std::size_t> taken;
    double sum = 0.0;
    for (std::size_t i = 0; i < column_of.size(); ++i) {
      if (!column_of[i]) continue;
      CHECK(taken.insert(*column_of[i]).second);
      sum += gain(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(*column_of[i]));
    }
    CHECK(taken.size() == static_cast<std::size_t>(std::min(gain.rows(), gain.cols())));
    CHECK(sum == Approx(brute_force(gain)).margin(1e-12));
  }
}

TEST_CASE("nothing is assigned to nothing", "[similarity][assignment]") {
  CHECK(detail::best_assignment(Eigen::MatrixXd(0, 0)).empty());
  CHECK(detail::best_assignment(Eigen::MatrixXd(0, 3)).empty());
  const auto column_of = detail::best_assignment(Eigen::MatrixXd(2, 0));
  CHECK(column_of.size() == 2);
  CHECK_FALSE(column_of[0].has_value());
}

TEST_CASE("gains are assigned within labels", "[similarity][assignment]") {
  const std::vector<ClassId> p{ClassId{1}, ClassId{1}, ClassId{3}};
  const std::vector<ClassId> q{ClassId{1}, ClassId{2}, ClassId{3}, ClassId{3}};
  Eigen::Matrix<double, 3, 4> gain;
  gain << 5, 100, 100, 100,  //
      7, 100, 100, 100,      //
      100, 100, 2, 3;
  CHECK(detail::assigned_gain(p, q, [&](std::size_t i, std::size_t j) {
          return gain(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }) == 10.0);
  CHECK(detail::assigned_gain({}, q, [](std::size_t, std::size_t) { return 1.0; }) == 0.0);
}
