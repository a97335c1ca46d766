// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

namespace program {

/// How one's own objects lie in another system's world, whose lengths are `scale` times as long.
struct ScaledMotion {
  double scale = 1.0;
  Eigen::Isometry3d T_map_query = Eigen::Isometry3d::Identity();  ///< m, the map's lengths / scale
  std::size_t objects = 0;                                        ///< of the query, that coincide
};

/// How alignments are looked for.
struct AlignmentSearch {
  std::size_t triples = 400;  ///< of the query's objects
  double tolerance = 0.06;    ///< m between two that coincide
  double min_side = 0.4;      ///< m of a triple
  double max_scale = 1.25;    ///< of either world over the other
  std::size_t kept = 32;      ///< best alignments that are returned
};

/// Alignments under which many objects coincide, most first; ties by scale, then by translation.
/// Triples are drawn with a fixed seed. O(triples · map² · map · query).
std::vector<ScaledMotion> propose_alignments(const std::vector<Eigen::Vector3d>& map,
                                             const std::vector<Eigen::Vector3d>& query,
                                             const AlignmentSearch& search = {});

}  // namespace program
