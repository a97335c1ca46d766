// SPDX-License-Identifier: MIT
#include "object_alignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <tuple>

namespace program {
namespace {

using Points = std::vector<Eigen::Vector3d>;
using PointTriple = std::array<std::size_t, 3>;

double side_of(const Points& points, std::size_t a, std::size_t b) {
  return (points[a] - points[b]).norm();
}

/// The motion and scale that lay one triple over the other.
ScaledMotion laid_over(const Points& map, const PointTriple& there, const Points& query,
                       const PointTriple& here) {
  Eigen::Matrix3d target, source;
  for (std::size_t i = 0; i < 3; ++i) {
    target.col(static_cast<Eigen::Index>(i)) = map[there[i]];
    source.col(static_cast<Eigen::Index>(i)) = query[here[i]];
  }
  const Eigen::Matrix4d similarity = Eigen::umeyama(source, target, true);
  ScaledMotion motion;
  motion.scale = similarity.topLeftCorner<3, 3>().col(0).norm();
  motion.T_map_query.linear() = similarity.topLeftCorner<3, 3>() / motion.scale;
  motion.T_map_query.translation() = similarity.topRightCorner<3, 1>() / motion.scale;
  return motion;
}

std::size_t coinciding(const Points& map, const Points& query, const ScaledMotion& motion,
                       double tolerance) {
  const double reach2 = std::pow(motion.scale * tolerance, 2);
  return static_cast<std::size_t>(
      std::count_if(query.begin(), query.end(), [&](const Eigen::Vector3d& object) {
        const Eigen::Vector3d at = motion.scale * (motion.T_map_query * object);
        return std::any_of(map.begin(), map.end(), [&](const Eigen::Vector3d& there) {
          return (there - at).squaredNorm() <= reach2;
        });
      }));
}

/// Calls `found` for each triple of the map that looks like one of the query.
template <typename Found>
void for_each_alike(const Points& map, const Points& query, const PointTriple& here,
                    const AlignmentSearch& search, const Found& found) {
  const double base = side_of(query, here[0], here[1]);
  const double to_first = side_of(query, here[0], here[2]),
               to_second = side_of(query, here[1], here[2]);
  for (std::size_t p = 0; p < map.size(); ++p) {
    for (std::size_t q = 0; q < map.size(); ++q) {
      const double scale = side_of(map, p, q) / base;
      if (!(scale <= search.max_scale && scale * search.max_scale >= 1.0)) continue;
      const double tolerance = scale * search.tolerance;
      for (std::size_t r = 0; r < map.size(); ++r) {
        if (std::abs(side_of(map, p, r) - scale * to_first) > tolerance ||
            std::abs(side_of(map, q, r) - scale * to_second) > tolerance) {
          continue;
        }
        found(PointTriple{p, q, r});
      }
    }
  }
}

}  // namespace

std::vector<ScaledMotion> propose_alignments(const Points& map, const Points& query,
                                             const AlignmentSearch& search) {
  std::vector<ScaledMotion> best;
  if (query.size() < 3 || map.size() < 3) return best;
  const auto better = [](const ScaledMotion& a, const ScaledMotion& b) {
    const Eigen::Vector3d s = a.T_map_query.translation(), t = b.T_map_query.translation();
    return std::make_tuple(b.objects, a.scale, s.x(), s.y(), s.z()) <
           std::make_tuple(a.objects, b.scale, t.x(), t.y(), t.z());
  };
  std::mt19937 random(1);
  const auto draw = [&] { return static_cast<std::size_t>(random()) % query.size(); };
  for (std::size_t i = 0; i < search.triples; ++i) {
    const PointTriple here{draw(), draw(), draw()};
    const double shortest =
        std::min({side_of(query, here[0], here[1]), side_of(query, here[0], here[2]),
                  side_of(query, here[1], here[2])});
    if (shortest < search.min_side) continue;
    for_each_alike(map, query, here, search, [&](const PointTriple& there) {
      ScaledMotion motion = laid_over(map, there, query, here);
      motion.objects = coinciding(map, query, motion, search.tolerance);
      if (best.size() == search.kept && !better(motion, best.back())) return;
      best.insert(std::upper_bound(best.begin(), best.end(), motion, better), motion);
      if (best.size() > search.kept) best.pop_back();
    });
  }
  return best;
}

}  // namespace program
