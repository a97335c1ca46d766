# SPDX-License-Identifier: MIT
"""Bags, and maps in files."""

import pickle

import numpy as np
import pytest
import topobag
from conftest import pose, random_graph


def filled(bag, random, count=20):
    for i in range(count):
        bag.add(10 + i, random_graph(random), stamp=float(i), session=i % 2, T_world_camera=pose([0, 0, 0], [i, 0, 0]))
    return bag


@pytest.fixture(params=["memory", "indexed", "sqlite"])
def bag(request, tmp_path):
    if request.param == "sqlite":
        return topobag.SqliteBag(str(tmp_path / "map.db"))
    return {"memory": topobag.BagOfTopologyGraphs, "indexed": topobag.IndexedBag}[request.param]()


def test_a_bag_is_a_container(bag, random):
    filled(bag, random, 5)
    assert len(bag) == 5 and list(bag) == [10, 11, 12, 13, 14] and 12 in bag and 99 not in bag
    assert len(bag[12]) == 8 and bag.find(99) is None and bag.info(99) is None
    assert bag.info(13).stamp == 3.0 and bag.info(13).session == 1
    assert bag.erase(12) and not bag.erase(12) and len(bag) == 4
    bag.update(13, random_graph(random, 3), label="kitchen")
    assert len(bag[13]) == 3 and bag.info(13).label == "kitchen" and bag.info(13).stamp is None
    assert "4 key frames" in repr(bag)
    assert (bag.after(10), bag.after(11), bag.after(14)) == (11, 13, None)
    assert (bag.before(13), bag.before(99), bag.before(10)) == (11, 14, None)


def test_a_query_is_the_similarity_sorted(random):
    bag = filled(topobag.BagOfTopologyGraphs(), random)
    query = random_graph(random)
    similarity = topobag.ClassPairDistanceHistogram()
    scores = sorted(((-similarity(bag[i], query), i) for i in bag))[:7]
    found = bag.query(query, topobag.QueryOptions(max_results=7))
    assert [(c.id, c.similarity) for c in found] == [(i, -s) for s, i in scores]


def test_all_bags_answer_alike(random, tmp_path):
    indexed = filled(topobag.IndexedBag(), random)
    others = [topobag.BagOfTopologyGraphs(), topobag.SqliteBag(str(tmp_path / "m.db"))]
    for other in others:
        for i in indexed:
            info = indexed.info(i)
            other.add(i, indexed[i], stamp=info.stamp, session=info.session, T_world_camera=info.T_world_camera)
    for _ in range(5):
        query = random_graph(random)
        answers = indexed.query(query)
        assert all(other.query(query) == answers for other in others)
    region = topobag.MapRegion([4.0, 0, 0], 2.5)
    assert all(sorted(b.within(region)) == [12, 13, 14, 15, 16] for b in (indexed, *others))


def test_who_is_asked(bag, random):
    filled(bag, random)
    query = random_graph(random)

    def asked(**options):
        return {c.id - 10 for c in bag.query(query, topobag.QueryOptions(max_results=99, **options))}

    assert asked() == set(range(20))
    assert asked(among=topobag.EntryFilter(sessions=[1])) == set(range(1, 20, 2))
    assert asked(among=topobag.EntryFilter(min_stamp=15.0)) == set(range(15, 20))
    assert asked(among=topobag.EntryFilter(region=topobag.MapRegion([0, 0, 0], 3.5))) == set(range(4))
    assert asked(exclude=topobag.ExcludedNeighbors(id=15, min_id_gap=3)) == set(range(20)) - set(range(3, 8))
    assert asked(filter=lambda i, info: info.stamp > 17) == {18, 19}


def test_what_a_filter_raises_comes_out(bag, random):
    filled(bag, random, 3)

    def broken(i, info):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        bag.query(random_graph(random), topobag.QueryOptions(filter=broken))
    assert len(bag.query(random_graph(random))) == 3


def test_a_filter_may_not_change_the_bag(random):
    bag = filled(topobag.BagOfTopologyGraphs(), random, 3)
    with pytest.raises(topobag.Error, match="may not change a bag"):
        bag.query(random_graph(random), topobag.QueryOptions(filter=lambda i, info: bag.erase(i)))
    assert len(bag) == 3 and bag.erase(10)


def test_ones_own_similarity_in_a_bag(random):
    bag = filled(topobag.BagOfTopologyGraphs(lambda p, q: float(abs(len(p) - len(q)) < 3)), random, 4)
    bag.add(1, random_graph(random, 3))
    found = bag.query(random_graph(random, 4))
    assert [c.id for c in found][0] == 1 and [c.similarity for c in found] == [1.0, 0.0, 0.0, 0.0, 0.0]
    other = filled(topobag.BagOfTopologyGraphs(topobag.ClassTriangles()), np.random.default_rng(1), 4)
    query = random_graph(random)
    assert other.query(query)[0].similarity == max(topobag.ClassTriangles()(query, other[i]) for i in other)


def test_a_snapshot_comes_back(bag, random, tmp_path):
    path = str(tmp_path / "room.bag")
    catalog = topobag.ClassCatalog.coco80()
    filled(bag, random).save(path, catalog)
    for kind in (topobag.BagOfTopologyGraphs, topobag.IndexedBag):
        loaded = kind.load(path, catalog)
        assert list(loaded) == list(bag)
        np.testing.assert_array_equal(loaded.info(12).T_world_camera, bag.info(12).T_world_camera)
        assert loaded[12].encode() == bag[12].encode()
    with pytest.raises(topobag.FormatError):
        topobag.IndexedBag.load(path, topobag.ClassCatalog.paper())
    content = bytearray((tmp_path / "room.bag").read_bytes())
    content[len(content) // 2] ^= 1
    (tmp_path / "broken.bag").write_bytes(content)
    with pytest.raises(topobag.FormatError, match="broken.bag"):
        topobag.BagOfTopologyGraphs.load(str(tmp_path / "broken.bag"))


def test_a_bag_tells_the_kinds_of_its_descriptors(bag, random):
    assert bag.appearance_kind.length == 0 and bag.image_kind.length == 0
    kind, graph = topobag.AppearanceKind("own", 4), random_graph(random, 3)
    nodes = topobag.Nodes(graph.labels, graph.positions, appearances=np.eye(3, 4), appearance_kind=kind)
    image = topobag.ImageDescriptor([1.0, 2.0, 3.0], "mine")
    bag.add(1, topobag.TopologyGraph(nodes), image=image)
    assert bag.appearance_kind == kind and bag.image_kind == image.kind


@pytest.mark.parametrize("kind", ["BagOfTopologyGraphs", "IndexedBag"])
def test_bags_pickle(kind, random):
    bag = filled(getattr(topobag, kind)(), random)
    copy = pickle.loads(pickle.dumps(bag))
    assert list(copy) == list(bag) and copy[15].encode() == bag[15].encode()


def test_an_sqlite_map_stays(random, tmp_path):
    path = str(tmp_path / "flat.db")
    bag = topobag.SqliteBag(path)
    today = bag.begin_session("Monday")
    bag.add(1, random_graph(random), session=today)
    again = topobag.SqliteBag(path, read_only=True)
    assert [(s.id, s.name) for s in again.sessions()] == [(0, "Monday")] and list(again) == [1]
    with pytest.raises(topobag.Error, match="flat.db.*reading only"):
        again.add(2, random_graph(random))


def test_an_indexed_bag_merges_and_compacts(random):
    a, b = filled(topobag.IndexedBag(), random, 5), filled(topobag.IndexedBag(), random, 5)
    new_ids = a.merge(b, topobag.MergeOptions(session_offset=5))
    assert sorted(new_ids) == [10, 11, 12, 13, 14] and min(new_ids.values()) > 14 and len(a) == 10
    smaller = topobag.IndexedBag()
    smaller.merge(b, topobag.MergeOptions(scale=0.5))
    for id in b:
        assert np.allclose(smaller[id].nodes.positions, 0.5 * b[id].nodes.positions, atol=0.005, equal_nan=True)
    a.compact()
    result = a.search(random_graph(random), max_visited=1)
    assert result.entries == 10 and result.visited <= 10
    usage = a.memory_usage()
    assert usage.nodes == sum(len(a[id]) for id in a)
    assert usage.bytes_per_node() == usage.total() / usage.nodes > 0
