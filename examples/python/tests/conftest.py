# SPDX-License-Identifier: MIT
"""What the tests share: the sample data, and graphs made up at random."""

import os
import pathlib

import numpy as np
import pytest
import topobag

ROOT = pathlib.Path(__file__).resolve().parents[3]
SAMPLE = ROOT / "examples" / "data"
FR1 = topobag.PinholeCamera(517.3, 516.5, 318.6, 255.3, 640, 480)


def random_nodes(random, count):
    """Nodes of a few classes strewn before the camera, with all that a detector gives."""
    positions = random.uniform([-2, -1, 1], [2, 1, 5], (count, 3))
    return topobag.Nodes(
        random.integers(0, 5, count),
        positions,
        pixels=FR1.project(positions),
        sizes=random.uniform(0.05, 0.6, (count, 2)),
        confidences=random.uniform(0.3, 1.0, count),
    )


def random_graph(random, count=8, edges=None):
    """A graph of them."""
    return topobag.TopologyGraph(random_nodes(random, count), edges or topobag.KnnEdges())


@pytest.fixture
def random():
    return np.random.default_rng(7)


@pytest.fixture(scope="session")
def sample():
    """The key frames of the sample data, fused over 3 s: of the map and of the queries."""
    return (
        topobag.read_keyframes(str(SAMPLE / "fr1_xyz"), FR1),
        topobag.read_keyframes(str(SAMPLE / "fr1_rpy"), FR1),
    )


@pytest.fixture(scope="session")
def relocalizer(sample):
    """With the sample's map."""
    found = topobag.Relocalizer(topobag.recognition_options(topobag.ClassCatalog.coco80()))
    for position, keyframe in enumerate(sample[0]):
        if keyframe.graph.is_matchable:
            found.map.add(
                position,
                keyframe.graph,
                stamp=keyframe.stamp,
                T_world_camera=keyframe.T_world_camera,
            )
    return found


@pytest.fixture(scope="session")
def shared_data():
    """The folder of the shared data; skips where it is not there."""
    folder = os.environ.get("TOPOBAG_DATA")
    if not folder:
        pytest.skip("TOPOBAG_DATA does not name the shared data")
    return pathlib.Path(folder)


def pose(rotation_vector, translation):
    """A 4 x 4 pose, by Rodrigues' formula."""
    angle = np.linalg.norm(rotation_vector)
    x, y, z = np.asarray(rotation_vector) / angle if angle > 0 else (0.0, 0.0, 0.0)
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    T = np.eye(4)
    T[:3, :3] += np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
    T[:3, 3] = translation
    return T
