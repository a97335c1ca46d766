# SPDX-License-Identifier: MIT
"""Pictures with matplotlib, which `import topobag` does not need. Each draws into `ax` and returns it."""

from __future__ import annotations

from typing import Sequence

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from . import _topobag as core

#: Of the ten most frequent classes of a picture; the others are grey.
_COLOURS = plt.get_cmap("tab10").colors
_GREY = (0.6, 0.6, 0.6)


def _axes(ax: Axes | None) -> Axes:
    return plt.subplots()[1] if ax is None else ax


def _colours(labels: np.ndarray) -> list[tuple[float, ...]]:
    found, counts = np.unique(labels, return_counts=True)
    frequent = found[np.argsort(-counts, kind="stable")][: len(_COLOURS)].tolist()
    return [_COLOURS[frequent.index(c)] if c in frequent else _GREY for c in labels.tolist()]


def _name(catalog: core.ClassCatalog, label: int) -> str:
    return catalog.name(label) if label in catalog else f"class {label}"


def graph(
    graph: core.TopologyGraph,
    image: np.ndarray | None = None,
    catalog: core.ClassCatalog | None = None,
    ax: Axes | None = None,
) -> Axes:
    """The nodes that have a pixel, and their edges, over the key frame's image."""
    ax = _axes(ax)
    catalog = catalog or core.ClassCatalog.coco80()
    if image is not None:
        ax.imshow(image)
    pixels, labels = graph.pixels, graph.labels
    for a, b in graph.edges:
        ax.plot(*pixels[[a, b]].T, color=_GREY, linewidth=1, zorder=1)
    ax.scatter(*pixels.T, c=_colours(labels), s=40, zorder=2)
    for pixel, label in zip(pixels, labels.tolist()):
        if np.isfinite(pixel).all():
            ax.annotate(_name(catalog, label), pixel, xytext=(4, 4), textcoords="offset points")
    if image is None and not ax.yaxis_inverted():
        ax.invert_yaxis()
    ax.set_aspect("equal")
    ax.set_xlabel("u, px")
    ax.set_ylabel("v, px")
    return ax


def match(
    candidate: core.TopologyGraph,
    query: core.TopologyGraph,
    pose: core.RelativePose,
    ax: Axes | None = None,
) -> Axes:
    """Both graphs from above in the candidate's frame: x to the right, z ahead; inliers are joined."""
    ax = _axes(ax)
    T = np.asarray(pose)
    there = candidate.positions
    here = query.positions @ T[:3, :3].T + T[:3, 3]
    ax.scatter(there[:, 0], there[:, 2], c=_colours(candidate.labels), marker="o", label="candidate")
    ax.scatter(here[:, 0], here[:, 2], c=_colours(query.labels), marker="x", label="query")
    for p, q in pose.inliers:
        ax.plot([there[p, 0], here[q, 0]], [there[p, 2], here[q, 2]], color=_GREY, zorder=0)
    ax.set_aspect("equal")
    ax.set_xlabel("x, m")
    ax.set_ylabel("z, m")
    ax.legend()
    return ax


def map_from_above(
    bag: core.Bag, plane: str = "xy", queries: np.ndarray | None = None, ax: Axes | None = None
) -> Axes:
    """The cameras and the objects of the entries with a pose, seen along the axis that `plane` lacks.

    `queries` (n x 4 x 4), poses in the map's world, are drawn beside them.
    """
    ax = _axes(ax)
    first, second = ("xyz".index(axis) for axis in plane)
    cameras, objects, labels = [], [], []
    for keyframe in bag:
        info = bag.info(keyframe)
        if info is None or info.T_world_camera is None:
            continue
        T, found = info.T_world_camera, bag[keyframe]
        cameras.append(T[:3, 3])
        objects.append(found.positions @ T[:3, :3].T + T[:3, 3])
        labels.append(found.labels)
    if cameras:
        at = np.concatenate(objects)
        ax.scatter(at[:, first], at[:, second], c=_colours(np.concatenate(labels)), s=4, alpha=0.5)
        path = np.array(cameras)
        ax.plot(path[:, first], path[:, second], ".-", color="black", linewidth=1, label="map")
    if queries is not None and len(queries):
        at = np.asarray(queries)[:, :3, 3]
        ax.plot(at[:, first], at[:, second], "+", color="tab:red", label="queries")
    ax.set_aspect("equal")
    ax.set_xlabel(f"{plane[0]}, m")
    ax.set_ylabel(f"{plane[1]}, m")
    if ax.get_legend_handles_labels()[0]:
        ax.legend()
    return ax


def precision_recall(
    labelled: dict[str, core.LabelledScores] | Sequence[tuple[str, core.LabelledScores]],
    ax: Axes | None = None,
) -> Axes:
    """A precision-recall curve of each query's best answer for each method."""
    ax = _axes(ax)
    for name, scores in dict(labelled).items():
        precision, recall, _ = core.precision_recall_curve(core.single_best(scores))
        ax.step(recall, precision, where="post", label=name)
    ax.set_xlim(0, 1)
    ax.set_ylim(0, 1.02)
    ax.set_xlabel("recall")
    ax.set_ylabel("precision")
    ax.legend(fontsize="small")
    return ax


def similarity_matrix(scores: np.ndarray, ax: Axes | None = None) -> Axes:
    """Scores of every pair: a row per query, a column per key frame of the map."""
    ax = _axes(ax)
    shown = ax.imshow(np.asarray(scores), vmin=0.0, vmax=1.0, cmap="viridis", aspect="auto")
    ax.figure.colorbar(shown, ax=ax)
    ax.set_xlabel("key frame of the map")
    ax.set_ylabel("query")
    return ax
