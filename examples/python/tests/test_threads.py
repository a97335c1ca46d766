# SPDX-License-Identifier: MIT
"""Threads of Python: readers beside a writer, and the interpreter left free meanwhile."""

import threading
import time

import numpy as np
import pytest
import topobag
from conftest import random_graph


def run_all(*works):
    """Runs each in a thread of its own; what one raises is raised."""
    raised = []

    def guarded(work):
        try:
            work()
        except BaseException as error:  # noqa: BLE001
            raised.append(error)

    threads = [threading.Thread(target=guarded, args=(work,), daemon=True) for work in works]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=120)
        assert not thread.is_alive(), "a thread hangs"
    if raised:
        raise raised[0]


@pytest.mark.parametrize("kind", ["IndexedBag", "BagOfTopologyGraphs"])
def test_four_readers_and_a_writer(kind):
    bag = getattr(topobag, kind)()
    graphs = [random_graph(np.random.default_rng(i)) for i in range(300)]
    for i in range(100):
        bag.add(i, graphs[i])
    done = threading.Event()

    def write():
        try:
            for i in range(100, 300):
                bag.add(i, graphs[i])
                if i % 3 == 0:
                    bag.erase(i - 100)
                if i % 5 == 0:
                    bag.update(i, graphs[i - 1])
                time.sleep(0)
        finally:
            done.set()

    def read(seed):
        random = np.random.default_rng(seed)
        asked = 0
        while not done.is_set() or asked < 5:
            found = bag.query(graphs[random.integers(0, 300)], topobag.QueryOptions(max_results=5))
            assert len(found) == 5 and sorted((-c.similarity, c.id) for c in found) == [(-c.similarity, c.id) for c in found]
            asked += 1
            time.sleep(0.001)

    run_all(write, *(lambda seed=seed: read(seed) for seed in range(4)))
    assert 299 in bag and 2 not in bag
    assert len(bag) == 300 - len(range(102, 300, 3))


def test_two_writers_take_turns():
    bag = topobag.IndexedBag()
    graphs = [random_graph(np.random.default_rng(i)) for i in range(20)]

    def add(start):
        for i in range(200):
            bag.add(start + i, graphs[i % 20])

    run_all(lambda: add(0), lambda: add(1000))
    assert len(bag) == 400


def test_filters_of_python_beside_a_writer():
    bag = topobag.BagOfTopologyGraphs()
    graph = random_graph(np.random.default_rng(1))
    for i in range(50):
        bag.add(i, graph)
    options = topobag.QueryOptions(max_results=99, filter=lambda i, info: i < 50)

    def read():
        for _ in range(30):
            assert len(bag.query(graph, options)) == 50

    def write():
        for i in range(50, 100):
            bag.add(i, graph)
            time.sleep(0)

    run_all(write, read, read)


def test_the_interpreter_is_free_while_a_query_runs(sample, relocalizer):
    """A thread that only counts goes on while others look up: it would stand still otherwise."""
    counted, done = 0, threading.Event()
    longest = 0.0

    def count():
        nonlocal counted, longest
        last = time.perf_counter()
        while not done.is_set():
            time.sleep(0.0005)
            now = time.perf_counter()
            longest = max(longest, now - last)
            last = now
            counted += 1

    thread = threading.Thread(target=count, daemon=True)
    thread.start()
    start = time.perf_counter()
    similarity = topobag.ConsistencySimilarity()
    graphs = [k.graph for k in sample[0] + sample[1]]
    similarity.matrix(graphs, graphs)
    took = time.perf_counter() - start
    ticks = counted
    done.set()
    thread.join()
    assert took > 0.02, "too short to tell"
    assert ticks >= 5, f"the other thread ran {ticks} times in {took:.3f} s"
