// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <topobag/matching/class_confusion.hpp>
#include <topobag/types/class_catalog.hpp>

#include "keyframe.hpp"
#include "object_classes.hpp"
#include "object_map.hpp"

namespace program {

/// How often an object that a map calls by one class was called by another in the queries.
struct SharedObjects {
  topobag::ClassId map{}, query{};
  double count = 0.0;
};

/// How another system's map of objects goes together with one's own queries.
struct MapRelation {
  double scale = 1.0;                  ///< by which the map's lengths are longer than the queries'
  double deviation = 0.05;             ///< m; σ of the map's positions along each axis
  std::vector<SharedObjects> classes;  ///< ascending
  std::string map{};                   ///< file name of the map it was learnt of; empty: not said
};

/// What was learnt, and what it rests on.
struct LearntRelation {
  MapRelation relation;
  std::size_t objects = 0;    ///< that agree
  double significance = 0.0;  ///< −log10 of the alignments as good that chance would give
  double next_best = 0.0;     ///< the same of the best alignment that lies elsewhere
};

/// Lays a map of objects over a query's by geometry alone: the one motion and scale under which
/// most of them coincide, whatever their classes. Hypotheses from triples of objects, drawn with a
/// fixed seed; each is judged as a match whose objects are all of one class. The deviation is what
/// the coincident objects' residuals leave after the query's own covariances, along each axis.
/// Nothing where fewer than four objects coincide. O(triples · map² · query · map).
std::optional<LearntRelation> learn_relation(const std::vector<MappedObject>& map,
                                             const Keyframe& query);

/// P(the query's class | the map's) by what was learnt. Before anything is known, a class of the
/// map is mostly called the same, or, where it is a word of the map alone, by any class of the
/// queries.
topobag::ClassConfusion confusion_of(const MapRelation& relation, const ObjectClasses& classes);

/// Writes a relation as JSON, with the fingerprint of the catalog. Throws topobag::Error.
/// @param catalog  of the queries' classes and the map's
void write_relation(const std::string& path, const MapRelation& relation,
                    const topobag::ClassCatalog& catalog);

/// Reads one. Throws topobag::Error with the file, also where it was learnt by other classes; a
/// file that does not say by which is taken at its classes' names.
MapRelation read_relation(const std::string& path, const topobag::ClassCatalog& catalog);

}  // namespace program
