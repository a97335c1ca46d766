# SPDX-License-Identifier: MIT
"""Semantic place recognition: a bag of topology graphs, and where in it a camera is.

    import topobag

    graph = topobag.TopologyGraph(topobag.lift_detections(boxes, labels, scores, depth, camera).nodes,
                                  topobag.DelaunayEdges2())
    relocalizer = topobag.Relocalizer(topobag.recognition_options(topobag.ClassCatalog.coco80()))
    relocalizer.map.add(7, graph)
    found = relocalizer.localize(other_graph)
    if found:
        print(found.accepted.pose.T_candidate_query)

Frames: camera x right, y down, z forward, metres; `T_a_b`, a 4 x 4 array, takes coordinates in b to a.
Pictures are in `topobag.plot`, which takes matplotlib.
"""

from ._topobag import *  # noqa: F403
from ._topobag import __version__  # noqa: F401
from .comparison import Comparison, ComparedMethod, all_similarities, compare  # noqa: F401


def _copied(value, memo=None):
    """A copy of a plain struct: assigning a field copies it."""
    copy = type(value)()
    for field in value.__fields__:
        setattr(copy, field, getattr(value, field))
    return copy


for _type in list(globals().values()):
    if hasattr(_type, "__fields__"):
        _type.__copy__ = _type.__deepcopy__ = _copied
del _type
