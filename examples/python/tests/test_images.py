# SPDX-License-Identifier: MIT
"""Whole images' descriptors: kept with key frames, and asked for in queries."""

import copy
import pickle

import numpy as np
import pytest
import topobag
from conftest import random_graph


def described(random, length=32):
    return topobag.ImageDescriptor(random.normal(size=length), "network")


def test_a_descriptor_is_the_direction_of_a_vector(random):
    vector = random.normal(size=300)
    image = topobag.ImageDescriptor(vector, "network")
    assert image.known and image.kind == topobag.ImageKind("network", 300)
    assert image.bytes.dtype == np.int8 and image.bytes.shape == (300,)
    assert np.abs(image.bytes / 127 * np.abs(vector).max() - vector).max() <= np.abs(vector).max() / 254 + 1e-12
    assert image == topobag.ImageDescriptor(7.5 * vector, topobag.ImageKind("network", 300))
    assert image == topobag.ImageDescriptor(np.repeat(vector, 2)[::2].tolist(), "network")
    assert image != topobag.ImageDescriptor(vector, "another")
    unknown = topobag.ImageDescriptor()
    assert not unknown.known and unknown.bytes.shape == (0,) and unknown != image
    for one in (image, unknown):
        assert pickle.loads(pickle.dumps(one)) == one == copy.deepcopy(one)


def test_the_cosine_is_that_of_the_bytes(random):
    for _ in range(20):
        a, b = described(random), described(random)
        x, y = a.bytes.astype(float), b.bytes.astype(float)
        assert topobag.cosine_similarity(a, b) == pytest.approx(x @ y / np.sqrt((x @ x) * (y @ y)))
    with pytest.raises(topobag.InvalidValue, match="nothing is known"):
        topobag.cosine_similarity(a, topobag.ImageDescriptor())
    with pytest.raises(topobag.InvalidValue, match="another kind"):
        topobag.cosine_similarity(a, topobag.ImageDescriptor(np.ones(32), "another"))


def test_what_is_no_descriptor_is_refused():
    for wrong, says in [
        (np.zeros(8), "zeros"), (np.full(8, np.nan), "finite"), (np.ones((2, 4)), "descriptor"),
        ([], "1 to 65535"), ("colours", "descriptor"),
    ]:  # fmt: skip
        with pytest.raises(ValueError, match=says):
            topobag.ImageDescriptor(wrong, "network")
    with pytest.raises(ValueError, match="numbers"):
        topobag.ImageDescriptor(np.ones(8), topobag.ImageKind("network", 9))


@pytest.mark.parametrize("kind", [topobag.BagOfTopologyGraphs, topobag.IndexedBag])
def test_queries_go_by_images_as_told(kind, random):
    """Gate and share of the score, against the rule worked out here."""
    bag, graphs, images = kind(), [], []
    for i in range(30):
        graphs.append(random_graph(random))
        images.append(described(random) if i % 4 else topobag.ImageDescriptor())
        bag.add(i, graphs[-1], image=images[-1])
        assert bag.info(i).image == images[-1]
    query, image = random_graph(random), described(random)
    plain = {c.id: c.similarity for c in bag.query(query, topobag.QueryOptions(30, -1.0))}
    for weight, least in [(0.0, 0.1), (0.4, -1.0), (1.0, -0.2)]:
        options = topobag.QueryOptions(30, -1.0)
        options.image = topobag.ImageComparison(image, least, weight)
        expected = {}
        for i, similarity in plain.items():
            if not images[i].known:
                expected[i] = similarity
                continue
            cosine = topobag.cosine_similarity(image, images[i])
            if cosine >= least:
                expected[i] = (1 - weight) * similarity + weight * max(0.0, cosine)
        found = {c.id: c.similarity for c in bag.query(query, options)}
        assert found == pytest.approx(expected)
    options.image.query = topobag.ImageDescriptor(np.ones(5), "another")
    with pytest.raises(topobag.InvalidValue, match="another kind"):
        bag.query(query, options)
    with pytest.raises(topobag.InvalidValue, match="another kind"):
        bag.update(3, graphs[3], image=topobag.ImageDescriptor(np.ones(5), "another"))
    assert bag.info(3).image == images[3]


def test_maps_on_disk_keep_images(random, tmp_path):
    path, graph, image = str(tmp_path / "map.db"), random_graph(random), described(random)
    topobag.SqliteBag(path).add(4, graph, image=image)
    assert topobag.SqliteBag(path, read_only=True).info(4).image == image
    loops = topobag.LoopDetector()
    loops.detect_and_add(5, 0.0, graph, image=image)
    assert loops.bag.info(5).image == image
    assert pickle.loads(pickle.dumps(loops.bag)).info(5).image == image
