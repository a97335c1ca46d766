# SPDX-License-Identifier: MIT
"""What maps keep and check of their classes."""

import copy

import pytest
import topobag
from conftest import random_graph


def warehouse():
    """Four classes, of which two look alike and one has a size."""
    catalog = topobag.ClassCatalog()
    catalog.add(0, "forklift", topobag.Dynamics.high)
    catalog.add(1, "pallet")
    catalog.add(2, "loaded pallet")
    catalog.add(5, "crate", topobag.Dynamics.medium)
    alike = topobag.ClassGroups()
    alike.join(1, 2)
    return topobag.DescribedCatalog(catalog, alike, {1: [1.2, 0.15]})


def other_warehouses():
    """The warehouse with one thing said otherwise, and the sentence that tells it of the warehouse's map."""
    faster, alone, larger = (warehouse() for _ in range(3))
    faster.catalog.set_dynamics(1, topobag.Dynamics.medium)
    alone.lookalikes = topobag.ClassGroups()
    larger.sizes = {1: [1.2, 0.2]}
    for other in (faster, alone, larger):
        other.source = "hall.txt"
    return [
        (faster, "class 'pallet' is of low dynamics in the map and of medium in hall.txt"),
        (alone, "class 'pallet' looks like 'loaded pallet' in the map and like no other in hall.txt"),
        (larger, "class 'pallet' is typically 1.2 x 0.15 m in the map and typically 1.2 x 0.2 m in hall.txt"),
    ]


def filled(bag, random):
    for i in range(3):
        bag.add(i, random_graph(random))
    return bag


@pytest.fixture(params=["memory", "indexed", "own similarity", "sqlite"])
def bag(request, random, tmp_path):
    kinds = {
        "memory": topobag.BagOfTopologyGraphs,
        "indexed": topobag.IndexedBag,
        "own similarity": lambda: topobag.BagOfTopologyGraphs(lambda p, q: 1.0),
        "sqlite": lambda: topobag.SqliteBag(str(tmp_path / "source.db")),
    }
    return filled(kinds[request.param](), random)


def test_a_snapshot_keeps_all_that_is_said_of_its_classes(bag, tmp_path):
    path = str(tmp_path / "hall.bag")
    bag.save(path, warehouse())
    kept = topobag.saved_catalog(path)
    assert topobag.difference(kept, warehouse()) is None
    assert list(kept.catalog) == [0, 1, 2, 5] and kept.catalog.name(2) == "loaded pallet"
    assert kept.catalog.dynamics(5) == topobag.Dynamics.medium
    assert kept.sizes == {1: [1.2, 0.15]} and kept.lookalikes.members(1) == [1, 2]
    again = str(tmp_path / "again.bag")
    for kind in (topobag.BagOfTopologyGraphs, topobag.IndexedBag):
        for classes in (None, kept, warehouse(), warehouse().catalog):
            kind.load(path, classes).save(again, kept)
            assert (tmp_path / "again.bag").read_bytes() == (tmp_path / "hall.bag").read_bytes()


def test_a_snapshot_of_which_something_else_is_said_is_refused(bag, tmp_path):
    path = str(tmp_path / "hall.bag")
    bag.save(path, catalog=warehouse())
    for other, sentence in other_warehouses():
        assert topobag.difference(warehouse(), other) == sentence
        for kind in (topobag.BagOfTopologyGraphs, topobag.IndexedBag):
            with pytest.raises(topobag.FormatError) as refused:
                kind.load(path, other)
            assert str(refused.value) == f"{path}: {sentence}; open it with the classes that it was made with"
    with pytest.raises(topobag.FormatError, match="class numbers mean other names"):
        topobag.IndexedBag.load(path, topobag.ClassCatalog.coco80())


def test_a_map_on_disk_keeps_all_that_is_said_of_its_classes(random, tmp_path):
    path = str(tmp_path / "hall.db")
    filled(topobag.SqliteBag(path, catalog=warehouse()), random)
    kept = topobag.sqlite_catalog(path)
    assert topobag.difference(kept, warehouse()) is None and kept.sizes == {1: [1.2, 0.15]}
    for other, sentence in other_warehouses():
        for read_only in (False, True):
            with pytest.raises(topobag.FormatError) as refused:
                topobag.SqliteBag(path, read_only, other)
            assert str(refused.value) == f"{path}: {sentence}; open it with the classes that it was made with"
    for classes in (None, kept, warehouse().catalog):
        assert len(topobag.SqliteBag(path, catalog=classes)) == 3
    with pytest.raises(topobag.FormatError, match="class numbers mean other names"):
        topobag.SqliteBag(path, catalog=topobag.ClassCatalog.paper())


def test_what_was_not_said_of_classes_is_not_kept(bag, tmp_path):
    path, disk = str(tmp_path / "hall.bag"), str(tmp_path / "hall.db")
    bag.save(path)
    assert topobag.saved_catalog(path) is None
    bag.save(path, warehouse().catalog)
    topobag.SqliteBag(disk, catalog=warehouse().catalog)
    for kept in (topobag.saved_catalog(path), topobag.sqlite_catalog(disk)):
        assert kept.lookalikes is None and kept.sizes is None
        assert topobag.difference(kept, warehouse()) is None  # what is left unsaid is not compared
    topobag.SqliteBag(str(tmp_path / "nameless.db"))
    assert topobag.sqlite_catalog(str(tmp_path / "nameless.db")) is None


def test_a_size_that_could_not_be_read_again_is_not_written(bag, tmp_path):
    path = tmp_path / "hall.bag"
    for size in ([-1.0, 1.0], [1.0, float("nan")], [0.0, 1.0]):
        classes = warehouse()
        classes.sizes = {1: size}
        with pytest.raises(topobag.InvalidValue, match="class 'pallet' is said to be .* above 0"):
            bag.save(str(path), classes)
        assert not path.exists()


def test_a_described_catalog_is_a_value(tmp_path):
    classes = warehouse()
    twin = copy.deepcopy(classes)
    twin.catalog.set_dynamics(0, topobag.Dynamics.low)
    assert classes.catalog.dynamics(0) == topobag.Dynamics.high and classes.source == "yours"
    nothing = topobag.DescribedCatalog()
    assert len(nothing.catalog) == 0 and nothing.lookalikes is None and nothing.sizes is None
    with pytest.raises(TypeError):
        topobag.DescribedCatalog({1: "pallet"})
    with pytest.raises(topobag.Error, match="nowhere.bag cannot be opened"):
        topobag.saved_catalog(str(tmp_path / "nowhere.bag"))


def test_options_go_by_the_classes_that_look_alike():
    groups = topobag.recognition_options(warehouse()).matching.consistency.classes
    assert groups.members(1) == [1, 2]
    assert topobag.recognition_options(warehouse().catalog).matching.consistency.classes.members(1) == [1]
    coco = topobag.ClassCatalog.coco80()
    named = topobag.DescribedCatalog(coco)
    for classes in (coco, named):  # what is left unsaid is the default
        options = topobag.recognition_options(classes)
        assert options.matching.consistency.classes.compatible(coco["tv"], coco["laptop"])
    named.lookalikes = topobag.ClassGroups()
    options = topobag.recognition_options(named)
    assert not options.matching.consistency.classes.compatible(coco["tv"], coco["laptop"])
