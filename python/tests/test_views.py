# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays without a copy keep their values, sessions in threads are independent, and Ctrl-C stops a computation."""
import concurrent.futures
import gc
import os
import resource
import signal
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest

import mesecina as mes
from conftest import flower_points


def test_columns_are_views_that_cannot_be_written(flower):
    radius = flower.inner_balls.faces.radius
    assert radius.base is not None and not radius.flags.writeable
    with pytest.raises(ValueError):
        radius[0] = 1.0
    with pytest.raises(ValueError):
        radius.flags.writeable = True
    assert np.shares_memory(radius, flower.inner_balls.faces.radius)


def test_an_edit_with_a_live_view_waits(flower):
    center = flower.delaunay.faces.circumcenter
    part = center[3:9, 1]
    before = part.copy()
    count = len(flower)
    flower.insert([0.0, 0.0])
    del center
    with pytest.raises(BufferError, match="1 array shows"):
        flower.delaunay.faces
        flower.delaunay.faces.rows
    np.testing.assert_array_equal(part, before)
    del part
    assert len(flower.points) == count + 1
    assert flower.digest("delaunay") == mes.Session(flower.points).digest("delaunay")


def test_edits_of_nothing_leave_views_as_they_are(flower):
    center = flower.delaunay.faces.circumcenter
    flower.remove([])
    flower.remove_balls([])
    flower.move([], [])
    flower.change_balls([], [])
    assert flower.insert([]).shape == flower.insert_balls([]).shape == (0,)
    assert np.shares_memory(center, flower.delaunay.faces.circumcenter)


def test_reading_more_leaves_views_as_they_are(flower):
    views = {}
    for structure in mes.structures():
        for table in structure["tables"]:
            for column in table["columns"]:
                array = flower.structure(structure["id"])[table["name"]][column["name"]]
                views[table["id"], column["name"]] = array, array.copy()
    flower.digest("power-crust")
    _ = flower.certificate.light, flower.statistics("delaunay")
    for name, (array, copy) in views.items():
        np.testing.assert_array_equal(array, copy, str(name))


def test_views_outlive_the_session():
    session = mes.Session(flower_points(500))
    radius = session.inner_balls.faces.radius
    copy = radius.copy()
    segments = session.instances("medial-axis", "segment")
    assert segments.shape[1] == 5
    del session
    gc.collect()
    np.testing.assert_array_equal(radius, copy)


def test_views_over_many_edits():
    session = mes.Session(flower_points(100))
    ids = session.ids
    random = np.random.default_rng(3)
    for _ in range(int(os.environ.get("MESECINA_EDITS", "2000"))):
        position = session.delaunay.sites.position
        place = position[random.integers(len(position))] * 1.001
        if random.integers(8) == 0:
            session.move(random.choice(ids), place)
            with pytest.raises(BufferError):
                session.delaunay.sites.rows
        del position
        session.move(random.choice(ids), place)


def test_a_refused_edit_leaves_views_as_they_are(flower):
    radius = flower.inner_balls.faces.radius
    with pytest.raises(ValueError):
        flower.remove(9999)
    with pytest.raises(ValueError):
        flower.set("none", 1)
    assert not flower.undo() and not flower.redo()
    assert np.shares_memory(radius, flower.inner_balls.faces.radius)


def run_alone(text):
    """Runs a program of Python in a process of its own."""
    return subprocess.run([sys.executable, "-c", textwrap.dedent(text)], capture_output=True, text=True, check=False,
                          timeout=120)


def test_the_interpreter_ends_while_threads_are_at_work():
    done = run_alone("""
        import threading, time
        import mesecina as mes
        import numpy as np

        @mes.structure()
        def slow(delaunay):
            for _ in range(50):
                time.sleep(0.001)
            return {}

        points = np.random.default_rng(1).uniform(size=(2000, 2))
        started = threading.Barrier(4)

        def work(*experiments):
            started.wait()
            while True:
                mes.Session(points, experiments=experiments).digest("power-crust")

        for experiments in [(), (slow,), (slow,)]:
            threading.Thread(target=work, args=experiments, daemon=True).start()
        started.wait()
        time.sleep(0.2)
        print("over")
        """)
    assert done.returncode == 0 and done.stdout == "over\n", done


def test_many_threads_make_the_first_sessions_together():
    done = run_alone("""
        import sys, threading
        import mesecina as mes

        sys.setswitchinterval(1e-6)
        together = threading.Barrier(8)

        counts = []

        def work():
            together.wait()
            counts.append(len(mes.Session([(0, 0), (1, 0), (0, 1)]).delaunay.faces))

        threads = [threading.Thread(target=work) for _ in range(8)]
        for one in threads:
            one.start()
        for one in threads:
            one.join()
        print(counts)
        """)
    assert done.returncode == 0 and done.stdout == f"{[4] * 8}\n", done


@pytest.mark.skipif("libasan" in os.environ.get("LD_PRELOAD", "") or "libtsan" in os.environ.get("LD_PRELOAD", ""),
                    reason="a sanitizer keeps memory that was given back")
def test_sessions_leave_no_memory_behind():
    def work(count):
        for i in range(count):
            session = mes.Session(flower_points(40))
            _ = session.axis.lambda_, session.delaunay.faces.sites
            session.move(session.ids[i % 40], (0.5, 0.5))
            try:
                session.insert([float("nan"), 0.0])
            except ValueError:
                pass
        gc.collect()

    work(200)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    work(int(os.environ.get("MESECINA_SESSIONS", "1000")))
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 4096  # KiB


def test_two_sessions_on_two_threads():
    def work(seed):
        session = mes.Session(flower_points(3000, seed))
        for i in range(30):
            session.move(session.ids[i], (0.01 * i, 0.3))
            session.run()
        return session.digest("medial-axis")

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        together = list(pool.map(work, [1, 2, 1, 2]))
    assert together == [work(1), work(2)] * 2


def test_one_session_on_two_threads_is_refused_or_done():
    session = mes.Session(flower_points(200_000, 7))
    started = threading.Event()
    seen = []

    def read():
        started.set()
        session.run()
        session.digest("medial-axis")

    thread = threading.Thread(target=read)
    thread.start()
    started.wait()
    while thread.is_alive() and not seen:
        try:
            session.value("lambda-limit")
        except RuntimeError as error:
            seen.append(str(error))
    thread.join()
    assert all(text == "the session is at work already, in this thread or in another one" for text in seen)
    assert session.digest("medial-axis") == mes.Session(session.points).digest("medial-axis")


def test_ctrl_c_stops_a_run_and_loses_nothing():
    session = mes.Session(flower_points(300_000, 9))
    is_over = threading.Event()

    def interrupt():
        # The session is at work as soon as it refuses a call.
        while not is_over.is_set():
            try:
                session.value("lambda-limit")
            except RuntimeError:
                os.kill(os.getpid(), signal.SIGINT)
                return

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        session.digest("medial-axis")
        session.digest("power-crust")
        is_over.set()
        thread.join()
    is_over.set()
    thread.join()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert len(session) == 300_000
    assert session.digest("delaunay") == mes.Session(session.points).digest("delaunay")
