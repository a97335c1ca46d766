# SPDX-License-Identifier: MIT
"""What objects look like: descriptors of an image, the odds of their likeness, learnt ones."""

import numpy as np
import pytest
import topobag
from conftest import pose, random_nodes
from test_threads import run_all

BOXES = [[4, 4, 60, 44], [70, 10, 120, 90], [500, 500, 600, 600]]


@pytest.fixture
def image(random):
    """Two objects of one colour each before a grey wall."""
    pixels = np.full((100, 160, 3), 120, np.uint8)
    pixels[4:44, 4:60] = (200, 40, 30)
    pixels[10:90, 70:120] = (30, 90, 220)
    return (pixels + random.integers(0, 12, pixels.shape)).astype(np.uint8)


def cosine(a, b):
    a, b = a.astype(float), b.astype(float)
    return a @ b / np.sqrt((a @ a) * (b @ b))


def test_one_color_looks_alike_and_two_do_not(image):
    rows = topobag.color_descriptors(image, BOXES)
    assert rows.shape == (3, topobag.AppearanceKind.color().length) and rows.dtype == np.int8
    assert rows[:2].any(axis=1).all() and not rows[2].any()  # the third lies outside
    again = topobag.color_descriptors(image, [[10, 10, 50, 40]])
    assert cosine(rows[0], again[0]) > 0.98 > cosine(rows[0], rows[1])


def test_neither_order_nor_strides_nor_a_fourth_byte_change_it(image):
    rows = topobag.color_descriptors(image, BOXES)
    for same, options in [
        (image[:, :, ::-1], {"bgr": True}),
        (np.ascontiguousarray(image[:, :, ::-1]), {"bgr": True}),
        (np.dstack([image, np.zeros(image.shape[:2], np.uint8)]), {}),
        (np.repeat(np.repeat(image, 2, 0), 2, 1)[::2, ::2], {}),
    ]:
        assert (topobag.color_descriptors(same, BOXES, **options) == rows).all()


def test_the_background_is_told_by_depth(image):
    depth = np.full(image.shape[:2], 3.0, np.float32)
    depth[4:44, 4:60] = 1.0
    wide = [[4, 4, 100, 44]]  # half of it is wall
    with_depth = topobag.color_descriptors(image, wide, depth, [1.0])
    alone = topobag.color_descriptors(image, [[4, 4, 60, 44]])
    assert cosine(with_depth[0], alone[0]) > cosine(topobag.color_descriptors(image, wide)[0], alone[0])


def test_what_is_no_image_is_refused(image):
    for wrong in (image[:, :, 0], image.astype(np.float32), image[:, :, :2], "an image"):
        with pytest.raises(ValueError, match="uint8"):
            topobag.color_descriptors(wrong, BOXES)
    with pytest.raises(ValueError, match="empty"):
        topobag.color_descriptors(image[:0], BOXES)
    with pytest.raises(ValueError, match="only by z"):
        topobag.color_descriptors(image, BOXES, np.ones((100, 160), np.float32))


def test_they_are_the_appearances_of_nodes(image, random):
    rows = topobag.color_descriptors(image, BOXES)
    nodes = topobag.Nodes([56, 62, 62], np.eye(3), appearances=rows, appearance_kind=topobag.AppearanceKind.color())
    graph = topobag.TopologyGraph(nodes, topobag.KnnEdges())
    assert graph.appearance_kind == topobag.AppearanceKind.color()
    assert cosine(graph.nodes.appearances[0], rows[0]) > 0.999
    assert not graph.nodes.appearances[2].any()


def test_the_table_is_read_between_its_points():
    model = topobag.AppearanceModel()
    low, high = model.table[3:5]
    middle = (low.similarity + high.similarity) / 2
    assert model.log10_odds(middle) == pytest.approx((low.log10_odds + high.log10_odds) / 2)
    assert model.log10_odds(-1) == model.table[0].log10_odds and model.log10_odds(1) == model.table[-1].log10_odds
    model.table = [topobag.AppearanceOdds(0.5, 1), topobag.AppearanceOdds(0.4, 2)]
    with pytest.raises(ValueError, match="do not rise"):
        model.validate()


def test_odds_are_learnt_from_matches_and_other_places(random):
    """Objects keep their looks, with some noise, and those of other places have others."""
    counts = topobag.AppearanceCounts(topobag.AppearanceKind("own", 16))
    options = topobag.MatchOptions()

    def room():
        nodes = random_nodes(random, 12)
        return nodes, random.normal(size=(12, 16))

    def graph(nodes, looks):
        seen = topobag.Nodes(
            nodes.labels, nodes.positions, pixels=nodes.pixels, sizes=nodes.sizes,
            appearances=looks + 0.3 * random.normal(size=looks.shape),
        )  # fmt: skip
        return topobag.TopologyGraph(seen, topobag.KnnEdges())

    with pytest.raises(ValueError, match="pairs of one object"):
        counts.model()
    for _ in range(20):
        here, there = room(), room()
        candidate, query = graph(*here), graph(*here)
        pose = topobag.match_graphs(candidate, query, options).poses[0]
        topobag.learn_appearance(counts, candidate, query, pose)
        topobag.learn_other_appearance(counts, query, graph(*there))
    assert counts.same >= 200 and counts.other >= 100
    model = counts.model()
    assert model.log10_odds(0.95) > 0.5 > -0.3 > model.log10_odds(0.0)
    options.chance.appearance = model
    assert topobag.match_graphs(candidate, query, options).poses[0].support > topobag.match_graphs(
        candidate, query, topobag.MatchOptions(chance=topobag.ChanceModel(appearance=topobag.AppearanceModel()))
    ).poses[0].support


@pytest.fixture
def map_with_looks():
    """Key frames of one room, whose objects have looks of their own, with the truth as poses."""
    random = np.random.default_rng(11)
    labels, positions = random.integers(0, 4, 14), random.uniform([-2, -1, 2], [2, 1, 5], (14, 3))
    sizes, looks = random.uniform(0.1, 0.6, (14, 2)), random.normal(size=(14, 16))
    relocalizer = topobag.Relocalizer()
    for i in range(12):
        T = pose(random.normal(scale=0.1, size=3), random.normal(scale=0.2, size=3))  # world from camera
        inverse = np.linalg.inv(T)
        nodes = topobag.Nodes(
            labels, positions @ inverse[:3, :3].T + inverse[:3, 3], sizes=sizes,
            appearances=looks + 0.3 * random.normal(size=looks.shape), appearance_kind=topobag.AppearanceKind("own", 16),
        )  # fmt: skip
        relocalizer.map.add(i, topobag.TopologyGraph(nodes), stamp=100.0 * i, T_world_camera=T)
    return relocalizer


def test_odds_are_learnt_from_a_map_itself(map_with_looks):
    kind, calls = topobag.AppearanceKind("own", 16), []
    counts = topobag.AppearanceCounts(kind)
    topobag.learn_map_appearance(
        counts, map_with_looks, options=topobag.MapAppearanceOptions(on_query=lambda: calls.append(1))
    )
    pairs = 12 * 11 // 2  # each two key frames count once
    assert len(calls) == 12 and counts.kind == kind
    assert counts.same == 14 * pairs and counts.other > 0 and counts.other % pairs == 0
    model = counts.model(topobag.AppearancePrior(min_pairs=50))
    assert model.log10_odds(0.95) > 0.5 > -0.3 > model.log10_odds(0.0)
    options = topobag.CalibrateOptions(null_queries=12, appearance=model)
    calibration = topobag.calibrate(map_with_looks, options=options)
    assert calibration.queries >= 12
    other = topobag.AppearanceCounts()
    topobag.learn_map_appearance(other, map_with_looks)
    assert other.same == other.other == 0  # of another kind
    options.appearance = topobag.AppearanceModel()
    with pytest.raises(topobag.InvalidValue, match="another kind"):
        topobag.calibrate(map_with_looks, options=options)


def test_what_is_learnt_adds_up(map_with_looks, random):
    kind = topobag.AppearanceKind("own", 16)
    some, all_twice = topobag.AppearanceCounts(kind), topobag.AppearanceCounts(kind)
    topobag.learn_map_appearance(some, map_with_looks, [0, 1, 2, 99])
    assert 0 < some.same < 14 * 66
    works = [lambda: topobag.learn_map_appearance(all_twice, map_with_looks)] * 2
    run_all(*works)
    assert all_twice.same == 2 * 14 * 66
    nodes = map_with_looks.map[3].nodes
    elsewhere = topobag.TopologyGraph(
        topobag.Nodes(nodes.labels, nodes.positions, appearances=random.normal(size=(14, 16)), appearance_kind=kind)
    )
    before = some.other
    topobag.learn_elsewhere_appearance(some, map_with_looks, elsewhere)
    expected = topobag.AppearanceCounts(kind)
    for i in map_with_looks.map:
        topobag.learn_other_appearance(expected, map_with_looks.map[i], elsewhere)
    assert some.other - before == expected.other > 0


def test_why_is_one_line(sample, relocalizer):
    told = {topobag.why(relocalizer.localize(query.graph)) for query in sample[1]}
    assert any(line.startswith("recognised key frame ") for line in told)
    assert all("\n" not in line for line in told)
