# SPDX-License-Identifier: MIT
"""Similarities and matching."""

import numpy as np
import pytest
import topobag
from conftest import pose, random_graph, random_nodes

SIMILARITIES = topobag.all_similarities([])


@pytest.mark.parametrize("name", SIMILARITIES)
def test_a_matrix_holds_the_scores_of_its_pairs(name, random):
    similarity = SIMILARITIES[name]
    queries = [random_graph(random, n) for n in (0, 3, 8)]
    entries = [random_graph(random, n) for n in (5, 8)]
    scores = similarity.matrix(queries, entries)
    assert scores.shape == (3, 2) and np.isfinite(scores).all()
    for i, query in enumerate(queries):
        for k, entry in enumerate(entries):
            assert scores[i, k] == similarity(entry, query)
    assert similarity(entries[1], entries[1]) == pytest.approx(1.0)


def test_padded_cosine_is_numpys(random):
    p, q = random_graph(random, 6), random_graph(random, 9)
    P, Q = (g.W / np.linalg.norm(g.W, axis=1, keepdims=True) for g in (p, q))
    assert topobag.PaddedCosine()(p, q) == pytest.approx((P * Q[:6]).sum() / 9, rel=1e-12)


def test_class_histograms_are_numpys(random):
    p, q = random_graph(random, 6), random_graph(random, 9)
    P, Q = (np.bincount(g.labels, minlength=5) for g in (p, q))
    assert topobag.ClassHistogram()(p, q) == pytest.approx(np.minimum(P, Q).sum() / np.maximum(P, Q).sum())
    cosine = topobag.ClassHistogram(topobag.HistogramMeasure.cosine)
    assert cosine(p, q) == pytest.approx(P @ Q / np.linalg.norm(P) / np.linalg.norm(Q))


def test_class_weights_are_the_smoothed_idf(random):
    background = [random_graph(random, 3) for _ in range(10)]
    weights = topobag.ClassWeights.idf(background)
    for label in range(6):
        holders = sum(label in graph.labels for graph in background)
        assert weights(label) == pytest.approx(1 + np.log(11 / (1 + holders)))


def test_a_rigid_fit_finds_the_motion(random):
    T = pose([0.3, -0.2, 0.5], [1.0, 2.0, -0.5])
    source = random.normal(size=(10, 3))
    fit = topobag.fit_rigid(source @ T[:3, :3].T + T[:3, 3], source)
    np.testing.assert_allclose(fit.T_target_source, T, atol=1e-12)
    assert fit.rms < 1e-12 and topobag.fit_rigid(np.zeros((0, 3)), np.zeros((0, 3))) is None


def test_a_rigid_fit_is_numpys(random):
    source, target = random.normal(size=(2, 12, 3))
    weights = random.uniform(0.5, 2, 12)
    share = weights[:, None] / weights.sum()
    a, b = source - (share * source).sum(0), target - (share * target).sum(0)
    U, _, Vt = np.linalg.svd((share * b).T @ a)
    R = U @ np.diag([1, 1, np.linalg.det(U) * np.linalg.det(Vt)]) @ Vt
    np.testing.assert_allclose(topobag.fit_rigid(target, source, weights).T_target_source[:3, :3], R, atol=1e-9)


def test_a_match_finds_the_camera_again(random):
    there = random_nodes(random, 12)
    T = pose([0.05, 0.2, 0.0], [0.4, 0.0, -0.3])  # candidate from query
    inverse = np.linalg.inv(T)
    here = topobag.Nodes(there.labels, there.positions @ inverse[:3, :3].T + inverse[:3, 3], sizes=there.sizes)
    match = topobag.match_graphs(topobag.TopologyGraph(there), topobag.TopologyGraph(here))
    best = match.poses[0]
    np.testing.assert_allclose(np.asarray(best), T, atol=1e-6)
    assert match.complete and not best.degenerate and best.covariance.shape == (6, 6)
    np.testing.assert_array_equal(best.inliers, np.column_stack([np.arange(12)] * 2))
    assert best.score == best.support + best.viewpoint_odds


def test_two_objects_give_no_pose(random):
    graph = random_graph(random, 2)
    assert topobag.match_graphs(graph, graph).poses == []


def test_options_are_told_apart():
    options = topobag.MatchOptions(max_steps=10)
    options.chance.fill = 2.0
    assert options.max_steps == 10 and options.chance.fill == 2.0
    assert topobag.MatchOptions().chance.fill == 1.5
    with pytest.raises(TypeError, match="MatchOptions has no max_step; it has consistency"):
        topobag.MatchOptions(max_step=10)
    with pytest.raises(TypeError, match="takes 1 arguments: k"):
        topobag.KnnEdges(1, 2)
    assert repr(topobag.KnnEdges(3)) == "KnnEdges(k=3)"


def test_a_local_graph_fuses_what_a_window_shows(random):
    nodes = random_nodes(random, 6)
    local = topobag.LocalGraph()
    for stamp in (0.0, 0.5, 1.0):
        local.add(stamp, nodes, np.eye(4))
    assert len(local) == 3 and len(local.graph()) == 6
    np.testing.assert_allclose(local.graph().positions, nodes.positions, atol=1e-9)
    ids, kept = local.objects()
    assert len(ids) == len(kept) == 6
    assert (np.trace(kept.covariances, axis1=1, axis2=2) > 0).all()
    with pytest.raises(topobag.InvalidValue, match="must not go back"):
        local.add(0.5, nodes)


def test_a_sighting_notes_what_hides_things():
    camera = topobag.PinholeCamera(500, 500, 320, 240, 640, 480)
    seen = topobag.sight_keyframe(1.0, [[100, 100, 160, 160], [300, 100, 340, 200]], [56, 0], None, [2.0, 1.0], camera)
    assert len(seen.nodes) == 1 and len(seen.view.occluders) == 2


def test_no_graph_is_none(random):
    with pytest.raises(topobag.InvalidValue, match="graph 1 is None"):
        topobag.ClassHistogram().matrix([random_graph(random), None], [])
    with pytest.raises(topobag.InvalidValue, match="graph 0 is None"):
        topobag.ClassWeights.idf([None])


@pytest.mark.parametrize("factor", [0.7, 1.6])
def test_a_graph_in_another_unit_is_found_up_to_scale(random, factor):
    graph = random_graph(random, 10)
    other = topobag.scaled(graph, factor)
    assert np.allclose(other.nodes.positions, factor * graph.nodes.positions)
    options = topobag.MatchOptions(scale=topobag.ScaleRange())
    found = topobag.match_graphs(graph, other, options).poses[0]
    assert found.scale == pytest.approx(1.0 / factor, abs=3.0 * found.scale_deviation)
    assert len(found.inliers) == 10
    assert found.scale_covariance.shape == (6,) and np.any(found.scale_covariance)
    with pytest.raises(topobag.InvalidValue, match="scaled by a positive number"):
        topobag.scaled(graph, 0.0)
