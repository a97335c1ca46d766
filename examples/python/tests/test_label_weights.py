# SPDX-License-Identifier: MIT
"""Objects that may be of several classes, and classes that may be one object by a callable."""

import math
import threading

import numpy as np
import pytest
import topobag
from conftest import FR1, random_nodes

LABELS = [[41, 45, -1], [73, -1, -1], [62, 63, 66]]
WEIGHTS = [[0.6, 0.3, 0.0], [1.0, 0.0, 0.0], [2.0, 2.0, 0.5]]


def test_nodes_keep_what_they_may_be():
    nodes = topobag.Nodes([41, 73, 63], np.eye(3), weighted_labels=LABELS, label_weights=WEIGHTS)
    assert nodes.weighted_labels.tolist() == [[41, 45, -1], [-1, -1, -1], [62, 63, 66]]
    assert nodes.weighted_labels.dtype == np.int32
    assert nodes.label_weights == pytest.approx(np.array([[1, 0.5, 0], [0, 0, 0], [1, 1, 0.25]]), abs=1 / 510)
    graph = topobag.TopologyGraph(nodes, topobag.KnnEdges())
    again = topobag.TopologyGraph.decode(graph.encode())
    for same in (graph, graph.nodes, again, nodes[np.array([0, 1, 2])]):
        assert (same.weighted_labels == nodes.weighted_labels).all()
        assert (same.label_weights == nodes.label_weights).all()
    columns = {"weighted_labels": nodes.weighted_labels, "label_weights": nodes.label_weights}
    assert (topobag.Nodes(nodes.labels, np.eye(3), **columns).label_weights == nodes.label_weights).all()
    assert topobag.Nodes([1, 2], np.eye(3)[:2]).weighted_labels.shape == (2, 0)


def test_the_best_five_stay():
    nodes = topobag.Nodes([7], weighted_labels=[[1, 2, 3, 4, 5, 6, 7]], label_weights=[[1, 2, 3, 4, 5, 6, 7]])
    assert nodes.weighted_labels.tolist() == [[7, 6, 5, 4, 3]]


def test_detections_keep_what_they_may_be():
    boxes = [[100, 100, 180, 180], [300, 120, 360, 200], [200, 200, 260, 280]]
    options = {"weighted_labels": LABELS, "label_weights": WEIGHTS}
    lifted = topobag.lift_detections(boxes, [41, 73, 62], None, [1.0, 2.0, 3.0], FR1, **options).nodes
    sighted = topobag.sight_keyframe(0.0, boxes, [41, 73, 62], None, [1.0, 2.0, 3.0], FR1, **options).nodes
    for nodes in (lifted, sighted):
        assert nodes.weighted_labels.tolist() == [[41, 45, -1], [-1, -1, -1], [62, 63, 66]]


def test_weights_that_do_not_go_with_the_objects_are_refused():
    for wrong, says in [
        ({"weighted_labels": LABELS}, "go together"),
        ({"label_weights": WEIGHTS}, "go together"),
        ({"weighted_labels": LABELS[:2], "label_weights": WEIGHTS[:2]}, "rows"),
        ({"weighted_labels": LABELS, "label_weights": np.ones((3, 2))}, "label_weights"),
        ({"weighted_labels": LABELS, "label_weights": -np.ones((3, 3))}, "object 0: label 0 has a weight"),
        ({"weighted_labels": [[1, 2**31, 3]] * 3, "label_weights": WEIGHTS}, "32-bit"),
        ({"weighted_labels": [[1, 2, 3]] * 3, "label_weights": WEIGHTS}, "best"),
    ]:
        with pytest.raises(ValueError, match=says):
            topobag.Nodes([41, 73, 62], np.eye(3), **wrong)


def two_views(random):
    """Cups (41) of one view are bowls (45) in the other."""
    nodes = random_nodes(random, 10)
    columns = {"pixels": nodes.pixels, "sizes": nodes.sizes}
    labels = np.where(np.arange(10) % 2, 41, 62)
    renamed = np.where(labels == 41, 45, labels)
    return [topobag.TopologyGraph(topobag.Nodes(l, nodes.positions, **columns), topobag.KnnEdges())
            for l in (labels, renamed)]  # fmt: skip


def options_with(affinity):
    options = topobag.MatchOptions()
    options.consistency.affinity = options.chance.affinity = affinity
    return options


def test_an_affinity_says_which_classes_may_be_one(random):
    cups, bowls = two_views(random)
    asked = []

    def affinity(candidate, query):
        asked.append((candidate, query))
        return 0.5 if (candidate, query) == (41, 45) else 0.0

    found = topobag.match_graphs(cups, bowls, options_with(affinity)).poses[0]
    assert len(found.inliers) == 10
    assert (41, 45) in asked and all(a != b for a, b in asked)
    none = topobag.match_graphs(cups, bowls, options_with(lambda a, b: 0.0)).poses
    assert not none or len(none[0].inliers) <= 5
    back = topobag.match_graphs(bowls, cups, options_with(affinity)).poses  # not symmetric
    assert not back or len(back[0].inliers) <= 5


def test_a_pair_costs_what_the_affinity_says(random):
    cups, bowls = two_views(random)
    significance = [
        topobag.match_graphs(cups, bowls, options_with(lambda a, b, p=p: p)).poses[0].significance for p in (1.0, 0.1)
    ]
    assert significance[0] - significance[1] == pytest.approx(5 * -math.log10(0.1), abs=0.05)


def test_an_affinity_may_be_a_matrix(random):
    cups, bowls = two_views(random)
    matrix = np.eye(80)
    matrix[41, 45] = 0.25
    found = topobag.match_graphs(cups, bowls, options_with(lambda a, b: matrix[a, b])).poses[0]
    assert len(found.inliers) == 10


def test_what_an_affinity_raises_comes_through(random):
    cups, bowls = two_views(random)

    def raising(candidate, query):
        raise KeyError("no such class")

    with pytest.raises(KeyError, match="no such class"):
        topobag.match_graphs(cups, bowls, options_with(raising))
    with pytest.raises(topobag.InvalidValue, match=r"not in \[0, 1\]"):
        topobag.match_graphs(cups, bowls, options_with(lambda a, b: 2.0))
    with pytest.raises(TypeError):
        options_with("cup")
    assert options_with(None).consistency.affinity is None


def test_threads_ask_one_affinity(random):
    pairs = [two_views(random) for _ in range(8)]
    options = options_with(lambda a, b: 0.5)
    alone = [len(topobag.match_graphs(*pair, options).poses[0].inliers) for pair in pairs]
    together = [0] * len(pairs)

    def match(i):
        together[i] = len(topobag.match_graphs(*pairs[i], options).poses[0].inliers)

    threads = [threading.Thread(target=match, args=(i,)) for i in range(len(pairs))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert together == alone == [10] * len(pairs)
