# SPDX-License-Identifier: MIT
"""The evaluation kit against NumPy, and tables."""

import numpy as np
import pytest
import topobag
from conftest import SAMPLE, pose


def trajectory(random, count=30, start=100.0):
    poses = [pose(random.normal(size=3) * 0.3, random.uniform(0, 4, 3)) for _ in range(count)]
    return topobag.Trajectory(start + np.arange(count) * 0.5, poses)


def test_stamps_and_poses_come_back(random):
    given = trajectory(random)
    assert len(given) == 30 and given.poses.shape == (30, 4, 4)
    np.testing.assert_array_equal(given.at(given.stamps[3]), given.poses[3])
    assert given.at(1e6) is None
    with pytest.raises(topobag.InvalidValue, match="stamp 1 is not after"):
        topobag.Trajectory([1.0, 1.0], [np.eye(4)] * 2)
    with pytest.raises(topobag.InvalidValue, match="pose 1 of poses is no rigid motion"):
        topobag.Trajectory([1.0, 2.0], [np.eye(4), np.ones((4, 4))])


def test_a_trajectory_in_a_file(random, tmp_path):
    given = trajectory(random)
    path = str(tmp_path / "t.txt")
    given.write_tum(path)
    again = topobag.Trajectory.read(path)
    np.testing.assert_allclose(again.poses, given.poses, atol=1e-6)
    frames = topobag.Trajectory.read(str(SAMPLE / "fr1_xyz.frames.csv"))
    np.testing.assert_array_equal(frames.poses, topobag.read_node_table(str(SAMPLE / "fr1_xyz")).poses)


def test_absolute_errors_are_numpys(random):
    truth = trajectory(random)
    T = pose([0.2, 0.1, -0.3], [1, 2, 3])
    noise = random.normal(size=(30, 3)) * 0.05
    moved = T @ truth.poses
    moved[:, :3, 3] += noise
    estimate = topobag.Trajectory(truth.stamps, moved)
    plain, _ = topobag.trajectory_errors(truth, estimate, topobag.AlignmentModel.none)
    np.testing.assert_allclose(plain, np.linalg.norm(moved[:, :3, 3] - truth.poses[:, :3, 3], axis=1), rtol=1e-9)
    translations, _ = topobag.trajectory_errors(truth, estimate)
    fit = topobag.fit_rigid(truth.poses[:, :3, 3], moved[:, :3, 3]).T_target_source
    aligned = moved[:, :3, 3] @ fit[:3, :3].T + fit[:3, 3]
    np.testing.assert_allclose(translations, np.linalg.norm(aligned - truth.poses[:, :3, 3], axis=1), atol=1e-9)
    statistics = topobag.error_statistics(translations)
    assert statistics.rmse == pytest.approx(np.sqrt((translations**2).mean()))
    assert statistics.median == pytest.approx(np.median(translations)) and statistics.count == 30
    assert topobag.error_statistics([]) is None


def test_relative_errors_are_numpys(random):
    truth, estimate = trajectory(random), trajectory(random)
    translations, rotations = topobag.relative_errors(truth, estimate)
    a, b = (np.linalg.inv(t.poses[:-1]) @ t.poses[1:] for t in (truth, estimate))
    E = np.linalg.inv(a) @ b
    np.testing.assert_allclose(translations, np.linalg.norm(E[:, :3, 3], axis=1), rtol=1e-9)
    angles = np.degrees(np.arccos(np.clip((np.trace(E[:, :3, :3], axis1=1, axis2=2) - 1) / 2, -1, 1)))
    np.testing.assert_allclose(rotations, angles, atol=1e-5)


def test_lifelong_scores(random):
    truth = {1: trajectory(random), 2: trajectory(random, start=500.0)}
    scores = topobag.score_lifelong(truth, truth, topobag.LifelongRules(ate_threshold_m=0.1, aoe_threshold_deg=1))
    assert scores[1].cr == pytest.approx(1.0) and scores[1].ate_m.rmse < 1e-9 and scores[2].cs_r == 1.0


def labelled(random, queries=12, entries=15):
    positions = random.uniform(0, 3, (queries + entries, 3))
    poses = [pose([0, 0, 0], p) for p in positions]
    truth = topobag.PlaceTruth(
        "distance=1",
        topobag.Trajectory(np.arange(queries), poses[:queries]),
        topobag.Trajectory(np.arange(entries), poses[queries:]),
    )
    positive = np.linalg.norm(positions[:queries, None] - positions[None, queries:], axis=2) <= 1
    scores = random.uniform(0, 1, (queries, entries)) + 0.3 * positive
    return scores, positive, truth


def test_precision_and_recall_are_numpys(random):
    scores, positive, truth = labelled(random)
    assert truth.shape == (12, 15) and truth.protocol == "distance=1"
    order = np.argsort(-scores.ravel())
    hits = np.cumsum(positive.ravel()[order])
    precision, recall, thresholds = topobag.precision_recall_curve(topobag.label_scores(scores, truth))
    np.testing.assert_allclose(precision, hits / np.arange(1, hits.size + 1))
    np.testing.assert_allclose(recall, hits / hits[-1])
    np.testing.assert_array_equal(thresholds, scores.ravel()[order])
    metrics = topobag.retrieval_metrics(topobag.label_scores(scores, truth))
    expected = np.sum(np.diff(np.concatenate([[0], recall])) * precision)
    assert metrics.average_precision == pytest.approx(expected)
    f1 = 2 * precision * recall / np.maximum(precision + recall, 1e-300)
    assert metrics.f1_max == pytest.approx(f1.max())


def test_recall_at_k_is_numpys(random):
    scores, positive, truth = labelled(random)
    best = np.argsort(-scores, axis=1)
    for k in (1, 3, 10):
        hits = sum(positive[i, best[i, :k]].any() for i in range(12))
        recall = topobag.recall_at_k(topobag.label_scores(scores, truth), k)
        assert recall.hits == hits and recall.of_queries_with_positive == hits / positive.any(axis=1).sum()
    with pytest.raises(topobag.InvalidValue, match="this has to hold: k >= 1"):
        topobag.recall_at_k(topobag.label_scores(scores, truth), 0)


def test_scores_of_another_shape_are_told(random):
    scores, _, truth = labelled(random)
    with pytest.raises(topobag.InvalidValue, match="11 × 15"):
        topobag.label_scores(scores[1:], truth)
    scores[3, 4] = np.nan
    with pytest.raises(topobag.InvalidValue, match="query 3 and candidate 4 is not finite"):
        topobag.label_scores(scores, truth)
    with pytest.raises(topobag.InvalidValue):
        topobag.PlaceTruth("distance=-1", topobag.Trajectory([0.0], [np.eye(4)]))


def test_a_table_is_columns():
    table = topobag.read_node_table(str(SAMPLE / "fr1_xyz"))
    assert len(table) == 67 and len(table.names) == 67 and table.poses.shape == (67, 4, 4)
    assert len(table.labels) == len(table.frames) == len(table.boxes) == len(table.z) == 772
    rows = np.genfromtxt(SAMPLE / "fr1_xyz.nodes.csv", delimiter=",", names=True, usecols=(1, 3, 4, 6, 8))
    np.testing.assert_array_equal(table.labels, rows["class_id"])
    np.testing.assert_array_equal(table.scores, rows["conf"])
    np.testing.assert_allclose(table.boxes[:, [0, 2]].mean(axis=1), rows["u"])
    np.testing.assert_array_equal(table.z, rows["z"])
    with pytest.raises(topobag.Error, match="nowhere.frames.csv"):
        topobag.read_node_table("nowhere")
