// SPDX-License-Identifier: MIT
// Which pairs of objects are one, and what pose do they tell: beside a spectral relaxation and a
// largest clique, each with one tolerance for all, as CLIPPER and TEASER++ find consensus?
//
// Every query of one table meets every key frame of another: the sample's, or two tables of one
// camera given as arguments (map, query, fx,fy,cx,cy). The best key frame by the method's own
// measure is its answer, whatever that is worth: correct within 0.3 m and 15 degrees, wrong beyond
// 1 m or 45 degrees. The baselines are this project's own, of pairs of one class, and are judged by
// the number of pairs that agree, ties by what is left over; their pose is the rigid fit. Times are
// of a pair of graphs, in one thread, without a repeat.
//   bench_consensus [MAP QUERY FX,FY,CX,CY]
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include <topobag/evaluation/pose_error.hpp>
#include <topobag/matching/match_graphs.hpp>
#include <topobag/matching/rigid_fit.hpp>
#include <topobag/recognition/recognition_options.hpp>

#include "clique_consensus.hpp"
#include "fixed_tolerance_pairs.hpp"
#include "keyframe_graphs.hpp"
#include "spectral_consensus.hpp"

namespace {

using Graph = topobag::TopologyGraph<>;

/// A pose and by how much it is believed.
struct Answer {
  double worth = 0.0, rms = 0.0;
  Eigen::Isometry3d T_candidate_query = Eigen::Isometry3d::Identity();

  bool operator>(const Answer& other) const {
    return worth != other.worth ? worth > other.worth : rms < other.rms;
  }
};

std::optional<Answer> fitted(const Graph& candidate, const Graph& query,
                             const std::vector<PlainPair>& pairs,
                             const std::vector<std::size_t>& chosen) {
  if (chosen.size() < 3) return std::nullopt;
  Eigen::Matrix3Xd target(3, static_cast<Eigen::Index>(chosen.size())), source = target;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const PlainPair& pair = pairs[chosen[i]];
    target.col(static_cast<Eigen::Index>(i)) = *candidate.nodes()[pair.candidate].position;
    source.col(static_cast<Eigen::Index>(i)) = *query.nodes()[pair.query].position;
  }
  const auto fit = topobag::fit_rigid(target, source);
  if (!fit) return std::nullopt;
  return Answer{static_cast<double>(chosen.size()), fit->rms, fit->T_target_source};
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// @param answer  of a candidate and a query: an `optional<Answer>`
template <typename Method>
void run(const char* name, const std::vector<program::Keyframe>& map,
         const std::vector<program::Keyframe>& queries, const Method& answer) {
  std::vector<double> times;
  std::size_t correct = 0, wrong = 0, silent = 0;
  for (const program::Keyframe& query : queries) {
    std::optional<Answer> best;
    std::size_t of = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      const std::optional<Answer> found = answer(map[i].graph, query.graph);
      const std::chrono::duration<double, std::micro> took =
          std::chrono::steady_clock::now() - start;
      times.push_back(took.count());
      if (!found || (best && !(*found > *best))) continue;
      best = found;
      of = i;
    }
    if (!best) {
      ++silent;
      continue;
    }
    const auto verdict = topobag::judge(topobag::pose_error(
        map[of].T_world_camera->inverse() * *query.T_world_camera, best->T_candidate_query));
    correct += verdict == topobag::PoseVerdict::correct ? 1 : 0;
    wrong += verdict == topobag::PoseVerdict::wrong ? 1 : 0;
  }
  std::printf("%-34s %7zu %7zu %7zu %7zu %10.1f %10.1f\n", name, queries.size(), correct, wrong,
              silent, quantile(times, 0.5), quantile(times, 0.99));
  std::printf(
      "{\"bench\":\"consensus\",\"method\":\"%s\",\"queries\":%zu,\"correct\":%zu,\"wrong\":%zu,"
      "\"silent\":%zu,\"median_us\":%.2f,\"p99_us\":%.2f}\n",
      name, queries.size(), correct, wrong, silent, quantile(times, 0.5), quantile(times, 0.99));
  std::fflush(stdout);
}

void compare(const std::vector<program::Keyframe>& map,
             const std::vector<program::Keyframe>& queries) {
  const topobag::MatchOptions options =
      topobag::recognition_options(topobag::ClassCatalog::coco80()).matching;
  run("topobag", map, queries, [&](const Graph& p, const Graph& q) -> std::optional<Answer> {
    const topobag::GraphMatch match = topobag::match_graphs(p, q, options);
    if (match.poses.empty()) return std::nullopt;
    const topobag::RelativePose& pose = match.poses.front();
    return Answer{pose.score(), pose.rms, pose.T_candidate_query};
  });
  for (const double tolerance : {0.05, 0.1, 0.2}) {
    const std::string within = ", " + std::to_string(std::lround(100.0 * tolerance)) + " cm";
    run(("largest clique" + within).c_str(), map, queries, [&](const Graph& p, const Graph& q) {
      const auto pairs = same_class_pairs(p, q);
      const Eigen::MatrixXd affinity = pair_affinity(p, q, pairs, tolerance);
      return fitted(p, q, pairs, CliqueConsensus(affinity).chosen());
    });
    run(("spectral relaxation" + within).c_str(), map, queries,
        [&](const Graph& p, const Graph& q) {
          const auto pairs = same_class_pairs(p, q);
          return fitted(p, q, pairs, spectral_consensus(pair_affinity(p, q, pairs, tolerance)));
        });
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    program::KeyframeOptions options;
    options.camera = {517.3, 516.5, 318.6, 255.3, 640, 480};
    std::string map = TOPOBAG_SAMPLE "/fr1_xyz", query = TOPOBAG_SAMPLE "/fr1_rpy";
    if (argc >= 4) {
      map = argv[1];
      query = argv[2];
      auto& camera = options.camera;
      if (std::sscanf(argv[3], "%lf,%lf,%lf,%lf", &camera.fx, &camera.fy, &camera.cx, &camera.cy) !=
          4) {
        throw std::invalid_argument("the camera is fx,fy,cx,cy");
      }
    }
    for (const double window : {0.0, 3.0}) {
      options.window = window;
      std::printf("%-34s %7s %7s %7s %7s %10s %10s\n",
                  window == 0.0 ? "single frames" : "windows of 3 s", "queries", "correct", "wrong",
                  "silent", "median, us", "p99, us");
      compare(program::read_keyframes(map, options), program::read_keyframes(query, options));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_consensus: %s\n", error.what());
    return 2;
  }
  return 0;
}
