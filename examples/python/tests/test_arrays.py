# SPDX-License-Identifier: MIT
"""Arrays as people have them: any strides are taken, and what is wrong is told in a sentence."""

import numpy as np
import pytest
import topobag
from conftest import FR1

DEPTH = np.full((480, 640), 5000, np.uint16)
BOX = [[100.0, 100.0, 160.0, 160.0]]


def lifted(depth=DEPTH, boxes=BOX, labels=(56,), scores=(0.9,), **options):
    options = {"depth_scale": 5000.0, **options}
    return topobag.lift_detections(boxes, labels, scores, depth, FR1, **options)


@pytest.mark.parametrize(
    "strided",
    [
        lambda a: a,
        lambda a: np.asfortranarray(a),
        lambda a: np.repeat(a, 2, axis=0)[::2],
        lambda a: a[::-1].copy()[::-1],
        lambda a: np.flip(np.flip(a).copy()),
        lambda a: a.astype(np.float32).astype(np.float64),
        lambda a: a.tolist(),
        lambda a: a.astype(">f8"),
    ],
    ids=["plain", "fortran", "every second", "negative", "both negative", "float32", "lists", "big endian"],
)
def test_positions_of_any_strides(strided):
    positions = np.arange(12.0).reshape(4, 3)
    np.testing.assert_array_equal(topobag.Nodes([0] * 4, strided(positions)).positions, positions)


def test_read_only_arrays_are_read():
    positions = np.arange(12.0).reshape(4, 3)
    positions.flags.writeable = False
    labels = np.zeros(4, np.int16)
    labels.flags.writeable = False
    assert len(topobag.Nodes(labels, positions)) == 4
    depth = DEPTH.copy()
    depth.flags.writeable = False
    assert len(lifted(depth)) == 1


@pytest.mark.parametrize(
    "depth",
    [
        DEPTH,
        DEPTH.astype(np.float32),
        DEPTH.astype(np.float64),
        np.pad(DEPTH, 8)[8:-8, 8:-8],
        DEPTH[::-1],
        DEPTH[:, ::-1],
        np.asfortranarray(DEPTH),
        np.repeat(DEPTH, 2, axis=1)[:, ::2],
    ],
    ids=["uint16", "float32", "float64", "cut out", "upside down", "mirrored", "fortran", "every second"],
)
def test_depth_images_of_any_strides(depth):
    found = lifted(depth)
    assert found.nodes.z == [1.0]
    np.testing.assert_array_equal(found.nodes.pixels, [[130.0, 130.0]])


def test_a_depth_image_is_read_where_it_is_told():
    depth = np.zeros((480, 640), np.float32)
    depth[100:161, 100:161] = np.arange(100, 161)[:, None] / 100.0  # rows tell themselves apart
    centre = topobag.CenterDepth()
    for image in (depth, depth[::-1][::-1], np.asfortranarray(depth)):
        z = lifted(image, depth_scale=None, sampling=centre).nodes.z
        assert z == np.float32(1.3)
    flipped = lifted(np.ascontiguousarray(depth[::-1])[::-1], depth_scale=None, sampling=centre)
    assert flipped.nodes.z == np.float32(1.3)


def test_what_became_of_detections_is_counted():
    boxes = np.array([[100, 100, 160, 160], [0, 0, 640, 480], [100, 100, 160, 160], [10, 10, 5, 5]], float)
    found = lifted(boxes=boxes, labels=[56, 56, 0, 56], scores=[0.9, 0.9, 0.9, 0.9])
    assert (found.dropped.too_large, found.dropped.dynamic, found.dropped.invalid) == (1, 1, 1)
    np.testing.assert_array_equal(found.sources, [0])
    assert found.dropped.total() == 3


def test_depths_of_the_boxes_do_as_well():
    found = lifted(depth=[1.0])
    assert found.nodes.z == [1.0]
    np.testing.assert_allclose(found.nodes.positions[0], FR1.back_project([[130.0, 130.0]], [1.0])[0])


def refused(sentence, call, error=topobag.InvalidValue):
    with pytest.raises(error, match=sentence) as raised:
        call()
    assert isinstance(raised.value, topobag.Error)
    return raised.value


def test_wrong_shapes_are_told():
    refused(r"positions has the shape \(4, 2\); give N x 3", lambda: topobag.Nodes([0] * 4, np.ones((4, 2))))
    refused(r"shape \(12,\)", lambda: topobag.Nodes([0] * 4, np.ones(12)))
    refused("positions has 3 rows, but there are 4 labels", lambda: topobag.Nodes([0] * 4, np.ones((3, 3))))
    refused("labels has the shape", lambda: topobag.Nodes(3))
    refused("no array of numbers", lambda: topobag.Nodes([0, 1], [[1, 2, 3], [1, 2]]))
    refused("height x width", lambda: lifted(np.zeros((2, 3, 4), np.uint16)))
    refused("labels has 2 rows, but there are 1 boxes", lambda: lifted(labels=[0, 1]))
    refused("edges has the shape", lambda: topobag.TopologyGraph(topobag.Nodes([0]), np.ones((2, 3), int)))


def test_wrong_types_are_told():
    refused("positions has the type complex128", lambda: topobag.Nodes([0], np.ones((1, 3), complex)))
    refused("type <U1", lambda: topobag.Nodes([0], [["a", "b", "c"]]))
    refused("labels has the type float64; give whole numbers", lambda: topobag.Nodes([0.5]))
    refused("depth image has the type int32", lambda: lifted(DEPTH.astype(np.int32)))
    refused("depth_scale", lambda: lifted(depth_scale=None))
    refused("type object", lambda: topobag.Nodes([0], np.array([[None, 1, 2]], object)))
    refused("32-bit", lambda: topobag.Nodes([2**40]))
    refused("2\\^63", lambda: topobag.Nodes(np.array([2**63], np.uint64)))


def test_numbers_that_are_not_finite_are_told_with_their_index():
    positions = np.ones((4, 3))
    positions[2, 1] = np.nan
    assert refused("node 2 holds a number that is not finite", lambda: topobag.Nodes([0] * 4, positions)).index == 2
    positions[2, 1] = np.inf
    assert refused("node 2", lambda: topobag.Nodes([0] * 4, positions)).index == 2
    refused("node 0", lambda: topobag.Nodes([0], z=[np.nan]))
    refused("positive definite", lambda: topobag.Nodes([0], covariances=[-np.eye(3)]))
    refused("descriptor holds a number", lambda: topobag.Nodes([0], appearances=[[1.0, np.nan]]))


def test_depth_holes_are_no_error():
    depth = np.full((480, 640), np.nan)
    assert lifted(depth).dropped.no_depth == 1
    assert lifted(np.zeros((480, 640), np.uint16)).dropped.no_depth == 1


def test_no_rows_are_no_objects():
    for empty in (np.zeros((0, 3)), [], np.zeros((0, 3), np.float32)):
        nodes = topobag.Nodes([], empty)
        assert len(nodes) == 0 and nodes.positions.shape == (0, 3)
    assert len(lifted(boxes=np.zeros((0, 4)), labels=[], scores=[])) == 0
    assert len(topobag.TopologyGraph(topobag.Nodes([]), np.zeros((0, 2), int)).edges) == 0
    refused("the depth image is empty", lambda: lifted(np.zeros((0, 640), np.uint16)))


def test_a_million_rows():
    positions = np.random.default_rng(1).uniform(0, 100, (1_000_000, 3))
    graph = topobag.TopologyGraph(topobag.Nodes(np.zeros(1_000_000, int), positions))
    np.testing.assert_array_equal(graph.positions, positions)
    refused("up to 4096", lambda: topobag.BagOfTopologyGraphs().add(1, graph))


def test_poses_that_are_none_are_told():
    bag, graph = topobag.BagOfTopologyGraphs(), topobag.TopologyGraph(topobag.Nodes([0]))
    for wrong, sentence in [
        (np.ones((4, 4)), "no rigid motion"),
        (np.eye(3), r"shape \(3, 3\); give 4 x 4"),
        (2 * np.eye(4), "last row"),
        (np.diag([-1.0, 1, 1, 1]), "mirrors"),
        (np.full((4, 4), np.nan), "not finite"),
    ]:
        refused(sentence, lambda: bag.add(1, graph, T_world_camera=wrong))
    assert len(bag) == 0
    bag.add(1, graph, T_world_camera=np.asfortranarray(np.eye(4))[::-1][::-1])
    np.testing.assert_array_equal(bag.info(1).T_world_camera, np.eye(4))


def test_ids_out_of_range_are_told():
    bag, graph = topobag.BagOfTopologyGraphs(), topobag.TopologyGraph(topobag.Nodes([0]))
    refused("an id of -1", lambda: bag.add(-1, graph))
    refused("an id of 18446744073709551616", lambda: bag.add(2**64, graph))
    bag.add(np.uint64(2**64 - 1), graph)
    assert list(bag) == [2**64 - 1]


def test_errors_are_the_library_s_and_python_s():
    catalog = topobag.ClassCatalog.coco80()
    assert isinstance(refused("nearest known", lambda: catalog["chiar"], topobag.UnknownClass), LookupError)
    bag, graph = topobag.BagOfTopologyGraphs(), topobag.TopologyGraph(topobag.Nodes([0]))
    bag.add(1, graph)
    assert isinstance(refused("use update", lambda: bag.add(1, graph), topobag.InvalidId), LookupError)
    refused("not in the bag", lambda: bag[2], topobag.InvalidId)
    refused("nanoseconds", lambda: bag.update(1, graph, stamp=1.7e18))
    assert isinstance(
        refused("", lambda: topobag.TopologyGraph.decode(b"what"), topobag.FormatError), ValueError
    )
    refused("this has to hold", lambda: topobag.AffinityCosine(sigma=-1.0)(graph, graph))
