// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <topobag/types/class_catalog.hpp>

#include "keyframe.hpp"

namespace program {

/// An object of another system's map.
struct MappedObject {
  std::map<topobag::ClassId, double> weights;          ///< of its classes, each positive
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, in that map's world
  Eigen::Vector3d extent = Eigen::Vector3d::Zero();    ///< m, along its own axes; 0 = unknown

  /// The class with the most weight; of equal ones the smaller number.
  topobag::ClassId label() const;
};

/// How a map of objects becomes a graph.
struct ObjectMapOptions {
  double deviation = 0.05;  ///< m; σ of a position along each axis, scaled
  double scale = 1.0;       ///< by which the map's lengths are too long
  std::string relation{};   ///< file that says so; empty: none
  std::string learnt_of{};  ///< file name of the map that the relation was learnt of; empty: unsaid
};

/// Says on stderr when the relation in use was learnt of a map of another name, or does not say of
/// which.
void tell_of_relation(const ObjectMapOptions& options, const std::string& map);

/// Reads a map of objects: JSON with `nodes`, of each `translation` (x, y, z, m), optionally
/// `radii` (half its extent, m; their sign means nothing) and `baseline_label`, number of a class →
/// its weight, or a list that begins with it. Throws InputError with the file and the node.
/// @param first  number of the catalog's class that the file calls 0
std::vector<MappedObject> read_object_map(const std::string& path,
                                          const topobag::ClassCatalog& catalog, int first = 0);

/// A map of objects as one place, in metres along its world's axes, whose origin is the pose. It
/// has no views: nobody stood there; and how surely one's own detector shows an object is not
/// known, so that a missing one says next to nothing. Of the classes of an object the likeliest is
/// its label and that one's share of the weights its confidence. Sizes are unknown: which way an
/// ellipsoid stands is not said in a world whose vertical is not.
Keyframe object_map_place(const std::vector<MappedObject>& objects,
                          const ObjectMapOptions& options);

}  // namespace program
