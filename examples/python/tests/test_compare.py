# SPDX-License-Identifier: MIT
"""One's own similarity beside the library's, pictures, and what the examples print."""

import subprocess
import sys

import numpy as np
import pytest
import topobag
from conftest import ROOT

EXAMPLES = ROOT / "examples" / "python"


@pytest.fixture(scope="module")
def comparison(sample):
    entries, queries = sample[0][::4], sample[1][::4]
    scores = topobag.ClassTriangles().matrix([q.graph for q in queries], [e.graph for e in entries])
    own = {
        "mine": lambda p, q: min(len(p), len(q)) / max(len(p), len(q), 1),
        "mine, a matrix": scores,
    }
    return topobag.compare(queries, entries, own)


def test_ones_own_stands_beside_the_library_s(comparison):
    assert len(comparison.methods) == len(topobag.all_similarities([])) + 2
    assert comparison["mine"].pair_us > 0 and comparison["mine, a matrix"].pair_us is None
    np.testing.assert_array_equal(comparison["mine, a matrix"].scores, comparison["class triangles"].scores)
    same = [comparison[name].metrics.average_precision for name in ("mine, a matrix", "class triangles")]
    assert same[0] == same[1]
    ap = [m.metrics.average_precision for m in comparison.methods]
    assert ap == sorted(ap, reverse=True)
    text = str(comparison)
    assert "mine, a matrix" in text and "A true place: distance=0.5,angle=30." in text
    with pytest.raises(KeyError, match="no method"):
        comparison["another"]


def test_what_does_not_fit_is_told(sample):
    with pytest.raises(topobag.InvalidValue, match=r"shape \(2, 2\); give 3 queries x 4"):
        topobag.compare(sample[1][:3], sample[0][:4], {"mine": np.ones((2, 2))})
    with pytest.raises(topobag.InvalidValue, match="is not finite"):
        topobag.compare(sample[1][:3], sample[0][:4], {"mine": lambda p, q: float("nan")})
    with pytest.raises(ZeroDivisionError):
        topobag.compare(sample[1][:3], sample[0][:4], {"mine": lambda p, q: 1 / 0})


def test_a_protocol_under_which_no_ranking_could_be_wrong_is_refused(sample):
    queries, entries = sample[1][::6], sample[0][::6]
    jaccard = {"class counts, Jaccard": topobag.ClassHistogram()}
    with pytest.raises(topobag.InvalidValue, match="the protocol distance=500 calls no pair false"):
        topobag.compare(queries, entries, protocol="distance=500", similarities=jaccard)
    apart = topobag.compare(queries, entries, protocol="distance=0.2", similarities=jaccard)
    assert 0.0 < apart["class counts, Jaccard"].metrics.average_precision < 1.0


def test_every_picture_is_drawn(sample, relocalizer, comparison, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import topobag.plot

    query = sample[1][20]
    found = relocalizer.localize(query.graph)
    report = found.candidates[0]
    there = relocalizer.map[report.id]
    pictures = {
        "graph": topobag.plot.graph(query.graph, np.zeros((480, 640, 3), np.uint8)),
        "match": topobag.plot.match(there, query.graph, report.pose),
        "map": topobag.plot.map_from_above(relocalizer.map, queries=np.array([query.T_world_camera])),
        "pr": topobag.plot.precision_recall({m.name: m.labelled for m in comparison.methods[:3]}),
        "matrix": topobag.plot.similarity_matrix(comparison["mine"].scores),
    }
    assert len(pictures["graph"].collections[0].get_offsets()) == len(query.graph)
    assert len(pictures["match"].lines) == len(report.pose.inliers)
    assert len(pictures["pr"].lines) == 3
    for name, axes in pictures.items():
        axes.figure.savefig(tmp_path / f"{name}.png")
        assert (tmp_path / f"{name}.png").stat().st_size > 3000
        plt.close(axes.figure)
    assert topobag.plot.map_from_above(topobag.BagOfTopologyGraphs()).get_legend() is None
    plt.close("all")


def run(script, *arguments):
    done = subprocess.run([sys.executable, str(EXAMPLES / script), *arguments], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_example_to_copy_runs(tmp_path):
    pytest.importorskip("matplotlib")
    printed = run("compare_own_similarity.py", "--plot", str(tmp_path / "pr.png"))
    assert "own: heights" in printed and (tmp_path / "pr.png").stat().st_size > 3000
    assert len((EXAMPLES / "compare_own_similarity.py").read_text().splitlines()) < 80


def test_the_walk_of_table_5_runs():
    printed = run("table5.py")
    assert "0.95" in printed and "equal to the library's to 1e-12" in printed
