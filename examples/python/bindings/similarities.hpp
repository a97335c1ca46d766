// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <topobag/evaluation/labelled_scores.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/similarity.hpp>

namespace python {

using Graph = topobag::TopologyGraph<>;

/// A similarity, whichever it is.
class Similarity {
 public:
  /// What is worked out of one graph.
  using Descriptor = std::shared_ptr<const void>;

  virtual ~Similarity() = default;
  virtual double operator()(const Graph& p, const Graph& q) const = 0;
  virtual Descriptor descriptor(const Graph& graph) const = 0;
  virtual double similarity(const Descriptor& p, const Descriptor& q) const = 0;

  /// Of every pair: a row per query, a column per graph of the map.
  topobag::ScoreMatrix matrix(const std::vector<const Graph*>& queries,
                              const std::vector<const Graph*>& map) const {
    topobag::ScoreMatrix scores(static_cast<Eigen::Index>(queries.size()),
                                static_cast<Eigen::Index>(map.size()));
    std::vector<Descriptor> of_map;
    for (const Graph* graph : map) of_map.push_back(descriptor(*graph));
    double* score = scores.data();
    for (const Graph* graph : queries) {
      const Descriptor query = descriptor(*graph);
      for (const Descriptor& candidate : of_map) *score++ = similarity(candidate, query);
    }
    return scores;
  }
};

/// One of the library's.
template <typename S>
class SimilarityOf : public Similarity, public S {
  using Known = topobag::descriptor_t<S, Graph>;

 public:
  double operator()(const Graph& p, const Graph& q) const override { return S::operator()(p, q); }
  Descriptor descriptor(const Graph& graph) const override {
    return std::make_shared<const Known>(S::descriptor(graph));
  }
  double similarity(const Descriptor& p, const Descriptor& q) const override {
    return S::similarity(*static_cast<const Known*>(p.get()), *static_cast<const Known*>(q.get()));
  }
};

/// The user's own: a callable, which is given graphs.
class OwnSimilarity : public Similarity {
 public:
  using Callable = std::function<double(const Graph&, const Graph&)>;

  explicit OwnSimilarity(Callable callable) : callable_(std::move(callable)) {}

  double operator()(const Graph& p, const Graph& q) const override { return callable_(p, q); }
  Descriptor descriptor(const Graph& graph) const override {
    return std::make_shared<const Graph>(graph);
  }
  double similarity(const Descriptor& p, const Descriptor& q) const override {
    return callable_(*static_cast<const Graph*>(p.get()), *static_cast<const Graph*>(q.get()));
  }

 private:
  Callable callable_;
};

/// Any of them, as a bag keeps it.
class AnySimilarity {
 public:
  explicit AnySimilarity(std::shared_ptr<const Similarity> similarity)
      : similarity_(std::move(similarity)) {}

  double operator()(const Graph& p, const Graph& q) const { return (*similarity_)(p, q); }
  Similarity::Descriptor descriptor(const Graph& graph) const {
    return similarity_->descriptor(graph);
  }
  double similarity(const Similarity::Descriptor& p, const Similarity::Descriptor& q) const {
    return similarity_->similarity(p, q);
  }

 private:
  std::shared_ptr<const Similarity> similarity_;
};

}  // namespace python
