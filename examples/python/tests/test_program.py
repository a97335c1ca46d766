# SPDX-License-Identifier: MIT
"""The program's answers and Python's are one, to the last bit."""

import functools
import json
import os
import pathlib
import subprocess

import numpy as np
import pytest
import topobag
from conftest import FR1, ROOT, SAMPLE

PROGRAM = pathlib.Path(os.environ.get("TOPOBAG_PROGRAM", ROOT / "build" / "examples" / "topobag"))
FR3 = topobag.PinholeCamera(535.4, 539.2, 320.1, 247.6, 640, 480)
FR2 = topobag.PinholeCamera(520.9, 521.0, 325.1, 249.7, 640, 480)
ROOMS = topobag.PinholeCamera(525, 525, 319.5, 239.5, 640, 480)

#: Map, query and their cameras, below the shared data.
SHARED = [
    ("nodes/tum_fr1_xyz.yolox_nano_416", "nodes/tum_fr1_rpy.yolox_nano_416", FR1, FR1, 0.4),
    ("nodes/tum_fr1_xyz.picodet_s_416", "nodes/tum_fr1_rpy.picodet_s_416", FR1, FR1, 0.4),
    ("nodes/fr3_sitting_xyz.yolov8nseg_tri", "nodes/fr3_walking_xyz.yolov8nseg_tri", FR3, FR3, 0.4),
    ("nodes/fr3_long_office.eao_yolo_tri", "nodes/fr2_desk.oaslam_yolov5_tri", FR3, FR2, 0.4),
    ("rooms/other_map", "rooms/query", ROOMS, ROOMS, 0.0),
    ("rooms/own_map", "rooms/query_moved", ROOMS, ROOMS, 0.0),
]


def told(*arguments):
    """What the program writes."""
    if not PROGRAM.exists():
        pytest.skip(f"the program is not built: {PROGRAM}")
    run = subprocess.run([str(PROGRAM), *arguments, "--json"], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


def text(camera):
    return ",".join(repr(x) for x in (camera.fx, camera.fy, camera.cx, camera.cy))


def quaternion(R):
    """Eigen's, by its own formula."""
    trace = R[0, 0] + (R[1, 1] + R[2, 2])  # in Eigen's order
    if trace > 0:
        root = np.sqrt(trace + 1.0)
        scale = 0.5 / root
        return [(R[2, 1] - R[1, 2]) * scale, (R[0, 2] - R[2, 0]) * scale, (R[1, 0] - R[0, 1]) * scale, 0.5 * root]
    i = int(np.argmax(np.diag(R)))
    j, k = (i + 1) % 3, (i + 2) % 3
    root = np.sqrt(R[i, i] - R[j, j] - R[k, k] + 1.0)
    scale = 0.5 / root
    q = [0.0] * 4
    q[i], q[3] = 0.5 * root, (R[k, j] - R[j, k]) * scale
    q[j], q[k] = (R[j, i] + R[i, j]) * scale, (R[k, i] + R[i, k]) * scale
    return q


def matches_of(entries, queries):
    """What Python accepts, in the form of the program's JSON."""
    catalog = topobag.ClassCatalog.coco80()
    relocalizer = topobag.Relocalizer(topobag.recognition_options(catalog))
    for i, keyframe in enumerate(entries):
        if keyframe.graph.is_matchable:
            relocalizer.map.add(i, keyframe.graph, stamp=keyframe.stamp, T_world_camera=keyframe.T_world_camera)
    looked_up = [(query, relocalizer.localize(query.graph)) for query in queries]
    usable = sum(1 for _, found in looked_up if found.usable and found.candidates)
    matches = []
    for query, found in looked_up:
        if found:
            T = found.accepted.pose.T_candidate_query
            matches.append(
                {
                    "query_idx": query.idx,
                    "map_idx": entries[found.accepted.id].idx,
                    "score": found.accepted.score,
                    "matched": {catalog.name(c): n for c, n in found.accepted.matched.items()},
                    "pose_candidate_query": [*T[:3, 3].tolist(), *map(float, quaternion(T[:3, :3]))],
                }
            )
    return usable, matches


def same_matches(map_set, query_set, map_camera, query_camera, interval, window):
    program = told(
        "localize", "--map", map_set, "--query", query_set, "--camera", text(query_camera),
        "--map-camera", text(map_camera), "--keyframe-interval", str(interval), "--window", str(window),
    )  # fmt: skip
    read = functools.partial(topobag.read_keyframes, interval=interval, window=window)
    usable, matches = matches_of(read(map_set, map_camera), read(query_set, query_camera))
    assert usable == program["queries"]
    assert matches == [{key: match[key] for key in matches[0]} for match in program["matches"]]


@pytest.mark.parametrize("window", [0.0, 3.0])
def test_localize_over_the_sample(window):
    same_matches(str(SAMPLE / "fr1_xyz"), str(SAMPLE / "fr1_rpy"), FR1, FR1, 0.0, window)


@pytest.mark.parametrize("window", [0.0, 3.0])
@pytest.mark.parametrize("tables", SHARED, ids=lambda t: t[1].split("/")[1] + " in " + t[0].split("/")[1])
def test_localize_over_the_shared_tables(tables, window, shared_data):
    map_set, query_set, map_camera, query_camera, interval = tables
    same_matches(str(shared_data / map_set), str(shared_data / query_set), map_camera, query_camera, interval, window)


def test_compare_over_the_sample(sample):
    program = told(
        "compare", "--map", str(SAMPLE / "fr1_xyz"), "--query", str(SAMPLE / "fr1_rpy"), "--camera", text(FR1),
        "--protocol", "distance=0.5,angle=30",
    )  # fmt: skip
    ours = topobag.compare(sample[1], sample[0])
    known = {method["name"]: method for method in program["methods"]}
    assert {m.name for m in ours.methods} <= set(known)
    for method in ours.methods:
        theirs = known[method.name]
        assert method.metrics.average_precision == theirs["average_precision"]
        assert method.metrics.recall_at_100p == theirs["recall_at_100p"]
        assert (method.recall_at_1, method.recall_at_5) == (theirs["recall_at_1"], theirs["recall_at_5"])


def test_similarity_over_the_sample():
    keyframes = {k.idx: k for k in topobag.read_keyframes(str(SAMPLE / "fr1_xyz"), FR1, interval=0, window=0)}
    frames = sorted(keyframes)[:40:13]
    program = told(
        "similarity", "--nodes", str(SAMPLE / "fr1_xyz"), "--camera", text(FR1),
        "--frames", ",".join(map(str, frames)),
    )  # fmt: skip
    columns = {
        "paper": topobag.PaddedCosine(),
        "raw_z": topobag.PaddedCosine(depth_scale=5000.0),
        "sorted": topobag.PaddedCosine(topobag.RowOrder.class_then_position),
        "assigned": topobag.PaddedCosine(topobag.RowOrder.assignment),
        "default": topobag.ClassPairDistanceHistogram(),
    }
    for row in program["frames"]:
        for name, similarity in columns.items():
            assert similarity(keyframes[frames[0]].graph, keyframes[row["frame"]].graph) == row[name]


def test_a_map_of_the_program_is_read(tmp_path, sample):
    if not PROGRAM.exists():
        pytest.skip(f"the program is not built: {PROGRAM}")
    for name, kind in [("m.bag", topobag.BagOfTopologyGraphs.load), ("m.db", topobag.SqliteBag)]:
        path = str(tmp_path / name)
        subprocess.run(
            [str(PROGRAM), "map", "--nodes", str(SAMPLE / "fr1_xyz"), "--camera", text(FR1), "--out", path],
            check=True, capture_output=True,
        )  # fmt: skip
        bag = kind(path, catalog=topobag.ClassCatalog.coco80())
        assert len(bag) > 50
        for keyframe in sample[0][10:13]:
            assert bag[keyframe.idx].encode() == keyframe.graph.encode()


def own_classes(folder):
    """COCO's classes and one more, of which other things are said, and the same as the program's file."""
    catalog = topobag.ClassCatalog.coco80()
    catalog.add(80, "fume hood", topobag.Dynamics.medium)
    catalog.set_dynamics(catalog["mouse"], topobag.Dynamics.high)
    alike = topobag.ClassGroups()
    alike.join(catalog["tv"], catalog["microwave"])
    sizes = {catalog["keyboard"]: [0.45, 0.15], catalog["laptop"]: [0.35, 0.25]}
    classes = topobag.DescribedCatalog(catalog, alike, sizes)
    others = {"tv": "microwave"}
    rows = []
    for id in catalog:
        size = " x ".join(map(str, sizes[id])) if id in sizes else ""
        rows.append(f"{catalog.name(id)}, {catalog.dynamics(id).name}, {others.get(catalog.name(id), '')}, {size}\n")
    file = folder / "classes.txt"
    file.write_text("".join(rows))
    return classes, file


def saved(path, keyframes, classes):
    """A map of key frames at a path, made in Python."""
    bag = topobag.SqliteBag(path, catalog=classes) if path.endswith(".db") else topobag.IndexedBag()
    if path.endswith(".db"):
        assert bag.begin_session("fr1_xyz") == 0  # as the program calls it
    for keyframe in keyframes:
        bag.add(keyframe.idx, keyframe.graph, stamp=keyframe.stamp, T_world_camera=keyframe.T_world_camera)
    if not path.endswith(".db"):
        bag.save(path, classes)


@pytest.mark.parametrize("name, kept_in", [("own.bag", topobag.saved_catalog), ("own.db", topobag.sqlite_catalog)])
def test_the_program_goes_by_the_classes_of_a_map_of_python(tmp_path, name, kept_in):
    classes, file = own_classes(tmp_path)
    keyframes = topobag.read_keyframes(str(SAMPLE / "fr1_xyz"), FR1, catalog=classes)
    assert len(keyframes) > 40
    path, other = str(tmp_path / name), str(tmp_path / ("program_" + name))
    saved(path, keyframes, classes)
    camera = ["--camera", text(FR1)]
    look_up = ["localize", "--query", str(SAMPLE / "fr1_rpy"), *camera, "--map"]
    found = told(*look_up, path)
    assert found["accepted"] > 0
    assert found["matches"] == told(*look_up, path, "--classes", str(file))["matches"]
    made = subprocess.run(
        [str(PROGRAM), "map", "--nodes", str(SAMPLE / "fr1_xyz"), *camera, "--classes", str(file), "--out", other],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert made.returncode == 0, made.stderr
    assert found["matches"] == told(*look_up, other)["matches"]
    assert topobag.difference(kept_in(other), kept_in(path)) is None
    assert topobag.difference(kept_in(other), classes) is None and kept_in(other).sizes == classes.sizes

    file.write_text(file.read_text().replace("0.45 x 0.15", "0.45 x 0.2"))
    refused = subprocess.run(
        [str(PROGRAM), *look_up, path, "--classes", str(file)], capture_output=True, text=True, check=False
    )
    classes.sizes = {**classes.sizes, classes.catalog["keyboard"]: [0.45, 0.2]}
    classes.source = str(file)
    with pytest.raises(topobag.FormatError, match="class 'keyboard' is typically 0.45 x 0.15 m in the map") as error:
        topobag.SqliteBag(path, True, classes) if name == "own.db" else topobag.IndexedBag.load(path, classes)
    assert refused.returncode == 2 and refused.stderr == f"topobag: {error.value}\n"
