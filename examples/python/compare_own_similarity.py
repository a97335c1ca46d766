# SPDX-License-Identifier: MIT
"""Scores a similarity of your own against the library's on the same pairs of key frames.

    python3 examples/python/compare_own_similarity.py [MAP QUERY fx,fy,cx,cy,width,height] [--plot FILE]

MAP and QUERY are node tables of one world; without them the sample data are compared.
"""

import argparse
import pathlib

import numpy as np
import topobag

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"


def heights_in_common(p, q):
    """My own: the share of the objects that have one of their class at the same height (camera's y)."""
    if len(p) == 0 or len(q) == 0:
        return 0.0
    same_class = p.labels[:, None] == q.labels[None, :]
    near = np.abs(p.positions[:, None, 1] - q.positions[None, :, 1]) < 0.1  # m
    return float((same_class & near).any(axis=1).mean())


def constant(p, q):
    """What knows nothing: every method should beat it."""
    return 0.5


def parsed():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("map", nargs="?", default=str(DATA / "fr1_xyz"))
    parser.add_argument("query", nargs="?", default=str(DATA / "fr1_rpy"))
    parser.add_argument("camera", nargs="?", default="517.3,516.5,318.6,255.3,640,480")
    parser.add_argument("--plot", help="file for the precision-recall curves (takes matplotlib)")
    return parser.parse_args()


def main():
    arguments = parsed()
    fx, fy, cx, cy, width, height = (float(x) for x in arguments.camera.split(","))
    camera = topobag.PinholeCamera(fx, fy, cx, cy, int(width), int(height))
    entries = topobag.read_keyframes(arguments.map, camera)
    queries = topobag.read_keyframes(arguments.query, camera)

    # A callable is asked pair by pair; what you have worked out elsewhere comes as a matrix.
    counts = np.array([[len(q.graph) - len(e.graph) for e in entries] for q in queries])
    own = {
        "own: heights": heights_in_common,
        "own: object counts": 1.0 / (1.0 + np.abs(counts)),
        "own: constant": constant,
    }
    comparison = topobag.compare(queries, entries, own)
    print(comparison)

    if arguments.plot:
        from topobag import plot

        shown = [m for m in comparison.methods[:5]] + [comparison["own: heights"]]
        axes = plot.precision_recall({m.name: m.labelled for m in shown})
        axes.figure.savefig(arguments.plot, dpi=150)
        print(f"Precision-recall curves: {arguments.plot}")


if __name__ == "__main__":
    main()
