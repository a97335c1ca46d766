# SPDX-License-Identifier: MIT
"""Random calls with random arguments: an exception is fine, a crash is not.

TOPOBAG_FUZZ_CALLS says how many, TOPOBAG_FUZZ_SEED from where.
"""

import os
import re

import numpy as np
import pytest
import topobag
from conftest import FR1, random_graph, random_nodes

CALLS = int(os.environ.get("TOPOBAG_FUZZ_CALLS", 1500))
SEED = int(os.environ.get("TOPOBAG_FUZZ_SEED", 1))


def numbers(random):
    """An array of any shape, type and strides, now and then with what is no number."""
    shape = tuple(random.integers(0, 6, random.integers(0, 4)))
    array = random.normal(size=shape) * 10.0 ** random.integers(-3, 6)
    if array.size and random.random() < 0.3:
        array.flat[random.integers(array.size)] = random.choice([np.nan, np.inf, -np.inf, 1e308])
    array = array.astype(random.choice([np.float64, np.float32, np.int64, np.uint16, np.int8, bool, complex]))
    if array.ndim and random.random() < 0.3:
        array = array[::-1]
    if random.random() < 0.3:
        array = np.asfortranarray(array)
    array.flags.writeable = False
    return array


def near_miss(random):
    """Arrays that fit each other, but for what chance breaks."""
    n = int(random.integers(0, 5))
    return random.normal(size=(n, int(random.choice([2, 3, 4])))) * random.choice([1.0, 1e200, np.nan])


class Calls:
    """Anything a caller may hold, and what may be done with it."""

    def __init__(self, random):
        self.random = random
        self.held = [random_graph(random, n) for n in (0, 1, 3, 8)]
        self.held += [random_nodes(random, 4), FR1, topobag.IndexedBag(), topobag.BagOfTopologyGraphs()]
        self.functions = [getattr(topobag, name) for name in sorted(vars(topobag._topobag)) if name[0] != "_"]
        # Files are not made at random.
        self.functions = [
            f for f in self.functions if "read" not in f.__name__ and f is not topobag.SqliteBag
        ]
        self.functions += list(topobag.all_similarities([]).values())

    def argument(self):
        choice = self.random.integers(0, 9)
        if choice == 0:
            return numbers(self.random)
        if choice == 1:
            return near_miss(self.random)
        if choice == 2:
            return self.random.choice([None, -1, 0, 1, 2**31, 2**64, 0.5, np.nan, np.inf, -1e300])
        if choice == 3:
            return self.random.choice(["", "distance=1", "x" * 50, b"\x01\x02"])
        if choice == 4:
            return [self.held[i] for i in self.random.integers(0, len(self.held), self.random.integers(0, 3))]
        if choice == 5:
            return lambda *arguments: self.random.choice([0.5, 2.0])
        return self.held[self.random.integers(len(self.held))]

    def fitting(self, call):
        """Arguments of the types that the call's docstring names, as far as they are held, or any."""
        for wanted in re.findall(r"\w+: ([\w.]+)", (call.__doc__ or "").split("\n")[0])[:8]:
            name = wanted.split(".")[-1]
            held = [value for value in self.held if type(value).__name__ == name]
            if name == "self" or self.random.random() < 0.1:
                yield self.argument()
            elif name == "ArrayLike":
                yield near_miss(self.random) if self.random.random() < 0.7 else numbers(self.random)
            elif name in ("int", "float"):
                whole, real = [0, 1, 3, -1, 2**40], [0.0, 0.1, 5.0, -2.0, np.nan, np.inf]
                yield self.random.choice(whole if name == "int" else real)
            elif held:
                yield held[self.random.integers(len(held))]
            elif hasattr(getattr(topobag, name, None), "__fields__"):
                yield getattr(topobag, name)()
            else:
                yield self.argument()

    def one(self):
        random = self.random
        if random.random() < 0.4:
            call = self.functions[random.integers(len(self.functions))]
        else:
            target = self.held[random.integers(len(self.held))]
            special = ("__getitem__", "__call__", "__len__", "__repr__", "__contains__")
            names = [n for n in dir(target) if n not in ("save", "write_tum") and (n[0] != "_" or n in special)]
            attribute = getattr(target, names[random.integers(len(names))])
            if not callable(attribute):
                return attribute
            call = attribute
        if random.random() < 0.3:
            arguments = [self.argument() for _ in range(random.integers(0, 5))]
        else:
            arguments = list(self.fitting(call))
            if isinstance(getattr(call, "__self__", None), tuple({type(value) for value in self.held})):
                arguments = arguments[1:]  # itself
            arguments = arguments[: len(arguments) - int(random.integers(0, 2))]
        result = call(*arguments)
        if type(result).__module__.endswith("_topobag") and len(self.held) < 200:
            self.held.append(result)
        return result


def test_random_calls_do_no_harm():
    calls = Calls(np.random.default_rng(SEED))
    returned = 0
    refused = {}
    for _ in range(CALLS):
        try:
            calls.one()
            returned += 1
        except (topobag.Error, TypeError, ValueError, IndexError, AttributeError, MemoryError, OverflowError,
                RuntimeError) as error:  # fmt: skip
            refused[type(error).__name__] = refused.get(type(error).__name__, 0) + 1
    print(returned, refused)
    assert returned > CALLS / 20 and refused["TypeError"] > 0


def test_what_random_calls_once_broke():
    """Walks that overran the stack, and a width of no bin that ended the process."""
    graph = random_graph(np.random.default_rng(SEED), 5)
    for similarity in (
        topobag.LabelWalks(length=2**40),
        topobag.WeisfeilerLehman(iterations=2**40),
        topobag.ClassPairDistanceHistogram(bin_width=0.0),
        topobag.ClassPairDistanceHistogram(max_distance=np.inf),
        topobag.SemanticSubgraph(bin_width=-1.0),
    ):
        with pytest.raises(ValueError):
            similarity(graph, graph)
