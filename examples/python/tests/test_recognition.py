# SPDX-License-Identifier: MIT
"""Looking up, loops, reasons and calibration over the sample data."""

import pickle

import numpy as np
import pytest
import topobag


@pytest.fixture(scope="module")
def found(sample, relocalizer):
    return [relocalizer.localize(query.graph) for query in sample[1]]


def test_most_key_frames_of_the_sample_are_found(sample, relocalizer, found):
    accepted = [i for i, recognition in enumerate(found) if recognition]
    assert len(accepted) > 40
    for i in accepted:
        translation, rotation = topobag.pose_error(
            sample[1][i].T_world_camera, relocalizer.T_world_query(found[i])
        )
        assert translation < 0.3 and rotation < 15


def test_an_answer_tells_what_it_rests_on(found):
    recognition = next(r for r in found if r)
    report = recognition.accepted
    assert report.verdict == topobag.Verdict.accepted and report.margin >= 0
    assert report.margin == report.score - report.threshold
    assert sum(report.matched.values()) == len(report.pose.inliers) >= 3
    assert recognition.candidates[0].id == report.id and "key frame" in repr(recognition)
    assert isinstance(np.asarray(report.pose), np.ndarray) and np.asarray(report.pose).shape == (4, 4)


def test_the_indexed_bag_finds_the_same(sample, relocalizer):
    indexed, same = topobag.IndexedBag(), topobag.BagOfTopologyGraphs()
    for i in relocalizer.map:
        indexed.add(i, relocalizer.map[i], T_world_camera=relocalizer.map.info(i).T_world_camera)
        same.add(i, indexed[i], T_world_camera=indexed.info(i).T_world_camera)
    for query in sample[1][::6]:
        a, b = (topobag.Relocalizer(relocalizer.options, m).localize(query.graph) for m in (indexed, same))
        assert [(c.id, c.verdict, c.score) for c in a.candidates] == [
            (c.id, c.verdict, c.score) for c in b.candidates
        ]


@pytest.mark.parametrize("kind", ["BagOfTopologyGraphs", "IndexedBag"])
def test_without_poses_gaps_between_ids_change_nothing(sample, kind):
    options = topobag.recognition_options(topobag.ClassCatalog.coco80())
    answers = []
    for step in (1, 1000):
        bag = getattr(topobag, kind)()
        for i, keyframe in enumerate(sample[0]):
            bag.add(step * i, keyframe.graph, stamp=keyframe.stamp)
        found = [topobag.Relocalizer(options, bag).localize(query.graph) for query in sample[1][::4]]
        answers.append([[(c.id // step, c.verdict, c.score) for c in r.candidates] for r in found])
    assert answers[0] == answers[1]
    assert any(verdict == topobag.Verdict.accepted for found in answers[0] for _, verdict, _ in found)


def test_reasons_are_given(sample, relocalizer, found):
    i = next(i for i, recognition in enumerate(found) if recognition)
    reasons = topobag.explain(found[i], relocalizer.map, sample[1][i].graph, options=relocalizer.options)
    best = reasons.candidates[0]
    assert best.verdict == topobag.Verdict.accepted and all(stage.passed for stage in best.stages)
    assert "passed  score" in str(best) and str(reasons).count("key frame") >= 1
    assert {m.candidate_class for m in best.matched} <= {
        topobag.ClassCatalog.coco80().name(k) for k in range(80)
    }


def test_what_changed_is_told(sample, relocalizer, found):
    i = next(i for i, recognition in enumerate(found) if recognition)
    report = found[i].accepted
    changes = topobag.what_changed(relocalizer.map[report.id], sample[1][i].graph, report.pose)
    assert all(change.kind in topobag.ChangeKind.__members__.values() for change in changes)
    nodes = {c.candidate for c in changes if c.kind == topobag.ChangeKind.gone}
    assert nodes <= {m.node for m in report.pose.missing if m.of_candidate}


def test_options_of_one_query_alone(sample, relocalizer):
    strict = topobag.recognition_options(topobag.ClassCatalog.coco80())
    strict.decision.min_score = 1e9
    query = sample[1][5].graph
    assert not relocalizer.localize(query, strict)
    assert relocalizer.localize(query, strict).candidates[0].verdict == topobag.Verdict.insignificant


def test_loops_are_found_on_the_way(sample):
    options = topobag.recognition_options(topobag.ClassCatalog.coco80())
    loops = topobag.LoopDetector(topobag.LoopOptions(min_gap=10.0, recognition=options))
    closed = []
    for i, keyframe in enumerate(sample[0]):
        recognition = loops.detect_and_add(i, keyframe.stamp, keyframe.graph, T_world_camera=keyframe.T_world_camera)
        if recognition:
            closed.append((i, recognition.accepted.id))
    assert len(loops.bag) == len(sample[0]) and closed
    for i, j in closed:
        assert sample[0][i].stamp - sample[0][j].stamp >= 10.0


def test_a_bag_is_referred_to(sample):
    bag = topobag.BagOfTopologyGraphs()
    relocalizer = topobag.Relocalizer(map=bag)
    assert relocalizer.map is bag and relocalizer.localize(sample[1][5].graph).candidates == []
    bag.add(3, sample[0][5].graph)
    assert [c.id for c in relocalizer.localize(sample[1][5].graph).candidates] == [3]


def test_a_calibration_learns_and_keeps(sample, relocalizer):
    few = topobag.CalibrateOptions(null_queries=20)
    calls = []
    few.on_query = lambda: calls.append(1)
    calibration = topobag.calibrate(relocalizer, list(relocalizer.map)[:10], options=few)
    assert len(calls) == 30 and calibration.queries == 20
    assert calibration.source == topobag.CalibrationSource.null_model
    assert calibration.conditions == {}
    calibration.conditions = {"window": "3 s"}
    again = pickle.loads(pickle.dumps(calibration))
    assert again.to_text() == calibration.to_text() and again.conditions == {"window": "3 s"}
    with pytest.raises(topobag.InvalidValue, match="must be a word"):
        calibration.conditions = {"two words": "3 s"}
    assert calibration.conditions == {"window": "3 s"}
    options = topobag.recognition_options(topobag.ClassCatalog.coco80())
    options.decision.calibration = again
    options.decision.false_accept_rate = 0.05
    report = relocalizer.localize(sample[1][10].graph, options).candidates[0]
    assert report.threshold == calibration.threshold(0.05).score
    with pytest.raises(topobag.FormatError):
        topobag.Calibration.from_text("what")


def test_layouts_are_learnt_kept_and_used():
    catalog = topobag.ClassCatalog.coco80()
    usual = topobag.usual_layouts(catalog)
    again = pickle.loads(pickle.dumps(usual))
    assert again.to_text() == usual.to_text()
    place = topobag.TopologyGraph(topobag.Nodes([64, 66], np.array([[0, 0, 0], [0.3, 0, 0]], float)), topobag.KnnEdges())
    learnt = topobag.learn_layouts([place] * 20)
    assert learnt.density(66, 64, 0.3, 2.0, False) > 10 * learnt.density(64, 66, 1.5, 2.0, False)
    with pytest.raises(ValueError, match="one place or more"):
        topobag.learn_layouts([])
    options = topobag.recognition_options(catalog)
    assert options.matching.chance.layouts is None
    options.matching.chance.layouts = usual
    assert options.matching.chance.layouts.to_text() == usual.to_text()


def test_what_sizes_say_is_kept_as_text():
    prior = topobag.recognition_options(topobag.ClassCatalog.coco80()).matching.chance.sizes
    again = topobag.SizePrior.from_text(prior.to_text())
    assert again.to_text() == prior.to_text() and again.classes.keys() == prior.classes.keys() != set()
    with pytest.raises(topobag.FormatError):
        topobag.SizePrior.from_text("what")


def test_matches_that_agree_add_up(sample, relocalizer, found):
    policy = topobag.TemporalConsistency(topobag.TemporalOptions(min_matches=2))
    believed = previous = None
    for query, recognition in zip(sample[1], found):
        motion = None if previous is None else np.linalg.inv(previous.T_world_camera) @ query.T_world_camera
        where = relocalizer.map.info(recognition.accepted.id).T_world_camera if recognition else None
        believed = policy.add(recognition, motion, where) or believed
        previous = query
    assert believed and policy.matches >= 0


def test_the_readme_s_five_lines(sample):
    nodes = sample[0][5].graph.nodes
    relocalizer = topobag.Relocalizer(topobag.recognition_options(topobag.ClassCatalog.coco80()))
    relocalizer.map.add(7, topobag.TopologyGraph(nodes, topobag.DelaunayEdges2()))
    found = relocalizer.localize(topobag.TopologyGraph(nodes, topobag.DelaunayEdges2()))
    np.testing.assert_allclose(found.candidates[0].pose.T_candidate_query, np.eye(4), atol=1e-6)
