# SPDX-License-Identifier: MIT
"""Nodes, edges and graphs against NumPy."""

import pickle

import numpy as np
import pytest
import topobag
from conftest import FR1, random_graph, random_nodes


def test_columns_come_back_as_they_were_given(random):
    labels = random.integers(0, 80, 6)
    columns = {
        "pixels": random.uniform(0, 480, (6, 2)),
        "z": random.uniform(1, 5, 6),
        "sizes": random.uniform(0.1, 1, (6, 2)),
        "confidences": random.uniform(0, 1, 6),
        "existence": random.uniform(0.1, 1, 6),
        "covariances": np.einsum("i,jk->ijk", random.uniform(0.01, 1, 6), np.eye(3)),
    }
    positions = random.normal(size=(6, 3))
    nodes = topobag.Nodes(labels, positions, **columns)
    np.testing.assert_array_equal(nodes.labels, labels)
    np.testing.assert_array_equal(nodes.positions, positions)
    for name, column in columns.items():
        np.testing.assert_array_equal(getattr(nodes, name), column)


def test_absent_positions_and_pixels_are_nan_both_ways():
    positions = np.array([[1.0, 2.0, 3.0], [np.nan] * 3])
    nodes = topobag.Nodes([0, 1], positions)
    np.testing.assert_array_equal(nodes.positions, positions)
    assert np.isnan(nodes.pixels).all()
    np.testing.assert_array_equal(nodes.z, [3.0, 0.0])


def test_nodes_are_indexed_as_numpy_does(random):
    nodes = random_nodes(random, 7)
    for key in (slice(1, 5), np.array([3, 1]), nodes.labels > 1, -1):
        np.testing.assert_array_equal(nodes[key].labels, np.atleast_1d(nodes.labels[key]))


def test_appearances_keep_their_direction(random):
    vectors = random.normal(size=(4, 16))
    vectors[2] = 0.0
    nodes = topobag.Nodes([0] * 4, appearances=vectors, appearance_kind="reid")
    kept = nodes.appearances.astype(float)
    assert kept.shape == (4, 16) and not kept[2].any()
    for i in (0, 1, 3):
        cosine = kept[i] @ vectors[i] / np.linalg.norm(kept[i]) / np.linalg.norm(vectors[i])
        assert cosine > 0.999
    kind = topobag.TopologyGraph(nodes).appearance_kind
    assert kind == topobag.AppearanceKind("reid", 16) != topobag.AppearanceKind("other", 16)


def test_lengths_and_D_are_numpys(random):
    graph = random_graph(random, 9)
    a, b = graph.edges.T
    lengths = np.linalg.norm(graph.positions[a] - graph.positions[b], axis=1)
    np.testing.assert_allclose(graph.lengths, lengths, rtol=1e-15)
    D = np.eye(9)
    D[a, b] = D[b, a] = graph.lengths
    np.testing.assert_array_equal(graph.D, D)


def test_W_is_D_times_O(random):
    graph = random_graph(random, 9)
    O = np.column_stack([graph.pixels, graph.z, graph.labels])
    np.testing.assert_array_equal(graph.O, O)
    np.testing.assert_array_equal(np.asarray(graph), O)
    np.testing.assert_allclose(graph.W, graph.D @ O, rtol=1e-13)


def test_knn_edges_are_numpys(random):
    nodes = random_nodes(random, 12)
    apart = np.linalg.norm(nodes.positions[:, None] - nodes.positions[None], axis=2)
    np.fill_diagonal(apart, np.inf)
    nearest = np.argsort(apart, axis=1)[:, :3]
    expected = {tuple(sorted((i, int(j)))) for i in range(12) for j in nearest[i]}
    assert {tuple(e) for e in topobag.KnnEdges(3)(nodes).tolist()} == expected


def test_radius_and_complete_edges_are_numpys(random):
    nodes = random_nodes(random, 12)
    apart = np.linalg.norm(nodes.positions[:, None] - nodes.positions[None], axis=2)
    pairs = np.argwhere(np.triu(np.ones((12, 12)), 1))
    np.testing.assert_array_equal(topobag.CompleteEdges()(nodes), pairs)
    near = pairs[apart[pairs[:, 0], pairs[:, 1]] <= 1.5]
    np.testing.assert_array_equal(topobag.RadiusEdges(radius=1.5)(nodes), near)


def test_every_delaunay_edge_has_an_empty_circle(random):
    nodes = random_nodes(random, 15)
    edges = topobag.DelaunayEdges2()(nodes)
    points = nodes.pixels
    triangles = 0
    for i in range(15):  # every triangle of mutual neighbours with an empty circle is Delaunay's
        for j in range(i):
            for k in range(j):
                (ax, ay), (bx, by), (cx, cy) = points[[i, j, k]]
                d = 2 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by))
                squares = (points[[i, j, k]] ** 2).sum(axis=1)
                u = squares @ [by - cy, cy - ay, ay - by] / d
                v = squares @ [cx - bx, ax - cx, bx - ax] / d
                inside = np.hypot(points[:, 0] - u, points[:, 1] - v) < np.hypot(ax - u, ay - v) * (1 - 1e-9)
                if not inside.any():
                    triangles += 1
                    for pair in ((i, j), (i, k), (j, k)):
                        assert sorted(pair) in edges.tolist()
    assert triangles > 15


def test_edge_builders_lie_inside_each_other(random):
    nodes = random_nodes(random, 20)
    builders = [
        topobag.MinimumSpanningTreeEdges(),
        topobag.RelativeNeighborhoodEdges(),
        topobag.GabrielEdges(),
        topobag.DelaunayEdges2(),
        topobag.CompleteEdges(),
    ]
    sets = [{tuple(e) for e in builder(nodes).tolist()} for builder in builders]
    assert len(sets[0]) == 19
    for inner, outer in zip(sets, sets[1:]):
        assert inner <= outer


def test_edges_come_as_builder_array_or_callable(random):
    nodes = random_nodes(random, 6)
    pairs = topobag.DelaunayEdges3()(nodes)
    graphs = [
        topobag.TopologyGraph(nodes, topobag.DelaunayEdges3()),
        topobag.TopologyGraph(nodes, pairs[::-1, ::-1]),
        topobag.TopologyGraph(nodes, lambda given: topobag.DelaunayEdges3()(given)),
    ]
    for graph in graphs:
        np.testing.assert_array_equal(graph.edges, pairs)
    assert len(topobag.TopologyGraph(nodes).edges) == 0


def test_a_graph_pickles_as_a_map_keeps_it(random):
    graph = random_graph(random)
    copy = pickle.loads(pickle.dumps(graph))
    np.testing.assert_array_equal(copy.labels, graph.labels)
    np.testing.assert_array_equal(copy.edges, graph.edges)
    np.testing.assert_allclose(copy.positions, graph.positions, atol=2.001e-3)
    assert copy.encode() == graph.encode() == topobag.TopologyGraph.decode(graph.encode()).encode()


def test_project_and_back_project_are_numpys(random):
    points = random.uniform([-2, -2, 0.5], [2, 2, 6], (50, 3))
    pixels = points[:, :2] / points[:, 2:] * [517.3, 516.5] + [318.6, 255.3]
    np.testing.assert_allclose(FR1.project(points), pixels, rtol=1e-13)
    np.testing.assert_allclose(FR1.back_project(pixels, points[:, 2]), points, rtol=1e-12, atol=1e-12)
    assert np.isnan(FR1.project([[0.0, 0.0, -1.0]])).all()


def test_views_and_gravity_stay_with_the_graph(random):
    view = topobag.View(FR1, [[0, 0, 10, 10], [5, 5, 20, 20]], [1.0, 2.0])
    graph = topobag.TopologyGraph(random_nodes(random, 4), None, [view], topobag.Gravity([0, 2, 0]))
    np.testing.assert_array_equal(graph.views[0].occluders, [[0, 0, 10, 10], [5, 5, 20, 20]])
    np.testing.assert_array_equal(graph.views[0].occluder_z, [1.0, 2.0])
    np.testing.assert_array_equal(graph.views[0].T_graph_camera, np.eye(4))
    np.testing.assert_array_equal(graph.gravity.down, [0, 1, 0])
    assert pickle.loads(pickle.dumps(graph)).views[0].camera.width == 640


@pytest.mark.parametrize("count", [0, 1, 2])
def test_small_graphs_are_defined(random, count):
    graph = random_graph(random, count, topobag.DelaunayEdges2())
    assert len(graph) == count and graph.W.shape == (count, 4) and not graph.is_matchable
    assert len(graph.edges) == (1 if count == 2 else 0)
