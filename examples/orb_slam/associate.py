#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pairs the images of a TUM RGB-D sequence: every one with the depth image nearest in time.

    associate.py SEQUENCE > associations.txt     reads SEQUENCE/rgb.txt and SEQUENCE/depth.txt
"""
import bisect
import os
import sys


class Refused(Exception):
    """Why nothing was paired."""


def entry(path, number, line):
    """(stamp as it is written, image) of a line."""
    words = line.split()
    try:
        float(words[0])
        return words[0], words[1]
    except (ValueError, IndexError):
        raise Refused(f"{path}:{number}: a line is the time of an image, s, and its file") from None


def read_list(path):
    """(stamp as it is written, image) of each line that is no comment, in the order of time."""
    try:
        with open(path, encoding="utf-8") as file:
            lines = [(i, line) for i, line in enumerate(file, 1) if line.strip() and not line.startswith("#")]
    except OSError as error:
        raise Refused(f"{path} cannot be read: {error.strerror}") from error
    if not lines:
        raise Refused(f"{path}: there are no images in it")
    return sorted((entry(path, *line) for line in lines), key=lambda image: float(image[0]))


def associate(images, depths):
    """A line for each image: stamp, image, depth's stamp, depth image."""
    stamps = [float(stamp) for stamp, _ in depths]
    for stamp, image in images:
        at = bisect.bisect(stamps, float(stamp))
        nearest = min(range(max(at - 1, 0), min(at + 1, len(stamps))), key=lambda i: abs(stamps[i] - float(stamp)))
        yield f"{stamp} {image} {depths[nearest][0]} {depths[nearest][1]}"


def main(arguments):
    if len(arguments) != 1:
        sys.exit(__doc__)
    try:
        lists = [read_list(os.path.join(arguments[0], name)) for name in ("rgb.txt", "depth.txt")]
    except Refused as why:
        sys.exit(str(why))
    for line in associate(*lists):
        print(line)


if __name__ == "__main__":
    main(sys.argv[1:])
