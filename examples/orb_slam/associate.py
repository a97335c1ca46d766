#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pairs the images of a TUM RGB-D sequence: every one with the depth image nearest in time.

    associate.py SEQUENCE > associations.txt     reads SEQUENCE/rgb.txt and SEQUENCE/depth.txt
"""
import bisect
import os
import sys


def read_list(path):
    """(stamp as it is written, image) of each line that is no comment, in the order of time."""
    with open(path, encoding="utf-8") as file:
        lines = [line.split() for line in file if line.strip() and not line.startswith("#")]
    return sorted(((words[0], words[1]) for words in lines), key=lambda entry: float(entry[0]))


def associate(images, depths):
    """A line for each image: stamp, image, depth's stamp, depth image."""
    stamps = [float(stamp) for stamp, _ in depths]
    for stamp, image in images:
        at = bisect.bisect(stamps, float(stamp))
        nearest = min(range(max(at - 1, 0), min(at + 1, len(stamps))), key=lambda i: abs(stamps[i] - float(stamp)))
        yield f"{stamp} {image} {depths[nearest][0]} {depths[nearest][1]}"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for line in associate(*(read_list(os.path.join(sys.argv[1], name)) for name in ("rgb.txt", "depth.txt"))):
        print(line)
