# SPDX-License-Identifier: MIT
"""Similarities held against each other on the same pairs of key frames."""

from __future__ import annotations

import dataclasses
import time
from typing import Callable, Mapping, Sequence, Union

import numpy as np

from . import _topobag as core

#: A callable (query, entry) -> number, or the scores themselves: a row per query.
OwnSimilarity = Union[Callable[[core.TopologyGraph, core.TopologyGraph], float], np.ndarray]


@dataclasses.dataclass(frozen=True)
class ComparedMethod:
    """One method of a comparison. Retrieval metrics are of each query's best answer."""

    name: str
    scores: np.ndarray  #: a row per query, a column per key frame of the map
    labelled: core.LabelledScores  #: with what the truth says of each pair
    metrics: core.RetrievalMetrics | None  #: nothing without a true place
    recall_at_1: float | None  #: of the queries with a true place
    recall_at_5: float | None  #: the same
    pair_us: float | None  #: time over pairs, µs; nothing of scores that were given


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Methods on the same pairs; prints as a table, the best average precision first."""

    protocol: str  #: what a true place is
    methods: tuple[ComparedMethod, ...]

    def __getitem__(self, name: str) -> ComparedMethod:
        for method in self.methods:
            if method.name == name:
                return method
        raise KeyError(f"no method is called {name!r}; there are {[m.name for m in self.methods]}")

    def __str__(self) -> str:
        def cell(value: float | None) -> str:
            return "-" if value is None else f"{value:.3f}"

        rows = [f"{'method':24}{'AP':>8}{'R@1':>8}{'R@5':>8}{'R@100P':>8}{'F1max':>8}{'us/pair':>10}"]
        for m in self.methods:
            numbers = [m.metrics and m.metrics.average_precision, m.recall_at_1, m.recall_at_5,
                       m.metrics and m.metrics.recall_at_100p, m.metrics and m.metrics.f1_max]  # fmt: skip
            rows.append(f"{m.name:24}" + "".join(f"{cell(n):>8}" for n in numbers)
                        + ("         -" if m.pair_us is None else f"{m.pair_us:10.2f}"))  # fmt: skip
        return "\n".join(rows) + f"\nA true place: {self.protocol}."


def all_similarities(background: Sequence[core.TopologyGraph]) -> dict[str, core.Similarity]:
    """Every similarity of the library by the name that the program's `compare` gives it.

    Class weights are learnt from `background`, the map.
    """
    return {
        "padded cosine": core.PaddedCosine(),
        "sorted rows": core.PaddedCosine(core.RowOrder.class_then_position),
        "assigned rows": core.PaddedCosine(core.RowOrder.assignment),
        "affinity cosine": core.AffinityCosine(),
        "class counts, cosine": core.ClassHistogram(core.HistogramMeasure.cosine),
        "class counts, Jaccard": core.ClassHistogram(),
        "class counts, tf-idf": core.ClassHistogram(
            core.HistogramMeasure.cosine, core.ClassWeights.idf(background)
        ),
        "class pairs x distance": core.ClassPairDistanceHistogram(),
        "class triangles": core.ClassTriangles(),
        "label walks": core.LabelWalks(),
        "neighbour labels": core.SurroundingLabels(),
        "neighbour label pairs": core.SurroundingLabels(core.Surroundings.neighbor_pairs),
        "Weisfeiler-Lehman": core.WeisfeilerLehman(),
        "semantic sub-graph": core.SemanticSubgraph(),
        "geometric consistency": core.ConsistencySimilarity(),
    }


def _scores(similarity, queries, entries) -> tuple[np.ndarray, float | None]:
    """All scores, and what a pair took, µs."""
    if not callable(similarity):
        scores = np.asarray(similarity, dtype=float)
        if scores.shape != (len(queries), len(entries)):
            raise core.InvalidValue(
                f"the scores have the shape {scores.shape}; give {len(queries)} queries x "
                f"{len(entries)} key frames of the map"
            )
        return scores, None
    start = time.perf_counter()
    if isinstance(similarity, core.Similarity):
        scores = similarity.matrix(queries, entries)
    else:
        scores = np.array([[similarity(q, e) for e in entries] for q in queries], dtype=float)
        scores = scores.reshape(len(queries), len(entries))
    return scores, 1e6 * (time.perf_counter() - start) / max(1, scores.size)


def compare(
    queries: Sequence[core.Keyframe],
    entries: Sequence[core.Keyframe],
    own: Mapping[str, OwnSimilarity] | None = None,
    protocol: str = "distance=0.5,angle=30",
    similarities: Mapping[str, OwnSimilarity] | None = None,
) -> Comparison:
    """Holds similarities against each other on all pairs of two sequences of one world.

    `own` are yours, beside the library's; `similarities`, where given, stand in for the library's.
    Key frames need true poses. Raises InvalidValue for key frames without one, scores of another
    shape, and a protocol that calls no pair false: every ranking would be right.
    """
    query_graphs = [keyframe.graph for keyframe in queries]
    entry_graphs = [keyframe.graph for keyframe in entries]
    truth = core.PlaceTruth(protocol, *(_trajectory(k) for k in (queries, entries)))
    if not _has_false_pairs(truth):
        raise core.InvalidValue(
            f"the protocol {truth.protocol} calls no pair false, so that every ranking is right and nothing is "
            "compared; call fewer places true, or give a map that holds others too"
        )
    methods = []
    chosen = all_similarities(entry_graphs) if similarities is None else similarities
    for name, similarity in {**chosen, **(own or {})}.items():
        scores, pair_us = _scores(similarity, query_graphs, entry_graphs)
        labelled = core.label_scores(scores, truth)
        methods.append(
            ComparedMethod(
                name, scores, labelled, core.retrieval_metrics(core.single_best(labelled)),
                core.recall_at_k(labelled, 1).of_queries_with_positive,
                core.recall_at_k(labelled, 5).of_queries_with_positive, pair_us,
            )  # fmt: skip
        )
    methods.sort(key=lambda m: -(m.metrics.average_precision if m.metrics else 0.0))
    return Comparison(protocol, tuple(methods))


def _has_false_pairs(truth: core.PlaceTruth) -> bool:
    queries, entries = truth.shape
    false = core.PairRelation.negative
    return any(truth.relation(i, j) == false for i in range(queries) for j in range(entries))


def _trajectory(keyframes: Sequence[core.Keyframe]) -> core.Trajectory:
    """The true poses of all key frames."""
    for keyframe in keyframes:
        if keyframe.T_world_camera is None:
            raise core.InvalidValue(f"key frame {keyframe.idx} has no pose, which the truth needs")
    return core.Trajectory([k.stamp for k in keyframes], [k.T_world_camera for k in keyframes])
