// SPDX-License-Identifier: MIT
#include "cluster_table.hpp"

#include <map>
#include <optional>

#include "csv_reader.hpp"

namespace program {
namespace {

/// Three numbers of a row, by the names of their columns.
class Triple {
 public:
  Triple(const CsvReader& csv, const char* x, const char* y, const char* z)
      : csv_(csv), columns_{csv.column(x), csv.column(y), csv.column(z)} {}

  Eigen::Vector3d read() const {
    return {csv_.number(columns_[0]), csv_.number(columns_[1]), csv_.number(columns_[2])};
  }

 private:
  const CsvReader& csv_;
  std::size_t columns_[3];
};

}  // namespace

NodeTable read_cluster_table(const std::string& set, const topobag::ClassCatalog& catalog) {
  NodeTable table{read_frames(set)};
  std::map<std::int64_t, FrameRow*> by_idx;
  for (FrameRow& frame : table.frames) by_idx.emplace(frame.idx, &frame);
  CsvReader csv(set_name(set) + ".clusters.csv");
  const std::size_t idx = csv.column("idx"), label = csv.column("class"), conf = csv.column("conf");
  const Triple centroid(csv, "x", "y", "z"), extent(csv, "dx", "dy", "dz");
  std::optional<Triple> deviation;
  if (csv.find_column("sx")) deviation.emplace(csv, "sx", "sy", "sz");
  while (csv.next()) {
    const auto frame = by_idx.find(csv.integer(idx));
    if (frame == by_idx.end()) {
      throw csv.error("idx " + std::string(csv.text(idx)) + " is not among the frames");
    }
    topobag::ObjectCluster cluster;
    cluster.label = csv.located([&] { return catalog.at(csv.text(label)); });
    cluster.confidence = csv.number(conf);
    cluster.centroid = centroid.read();
    cluster.extent = extent.read();
    if (!(cluster.extent.minCoeff() >= 0.0)) {
      throw csv.error(
          "dx, dy and dz, the cluster's size, have to be positive, or 0 where not known");
    }
    if (deviation) {
      const Eigen::Vector3d sigma = deviation->read();
      if (!(sigma.minCoeff() > 0.0)) throw csv.error("sx, sy and sz have to be positive");
      cluster.covariance = sigma.cwiseAbs2().asDiagonal();
    }
    frame->second->clusters.push_back(cluster);
  }
  return table;
}

}  // namespace program
