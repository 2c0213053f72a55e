# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of the benchmark that concern Python, in one process: PYTHONPATH=build/release/python python3 tests/bench/python.py"""
import ctypes
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
from scipy.spatial import Delaunay, Voronoi

import mesecina as mes

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD = pathlib.Path(mes.__file__).parent.parent.parent


def seconds(work, times):
    out = []
    for _ in range(times):
        begin = time.perf_counter()
        work()
        out.append(time.perf_counter() - begin)
    return statistics.median(out)


def row(name, value, unit, goal):
    print(f"{name:<66} {value:9.3f} {unit:<3} goal {goal}", flush=True)


def curve(count):
    angle = np.arange(count) * 2 * np.pi / count
    return np.column_stack([np.cos(angle) * (1 + 0.3 * np.sin(5 * angle)), np.sin(angle) * (1 + 0.3 * np.cos(7 * angle))])


def axis():
    points = curve(100_000)
    own = seconds(lambda: mes.Session(points).axis, 5)
    row("Session(points).axis of 10^5 / scipy Delaunay and Voronoi", own / seconds(lambda: (Delaunay(points), Voronoi(points)), 1), "",
        "0.3")


def moves():
    points = np.ascontiguousarray(curve(100_000))
    with tempfile.TemporaryDirectory() as folder:
        library = pathlib.Path(folder) / "moves.so"
        subprocess.run([os.environ.get("CXX", "g++"), "-std=c++20", "-O2", "-shared", "-fPIC", ROOT / "tests/bench/python_moves.cpp",
                        "-I", ROOT / "core/library", "-L", BUILD / "core/library", "-lmesecina", "-o", library], check=True)
        native = ctypes.CDLL(str(library)).moves
    native.restype = ctypes.c_double
    native.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t]
    session = mes.Session()
    session.insert(points)
    edges, one = session.medial_axis.edges, int(session.ids[5])
    edges.changed
    step = 0

    def move():
        nonlocal step
        step += 1
        session.move(one, (points[5, 0] + 1e-9 * (step % 2 + 1), points[5, 1]))
        return edges.changed

    in_cpp = native(points.ctypes.data, len(points), 3000)
    in_python = 1e6 * seconds(move, 3000)
    row("a move and its changed rows, 10^5, in C++", in_cpp, "us", "-")
    row("the same in Python, more than that", in_python - in_cpp, "us", "10")


def columns():
    session = mes.Session(curve(1_000_000))
    session.axis
    row("s.inner_balls.faces.radius of 10^6, a view", 1e6 * seconds(lambda: session.inner_balls.faces.radius, 1000), "us", "50")
    row("s.axis.radius of 10^6, once the axis is there", 1e6 * seconds(lambda: session.axis.radius, 1000), "us", "50")
    row("s.axis of 10^6 from the tables, a copy", 1e3 * seconds(lambda: mes.Axis(session._bench), 3), "ms", "-")


def cluster():
    from distributed import Client, LocalCluster

    sys.path.insert(0, str(ROOT / "examples/python"))
    os.environ["PYTHONPATH"] = f"{ROOT / 'examples/python'}:{BUILD / 'python'}"
    import many_shapes

    with tempfile.TemporaryDirectory() as folder:
        many_shapes.make(1000, f"{folder}/shapes")
        times = []
        for workers in (1, 2):
            with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as machines, \
                    Client(machines) as client:
                executor = client.get_executor()
                list(executor.map(abs, range(10)))
                client.run(__import__, "many_shapes")
                times.append(seconds(lambda: many_shapes.run(f"{folder}/shapes", f"{folder}/{workers}.csv", executor,
                                                             lambda text: None), 1))
        row("1,000 shapes with 1 worker of Dask / 2", times[0] / times[1], "", "1.8 or more")


if __name__ == "__main__":
    for one in (axis, moves, columns, cluster):
        if len(sys.argv) == 1 or one.__name__ in sys.argv[1:]:
            one()
