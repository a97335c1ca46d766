// SPDX-License-Identifier: MIT
// Does a pose know its doubt?
//
// The normalised estimation error squared (NEES) of true matches: the squared Mahalanobis length of
// the pose's error ξ, T_true = Exp(ξ) · T_estimate, under the pose's covariance. Where covariances
// are honest its mean is 6 and its median 5.35; above, poses are surer than they may be. The
// figures are by the number of matched objects and by how far the pose turns the view of them.
//
// Every query meets the entries most like it; of the poses that are true (within 1 m and 45° of the
// truth) and not degenerate the best by score is taken, one for each band of view change. Some of
// them are true by accident: they match other objects of a class, a metre from the right ones. No
// noise of positions covers that, so the mean is also given of the matches whose objects all are
// where the true pose puts them, to 0.4 m or half their size.
//
// It reads tables that are not part of the project: a folder given as the argument, or by the
// variable TOPOBAG_DATA, with nodes/tum_fr1_*, nodes/fr2_desk.*, nodes/fr3_long_office.* and
// rooms/.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/matching/match_graphs.hpp>

#include "keyframe_graphs.hpp"

namespace {

constexpr double degree = 0.017453292519943295;               // rad
constexpr std::array<double, 3> band_ends{15.0, 45.0, 90.0};  // °
constexpr std::size_t max_candidates = 64;

/// Where queries come from and what they are looked up in.
struct Place {
  std::string name;
  std::string map, query;  ///< tables; the same one for loops
  program::KeyframeOptions options{};
  std::size_t every = 1;  ///< of the queries, one in so many is asked
  double min_age = 0.0;   ///< s that an entry must be older than a query of the same table
};

/// One true match.
struct Sample {
  std::size_t inliers = 0;
  double view_change = 0.0;  ///< °, mean over the inliers
  double nees = 0.0;
  bool right = false;  ///< whether every pair is one object
  topobag::PoseError error;
};

/// ξ = (translation m, rotation rad) with T = Exp(ξ). Where a rotation is small, as an error is,
/// the translation of Exp is its second factor's but for a turn by half the rotation; both are
/// taken.
Eigen::Matrix<double, 6, 1> logarithm(const Eigen::Isometry3d& T) {
  const Eigen::AngleAxisd turn(T.linear());
  const Eigen::Vector3d w = turn.angle() * turn.axis();
  Eigen::Matrix3d W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  const double a = turn.angle();
  const double c = a < 1e-4 ? 1.0 / 12.0 : (1.0 - 0.5 * a / std::tan(0.5 * a)) / (a * a);
  Eigen::Matrix<double, 6, 1> xi;
  xi << T.translation() - 0.5 * W * T.translation() + c * W * W * T.translation(), w;
  return xi;
}

/// The mean angle, °, between the directions in which the two cameras saw the matched objects.
double view_change(const topobag::TopologyGraph<>& candidate, const topobag::TopologyGraph<>& query,
                   const std::vector<topobag::Correspondence>& pairs, const Eigen::Isometry3d& T) {
  double sum = 0.0;
  for (const auto& pair : pairs) {
    const Eigen::Vector3d there = *candidate.node(pair.candidate).position;
    const Eigen::Vector3d here = T.linear() * *query.node(pair.query).position;
    sum += std::atan2(there.cross(here).norm(), there.dot(here));
  }
  return sum / degree / static_cast<double>(pairs.size());
}

/// Whether the true pose brings every pair together, to 0.4 m or half the object's size.
bool are_right(const topobag::TopologyGraph<>& candidate, const topobag::TopologyGraph<>& query,
               const std::vector<topobag::Correspondence>& pairs, const Eigen::Isometry3d& T) {
  return std::all_of(pairs.begin(), pairs.end(), [&](const topobag::Correspondence& pair) {
    const auto &there = candidate.node(pair.candidate), &here = query.node(pair.query);
    const double size = std::sqrt(std::sqrt(there.size.prod() * here.size.prod()));
    return (*there.position - T * *here.position).norm() <= std::max(0.4, 0.5 * size);
  });
}

/// The best true match of one query in each band of view change.
template <typename Use>
void true_matches(const program::Keyframe& query, const std::vector<program::Keyframe>& map,
                  const std::vector<topobag::Candidate>& candidates, Use&& use) {
  std::array<std::optional<Sample>, band_ends.size()> best;
  std::array<double, band_ends.size()> best_score{};
  std::array<std::pair<std::size_t, topobag::RelativePose>, band_ends.size()> best_pose;
  for (const topobag::Candidate& candidate : candidates) {
    const program::Keyframe& entry = map[value(candidate.id)];
    const Eigen::Isometry3d T_true = entry.T_world_camera->inverse() * *query.T_world_camera;
    for (const auto& pose : topobag::match_graphs(entry.graph, query.graph).poses) {
      const auto error = topobag::pose_error(T_true, pose.T_candidate_query);
      if (pose.degenerate || topobag::judge(error) == topobag::PoseVerdict::wrong) continue;
      const double turn = view_change(entry.graph, query.graph, pose.inliers, T_true);
      std::size_t band = 0;
      while (band < band_ends.size() && turn > band_ends[band]) ++band;
      if (band == band_ends.size()) continue;
      if (best[band] && best_score[band] >= pose.score()) continue;
      const auto xi = logarithm(T_true * pose.T_candidate_query.inverse());
      best[band] = Sample{pose.inliers.size(), turn, xi.dot(pose.covariance.ldlt().solve(xi)),
                          are_right(entry.graph, query.graph, pose.inliers, T_true), error};
      best_score[band] = pose.score();
      best_pose[band] = {value(candidate.id), pose};
    }
  }
  for (std::size_t band = 0; band < best.size(); ++band) {
    if (best[band]) use(*best[band], map[best_pose[band].first], query, best_pose[band].second);
  }
}

/// Calls `use` for every true match of a place.
template <typename Use>
void for_true_matches(const Place& place, Use&& use) {
  const auto map = program::read_keyframes(place.map, place.options);
  const bool loops = place.map == place.query;
  auto other = place.options;
  other.stress.stream = 1;  // another noise of gravity
  const auto queries =
      loops ? std::vector<program::Keyframe>{} : program::read_keyframes(place.query, other);
  topobag::BagOfTopologyGraphs<> bag;
  for (std::size_t i = 0; i < map.size(); ++i) {
    topobag::EntryInfo info;
    info.stamp = map[i].timestamp;
    bag.add(topobag::KeyframeId{i}, map[i].graph, info);
  }
  const auto& asked = loops ? map : queries;
  for (std::size_t i = 0; i < asked.size(); i += place.every) {
    topobag::QueryOptions options;
    options.max_results = max_candidates;
    if (loops) {
      options.filter = [&](topobag::KeyframeId, const topobag::EntryInfo& info) {
        return *info.stamp <= asked[i].timestamp - place.min_age;
      };
    }
    true_matches(asked[i], map, bag.query(asked[i].graph, options), use);
  }
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void print(const std::string& place, const char* gravity, const std::string& cell,
           const std::vector<Sample>& samples) {
  if (samples.empty()) return;
  std::vector<double> nees, right_nees, metres, degrees;
  for (const Sample& sample : samples) {
    nees.push_back(sample.nees);
    if (sample.right) right_nees.push_back(sample.nees);
    metres.push_back(sample.error.translation_m);
    degrees.push_back(sample.error.rotation_deg);
  }
  const double right_mean = right_nees.empty() ? 0.0 : mean(right_nees);
  std::printf("%-14s %-7s %-9s %6zu %8.2f %8.2f %6zu %8.2f %8.3f %6.2f\n", place.c_str(), gravity,
              cell.c_str(), nees.size(), mean(nees), quantile(nees, 0.5), right_nees.size(),
              right_mean, quantile(metres, 0.5), quantile(degrees, 0.5));
  std::printf(
      "{\"bench\":\"nees\",\"place\":\"%s\",\"gravity\":\"%s\",\"cell\":\"%s\",\"samples\":%zu,"
      "\"mean\":%.3f,\"median\":%.3f,\"right\":%zu,\"right_mean\":%.3f,\"median_m\":%.4f,"
      "\"median_deg\":%.3f}\n",
      place.c_str(), gravity, cell.c_str(), nees.size(), mean(nees), quantile(nees, 0.5),
      right_nees.size(), right_mean, quantile(metres, 0.5), quantile(degrees, 0.5));
}

void print_cells(const std::string& place, const char* gravity,
                 const std::vector<Sample>& samples) {
  for (std::size_t inliers = gravity[0] == 'w' ? 2 : 3; inliers <= 6; ++inliers) {
    std::vector<Sample> cell;
    for (const Sample& sample : samples) {
      if (std::min<std::size_t>(sample.inliers, 6) == inliers) cell.push_back(sample);
    }
    print(place, gravity, std::to_string(inliers) + (inliers == 6 ? "+ obj." : " obj."), cell);
  }
  double begin = 0.0;
  for (const double end : band_ends) {
    std::vector<Sample> cell;
    for (const Sample& sample : samples) {
      if (sample.view_change <= end && sample.view_change >= begin) cell.push_back(sample);
    }
    char name[16];
    std::snprintf(name, sizeof name, "%.0f-%.0f deg", begin, end);
    print(place, gravity, name, cell);
    begin = end;
  }
}

std::vector<Place> places(const std::string& data) {
  const auto options = [](std::array<double, 4> k, double interval, double window) {
    program::KeyframeOptions keyframes;
    keyframes.camera = {k[0], k[1], k[2], k[3], 640, 480};
    keyframes.interval = interval;
    keyframes.window = window;
    return keyframes;
  };
  const std::string nodes = data + "/nodes/", rooms = data + "/rooms/";
  const std::array<double, 4> fr1{517.3, 516.5, 318.6, 255.3}, fr2{520.9, 521.0, 325.1, 249.7},
      fr3{535.4, 539.2, 320.1, 247.6}, room{525.0, 525.0, 319.5, 239.5};
  const std::string fr2_desk = nodes + "fr2_desk.oaslam_yolov5_tri",
                    fr3_office = nodes + "fr3_long_office.eao_yolo_tri";
  return {{"fr1 yolox", nodes + "tum_fr1_xyz.yolox_nano_416", nodes + "tum_fr1_rpy.yolox_nano_416",
           options(fr1, 0.4, 3.0)},
          {"fr1 picodet", nodes + "tum_fr1_xyz.picodet_s_416", nodes + "tum_fr1_rpy.picodet_s_416",
           options(fr1, 0.4, 3.0)},
          {"fr3 loops", fr3_office, fr3_office, options(fr3, 0.4, 3.0), 1, 20.0},
          {"fr2 loops", fr2_desk, fr2_desk, options(fr2, 0.4, 3.0), 1, 20.0},
          {"rooms, frames", rooms + "own_map", rooms + "query", options(room, 0.0, 0.0), 10},
          {"rooms, 3 s", rooms + "own_map", rooms + "query", options(room, 0.0, 3.0), 10}};
}

void bench(Place place, bool gravity) {
  if (gravity) place.options.gravity.world_up = Eigen::Vector3d::UnitZ();
  std::vector<Sample> samples;
  for_true_matches(place, [&](const Sample& sample, const auto&...) { samples.push_back(sample); });
  print_cells(place.name, gravity ? "with" : "without", samples);
}

}  // namespace

int main(int argc, char** argv) {
  const char* variable = std::getenv("TOPOBAG_DATA");
  const std::string data = argc > 1 ? argv[1] : variable ? variable : "";
  if (data.empty() || !std::filesystem::exists(data + "/nodes")) {
    std::printf("bench_nees skips: no folder of tables, as an argument or in TOPOBAG_DATA\n");
    return 0;
  }
  std::printf("%-14s %-7s %-9s %6s %8s %8s %6s %8s %8s %6s\n", "", "gravity", "cell", "n", "mean",
              "median", "right", "mean", "error, m", "deg");
  try {
    for (const Place& place : places(data)) {
      for (const bool gravity : {false, true}) bench(place, gravity);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_nees: %s\n", error.what());
    return 2;
  }
  return 0;
}
