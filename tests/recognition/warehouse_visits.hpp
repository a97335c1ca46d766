// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <topobag/evaluation/pose_error.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/types/class_catalog.hpp>

#include "warehouse.hpp"

/// What became of queries in a warehouse.
struct WarehouseFigures {
  std::size_t queries = 0;
  std::size_t correct = 0;
  std::size_t imprecise = 0;
  std::size_t wrong = 0;
  std::size_t rivalled = 0;  ///< refused since another place fits about as well
  std::size_t told = 0;      ///< of these, whose explanation names its key frame

  std::size_t accepted() const { return correct + imprecise + wrong; }
  std::size_t refused() const { return queries - accepted(); }

  void operator+=(const WarehouseFigures& other) {
    queries += other.queries;
    correct += other.correct;
    imprecise += other.imprecise;
    wrong += other.wrong;
    rivalled += other.rivalled;
    told += other.told;
  }
};

/// A warehouse whose loop was driven once, by the library's defaults.
class WarehouseMap {
 public:
  WarehouseMap(unsigned seed, const WarehouseOptions& options) : warehouse_(seed, options) {
    poses_ = warehouse_.loop();
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      topobag::EntryInfo info;
      info.T_world_camera = poses_[i];
      relocalizer_.map().add(topobag::KeyframeId{i}, warehouse_.seen_from(poses_[i]), info);
    }
  }

  /// A second round of the loop.
  WarehouseFigures second_round() { return figures_of(warehouse_.loop(), true); }

  /// The aisles that the map does not hold: whatever is accepted is wrong.
  WarehouseFigures other_aisles() { return figures_of(warehouse_.other_aisles(), false); }

 private:
  WarehouseFigures figures_of(const std::vector<Eigen::Isometry3d>& poses, bool mapped) {
    WarehouseFigures figures;
    for (const Eigen::Isometry3d& T_world_query : poses) {
      const auto query = warehouse_.seen_from(T_world_query);
      if (!query.is_matchable()) continue;
      ++figures.queries;
      const topobag::Recognition found = relocalizer_.localize(query);
      if (found) {
        count(found, T_world_query, mapped, figures);
      } else if (!found.candidates.empty() &&
                 found.candidates.front().verdict == topobag::Verdict::rivalled) {
        ++figures.rivalled;
        const auto& rival = *found.candidates.front().rival;
        const std::string text =
            to_string(topobag::explain(found, relocalizer_.map(), query,
                                       topobag::ClassCatalog::coco80(), relocalizer_.options()));
        const std::string line = "another place fits about as well: key frame " +
                                 std::to_string(topobag::value(rival.id)) + ", with the query at";
        if (text.find(line) != std::string::npos) ++figures.told;
      }
    }
    return figures;
  }

  void count(const topobag::Recognition& found, const Eigen::Isometry3d& T_world_query, bool mapped,
             WarehouseFigures& figures) const {
    const auto verdict =
        mapped
            ? topobag::judge(topobag::pose_error(T_world_query, *relocalizer_.T_world_query(found)))
            : topobag::PoseVerdict::wrong;
    if (verdict == topobag::PoseVerdict::correct) ++figures.correct;
    if (verdict == topobag::PoseVerdict::imprecise) ++figures.imprecise;
    if (verdict == topobag::PoseVerdict::wrong) ++figures.wrong;
  }

  Warehouse warehouse_;
  std::vector<Eigen::Isometry3d> poses_;
  topobag::Relocalizer<> relocalizer_;
};
