# SPDX-License-Identifier: MIT
"""Maps that move, that take in others, and that are laid over each other."""

import threading

import numpy as np
import pytest
import topobag
from conftest import pose, random_graph
from test_threads import run_all

KINDS = ["memory", "indexed", "sqlite"]


def empty(kind, folder, name="map"):
    if kind == "sqlite":
        return topobag.SqliteBag(str(folder / f"{name}.db"))
    return {"memory": topobag.BagOfTopologyGraphs, "indexed": topobag.IndexedBag}[kind]()


def somewhere(random):
    return pose(random.normal(size=3), random.uniform(-10, 10, 3))


def fill(bag, random, ids, posed=0.7):
    for i in ids:
        T = somewhere(random) if random.random() < posed else None
        bag.add(i, random_graph(random), stamp=float(i), session=int(i) % 2, label=f"room {i}", T_world_camera=T)
    return bag


def inside(bag, center, radius):
    """The key frames whose cameras stand in a ball, by NumPy."""
    poses = {i: bag.info(i).T_world_camera for i in bag}
    return [i for i, T in poses.items() if T is not None and np.linalg.norm(T[:3, 3] - center) <= radius]


@pytest.mark.parametrize("kind", KINDS)
def test_poses_move_and_nothing_else_does(kind, random, tmp_path):
    bag = fill(empty(kind, tmp_path), random, range(40))
    before = {i: (bag[i].encode(), bag.info(i)) for i in bag}
    query = random_graph(random)
    found = bag.query(query)
    moved = {i: somewhere(random) for i in np.arange(0, 40, 3)}  # NumPy's ids
    bag.set_poses(moved)
    for i in bag:
        graph, info = before[i]
        assert bag[i].encode() == graph and bag.info(i).label == info.label and bag.info(i).stamp == info.stamp
        expected = moved.get(i, info.T_world_camera)
        if expected is None:
            assert bag.info(i).T_world_camera is None
        else:
            np.testing.assert_allclose(bag.info(i).T_world_camera, expected, atol=1e-9)
    assert bag.query(query) == found
    for radius in (2.0, 6.0, 1e6):
        center = random.uniform(-10, 10, 3)
        assert bag.within(topobag.MapRegion(center, radius)) == inside(bag, center, radius)
    if kind == "sqlite":
        again = topobag.SqliteBag(bag.path, read_only=True)
        assert all((again.info(i).T_world_camera == bag.info(i).T_world_camera).all() for i in moved)
        with pytest.raises(topobag.Error, match="reading only"):
            again.set_poses(moved)


@pytest.mark.parametrize("kind", KINDS)
def test_poses_that_are_refused_change_nothing(kind, random, tmp_path):
    bag = fill(empty(kind, tmp_path), random, range(5), posed=1.0)
    before = {i: bag.info(i).T_world_camera for i in bag}
    good, shear = somewhere(random), np.eye(4)
    shear[0, 1] = 0.5
    for wrong, error, match in [
        ({0: good, 9: good}, topobag.InvalidId, "key frame 9 is not in the bag"),
        ({0: good, 1: shear}, topobag.InvalidValue, "key frame 1: the pose is no rigid motion"),
        ({0: good, 1: np.full((4, 4), np.nan)}, topobag.InvalidValue, "key frame 1: the pose"),
        ({0: good, 2: np.eye(3)}, topobag.InvalidValue, r"key frame 2: the pose has the shape \(3, 3\); give 4 x 4"),
        ({0: good, 2: None}, topobag.InvalidValue, "key frame 2: the pose"),
        ({0: good, -1: good}, topobag.InvalidValue, "an id of -1"),
        ([good], TypeError, "set_poses"),
    ]:
        with pytest.raises(error, match=match):
            bag.set_poses(wrong)
    assert all((bag.info(i).T_world_camera == before[i]).all() for i in bag)
    bag.set_poses({})
    bag.set_poses({3: np.eye(4).tolist(), 4: np.eye(4, dtype=np.float32).T})
    assert (bag.info(3).T_world_camera == np.eye(4)).all()


@pytest.mark.parametrize("kind", KINDS)
def test_readers_see_all_poses_of_before_or_all_of_afterwards(kind, tmp_path):
    bag = empty(kind, tmp_path)
    fill(bag, np.random.default_rng(3), range(30))
    here, there = ({i: pose([0, 0, 0], [x, 0, 0]) for i in range(30)} for x in (0.0, 1000.0))
    bag.set_poses(here)
    regions = [topobag.MapRegion([x, 0.0, 0.0], 1.0) for x in (0.0, 1000.0)]
    done = threading.Event()

    def move():
        try:
            for i in range(60):
                bag.set_poses(there if i % 2 == 0 else here)
        finally:
            done.set()

    def read():
        while not done.is_set():
            assert {len(bag.within(region)) for region in regions} <= {0, 30}

    run_all(move, read, read)
    assert [len(bag.within(region)) for region in regions] == [30, 0]


@pytest.mark.parametrize("other", KINDS)
@pytest.mark.parametrize("kind", KINDS)
def test_every_bag_takes_in_every_other(kind, other, random, tmp_path):
    ours = fill(empty(kind, tmp_path, "ours"), random, [1, 2, 5])
    theirs = fill(empty(other, tmp_path, "theirs"), random, [2, 3, 5, 9])
    T = somewhere(random)
    new_ids = ours.merge(theirs, topobag.MergeOptions(session_offset=7, T_world_other=T))
    assert new_ids == {2: 10, 3: 3, 5: 11, 9: 9} and list(ours) == [1, 2, 3, 5, 9, 10, 11]
    for old, new in new_ids.items():
        was, now = theirs.info(old), ours.info(new)
        assert now.session == was.session + 7 and now.label == was.label and now.stamp == was.stamp
        assert ours[new].encode() == theirs[old].encode()
        if was.T_world_camera is not None:
            np.testing.assert_allclose(now.T_world_camera, T @ was.T_world_camera, atol=1e-9)
    with pytest.raises(topobag.InvalidValue, match="scale"):
        ours.merge(theirs, topobag.MergeOptions(scale=0.0))
    assert len(ours) == 7 and len(theirs) == 4


def test_the_names_of_runs_come_along(random, tmp_path):
    ours, theirs = (topobag.SqliteBag(str(tmp_path / name)) for name in ("a.db", "b.db"))
    ours.begin_session("Monday")
    theirs.add(1, random_graph(random), session=theirs.begin_session("Tuesday"))
    ours.merge(theirs, topobag.MergeOptions(session_offset=1))
    assert [(s.id, s.name) for s in ours.sessions()] == [(0, "Monday"), (1, "Tuesday")]


@pytest.mark.parametrize("kind", KINDS)
def test_two_bags_that_take_each_other_in_do_not_wait_for_one_another(kind, random, tmp_path):
    a, b = (fill(empty(kind, tmp_path, name), random, range(start, start + 6)) for name, start in (("a", 0), ("b", 100)))
    run_all(lambda: a.merge(b), lambda: b.merge(a))
    assert {len(a), len(b)} in ({12, 18}, {12})
    assert len(a.merge(a)) * 2 == len(a)


@pytest.fixture(scope="module")
def two_worlds(sample):
    """The sample's two runs as maps, the second in a world of its own, and that world in the first."""
    T_a_b = pose([0.3, -0.8, 0.2], [4.0, -2.0, 1.0])
    maps = topobag.IndexedBag(), topobag.BagOfTopologyGraphs()
    for bag, keyframes, T in zip(maps, sample, (np.eye(4), np.linalg.inv(T_a_b))):
        for i, keyframe in enumerate(keyframes):
            if keyframe.graph.is_matchable:
                bag.add(i, keyframe.graph, stamp=keyframe.stamp, T_world_camera=T @ keyframe.T_world_camera)
    return (*maps, T_a_b)


def test_two_maps_are_laid_over_each_other(two_worlds):
    a, b, T_a_b = two_worlds
    calls = []
    options = topobag.AlignOptions(recognition=topobag.recognition_options(topobag.ClassCatalog.coco80()))
    options.max_keyframes, options.on_query = 25, lambda: calls.append(1)
    alignment = topobag.align_maps(a, b, options)
    assert alignment and alignment.verdict == topobag.AlignmentVerdict.aligned
    assert len(calls) == alignment.asked == 25 >= alignment.matched >= alignment.agreeing >= 3
    translation, rotation = topobag.pose_error(T_a_b, alignment.T_a_b)
    assert translation < 0.15 and rotation < 5
    assert alignment.covariance.shape == (6, 6) and np.linalg.eigvalsh(alignment.covariance).min() > 0
    assert alignment.scale == 1.0 and alignment.scale_covariance.shape == (6,)
    assert "one alignment fits" in repr(alignment) and topobag.why(alignment.verdict) == "one alignment fits"
    joined = topobag.IndexedBag()
    joined.merge(a)
    new_ids = joined.merge(b, alignment.merge_options(1))
    assert len(joined) == len(a) + len(b)
    for old, new in new_ids.items():
        np.testing.assert_allclose(
            joined.info(new).T_world_camera, alignment.T_a_b @ b.info(old).T_world_camera, atol=1e-9
        )
        assert joined.info(new).session == 1


def test_maps_that_have_nothing_in_common_are_not_joined(two_worlds, random):
    a, b, _ = two_worlds
    nothing = topobag.align_maps(a, topobag.BagOfTopologyGraphs())
    assert not nothing and nothing.verdict == topobag.AlignmentVerdict.no_poses
    assert nothing.T_a_b is None and nothing.covariance is None and "nothing to align" in repr(nothing)
    with pytest.raises(topobag.InvalidValue, match="has to hold: T_a_b"):
        nothing.merge_options()
    elsewhere = fill(topobag.IndexedBag(), random, range(5), posed=1.0)
    refused = topobag.align_maps(a, elsewhere)
    assert refused.verdict == topobag.AlignmentVerdict.too_few and refused.asked == 5
    with pytest.raises(TypeError):
        topobag.align_maps(a, None)


def test_a_map_lies_on_itself_and_errors_of_the_callback_come_out(two_worlds):
    a, _, _ = two_worlds
    options = topobag.AlignOptions(max_keyframes=6)
    np.testing.assert_allclose(topobag.align_maps(a, a, options).T_a_b, np.eye(4), atol=0.02)

    def broken():
        raise KeyError("mine")

    options.on_query = broken
    with pytest.raises(KeyError, match="mine"):
        topobag.align_maps(a, a, options)


def test_maps_are_laid_over_each_other_while_they_grow(two_worlds, random):
    a, b, _ = two_worlds
    ours, theirs = topobag.BagOfTopologyGraphs(), topobag.BagOfTopologyGraphs()
    ours.merge(a)
    theirs.merge(b)
    graph, options = random_graph(random), topobag.AlignOptions(max_keyframes=6)

    def grow(bag):
        for i in range(1000, 1100):
            bag.add(i, graph)

    run_all(
        lambda: topobag.align_maps(ours, theirs, options), lambda: topobag.align_maps(theirs, ours, options),
        lambda: grow(ours), lambda: grow(theirs),
    )  # fmt: skip
    assert len(ours) == len(a) + 100 and len(theirs) == len(b) + 100
