// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "keyframe_graphs.hpp"
#include "recombined_graphs.hpp"

/// The graphs of single frames of node tables.
inline std::vector<topobag::TopologyGraph<>> graphs_of_tables(
    const std::vector<std::string>& sets) {
  program::KeyframeOptions options;
  options.camera = {517.3, 516.5, 318.6, 255.3, 640, 480};
  options.window = 0.0;
  std::vector<topobag::TopologyGraph<>> graphs;
  for (const std::string& set : sets) {
    for (auto& keyframe : program::read_keyframes(set, options)) {
      graphs.push_back(std::move(keyframe.graph));
    }
  }
  return graphs;
}

/// A robot's drive through ever new places, in each of which it takes one to 30 key frames.
class Drive {
 public:
  Drive(std::vector<topobag::TopologyGraph<>> pieces, std::uint64_t seed)
      : source_(std::move(pieces), seed) {}

  topobag::TopologyGraph<> next() {
    if (left_ == 0) {
      places_.push_back(source_.place());
      left_ = 1 + source_.below(30);
    }
    --left_;
    return source_.keyframe(places_.back());
  }

  /// Another key frame of one of the places so far.
  topobag::TopologyGraph<> revisit() {
    return source_.keyframe(places_[source_.below(places_.size())]);
  }

 private:
  RecombinedGraphs source_;
  std::vector<RecombinedGraphs::Nodes> places_;
  std::size_t left_ = 0;
};
