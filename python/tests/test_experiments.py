# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures, layers and evolutions in Python follow edits, are drawn, and fail with one line."""
import json
import os
import pickle
import signal
import subprocess
import threading
import time

import numpy as np
import pytest

import mesecina as mes
import own
from conftest import SHAPES, flower_points
from mesecina import _program
from mesecina._window import _files_of

ALL = (own.long_edges, own.long_edge_lines, own.middle, own.middle_disk)


def test_a_structure_follows_edits_and_parameters():
    session = mes.Session(flower_points(100), experiments=ALL)
    for step in range(20):
        session.move(session.ids[step], (0.1 * step, -0.4))
        session.set("long-edges-limit", 0.05 * (step % 5))
        delaunay = session.delaunay
        rows = delaunay.edges.rows
        ends = delaunay.sites.position[delaunay.edges.sites]
        length = np.hypot(*(ends[:, 0] - ends[:, 1]).T)[rows]
        edges = session.long_edges.edges
        np.testing.assert_array_equal(edges.rows, rows)
        np.testing.assert_array_equal(edges.length[rows], length)
        is_long = length > 0.05 * (step % 5)
        np.testing.assert_array_equal(edges.is_long[rows], is_long)
        assert session.statistics("long-edges") == {"longest": length.max(), "count": is_long.sum()}
        del rows
        drawn = session.instances("long-edge-lines", "segment")
        assert len(drawn) == is_long.sum()
        np.testing.assert_array_equal(np.sort(drawn[:, 4]), np.sort(length[is_long]))
        del drawn, delaunay, edges
        fresh = mes.Session(session.points, experiments=ALL)
        fresh.set("long-edges-limit", 0.05 * (step % 5))
        assert session.digest("long-edge-lines") == fresh.digest("long-edge-lines")
    np.testing.assert_allclose(session.middle.points.place, [session.points.mean(axis=0)])
    session.set("middle-disk-radius", 2.0)
    np.testing.assert_allclose(session.instances("middle-disk", "disk")[:, 2], [2.0])


def test_its_parameters_and_layers_are_in_the_catalogue():
    session = mes.Session(experiments=ALL)
    parameter = next(one for one in session.catalogue.parameters() if one["id"] == "long-edges-limit")
    assert (parameter["low"], parameter["high"], parameter["default"]) == (0.0, 1000.0, 0.5)
    assert parameter["description"] == "Longer edges are long"
    layer = next(one for one in session.catalogue.layers() if one["id"] == "long-edge-lines")
    assert layer["kinds"] == ["segment"] and layer["scalar"] == "length" and layer["description"].startswith("Edges")
    assert layer["color"] == pytest.approx((0, 0.5, 1), abs=0.01)
    assert not any(one["id"] == "long-edges" for one in mes.structures())
    with pytest.raises(AttributeError):
        mes.Session().long_edges


def test_a_session_with_experiments_is_pickled():
    session = mes.Session(flower_points(50), experiments=ALL)
    session.set("long-edges-limit", 0.3)
    other = pickle.loads(pickle.dumps(session))
    assert other.experiments == ALL and other.digest("long-edge-lines") == session.digest("long-edge-lines")
    assert session.copy().value("long-edges-limit") == 0.3


def test_evolutions():
    points = flower_points(60)
    session = mes.Session(points, contours=[range(60)])
    after = session.evolve(own.shrink, 2)
    mean = points.mean(axis=0)
    np.testing.assert_allclose(after.points, mean + 0.25 * (points - mean), atol=1e-12)
    np.testing.assert_allclose(session.evolve(own.shrink, factor=1.0).points, points, atol=1e-12)
    assert not after.undo() and len(after.contours) == 1
    seen = []

    @mes.evolution()
    def look(points, curves, step):
        seen.append((curves, step))
        return points

    mes.Session(points).evolve(look, 2)
    [(curve, is_closed)], step = seen[1]
    assert is_closed and step == 1
    assert {frozenset(one) for one in zip(curve, np.roll(curve, -1))} == {frozenset((i, (i + 1) % 60)) for i in range(60)}
    mes.Session([[0, 0], [1, 0], [2, 0.1], [3, 0]]).evolve(look)
    assert [(sorted(curve), is_closed) for curve, is_closed in seen[-1][0]] == [([0, 1, 2, 3], False)]
    for bad, error in [(lambda points: points[:-1], ValueError), (lambda points: points * np.nan, ValueError),
                       (lambda points: "x", TypeError)]:
        with pytest.raises(error):
            session.evolve(mes.evolution(id="bad")(bad))
    with pytest.raises(ValueError):
        session.evolve(own.shrink, none=1)


def test_what_a_function_raises_is_one_line():
    @mes.structure()
    def picky(delaunay):
        if len(delaunay.sites.rows) > 5:
            raise LookupError("too\nmany")
        return {"rows": {"x": np.zeros(0)}}

    session = mes.Session([[0, 0], [1, 0]], experiments=[picky])
    assert len(session.picky.rows.x) == 0
    session.insert(flower_points(10))
    with pytest.raises(mes.ComputationFailed, match=r"LookupError: too many \(test_experiments.py:\d+\)") as caught:
        session.picky.rows.x
    assert caught.value.structure == "picky" and "\n" not in str(caught.value)
    assert len(session.axis.points)  # everything else goes on
    session.remove(session.ids[:10])
    assert len(session.picky.rows.x) == 0


@pytest.mark.parametrize("result, error", [
    ({"rows": {"x": np.zeros(4), "y": np.zeros(3)}}, ValueError), ({"rows": {"x": np.zeros((3, 4))}}, ValueError),
    ({"rows": {"x": ["a"]}}, TypeError), ([1, 2], TypeError), (None, TypeError), ({"rows": [1, 2]}, TypeError)])
def test_results_that_are_refused(result, error):
    with pytest.raises(error):
        mes.Session(experiments=[mes.structure(id="wrong")(lambda delaunay: result)])


def test_a_table_that_changes_its_columns():
    @mes.structure()
    def unsteady(samples):
        many = len(samples.samples.rows) > 3
        return {"rows": {"x": np.zeros(2, dtype=bool) if many else np.zeros(2)}}

    session = mes.Session(experiments=[unsteady])
    session.insert(flower_points(5))
    with pytest.raises(mes.ComputationFailed, match="another type"):
        session.unsteady.rows.x


def test_definitions_that_are_refused():
    def function(delaunay):
        return {}

    for work, error in [
            (lambda: mes.Session(experiments=[own.long_edge_lines]), ValueError),
            (lambda: mes.Session(experiments=[own.long_edges, own.long_edges]), ValueError),
            (lambda: mes.Session(experiments=[own.shrink]), TypeError),
            (lambda: mes.Session(experiments=[function]), TypeError),
            (lambda: mes.Session(experiments=[mes.structure(id="delaunay")(function)]), ValueError),
            (lambda: mes.Session(experiments=[mes.structure(id="Not Kebab")(function)]), ValueError),
            (lambda: mes.Session(experiments=[mes.structure(rows={"none": "delaunay/edges"})(function)]), ValueError),
            (lambda: mes.structure()(lambda delaunay, text="x": {}), TypeError),
            (lambda: mes.structure()(lambda *all: {}), TypeError),
            (lambda: mes.evolution()(lambda places: places), TypeError),
            (lambda: mes.layer(rows="delaunay/edges", kind="blob"), ValueError),
            (lambda: mes.layer(rows="delaunay/edges", kind="point", color="red"), TypeError),
            (lambda: mes.layer(rows="delaunay/edges", kind="point", color=(1, 1)), ValueError),
            (lambda: mes.layer(rows="delaunay/edges", kind="point", color_map=3), TypeError),
            (lambda: mes.structure(rows={"rows": 3})(function), TypeError),
            (lambda: mes.Session(experiments=[mes.structure(id="far", rows={"rows": "medial-axis/edges"})(
                lambda delaunay: {"rows": {"x": np.zeros(0)}})]), ValueError),
            (lambda: mes.Session(experiments=[mes.structure()(lambda delaunay: {1: 2})]), TypeError),
            (lambda: mes.Session(experiments=[mes.layer(rows="delaunay/edges", kind="segment", id="flat")(
                lambda delaunay: np.zeros((3, 2)))]), ValueError)]:
        with pytest.raises(error) as caught:
            work()
        assert "\n" not in str(caught.value)


PROGRAM = "compute {} --with {} --layers long-edge-lines,middle-disk --set long-edges-limit=20 --digest --no-timing"


def test_the_program_loads_a_file(program, tmp_path):
    shape, file = SHAPES / "lizard.poff", own.__file__
    report = json.loads(program(*PROGRAM.format(shape, file).split()))
    session = mes.open(shape, experiments=ALL)
    session.set("long-edges-limit", 20)
    for layer in ("long-edge-lines", "middle-disk"):
        assert report["layers"][layer]["digest"] == session.digest(layer)
    assert report["structures"]["long-edges"]["count"] == session.statistics("long-edges")["count"]
    moved = tmp_path / "moved.poff"
    program("evolve", shape, "--with", file, "--evolution", "shrink", "--steps", 2, "--set", "shrink-factor=0.25", "-o", moved)
    np.testing.assert_allclose(mes.open(moved).points, session.evolve(own.shrink, 2, factor=0.25).points)
    assert b"long-edge-lines" in program("list", "layers", "--with", file)
    checked = program("check", file).decode()
    assert checked.count(" ok, ") > 8 and "update = rebuild" in checked


@pytest.mark.parametrize("text, said", [
    ("x = (\n", "SyntaxError"), ("x = 1\n", "no structure, layer or evolution"), ("raise KeyError('no')\n", "(idea.py:1)"),
    ("import mesecina as mes\n@mes.structure()\ndef delaunay(samples):\n    return {}\n", "a structure delaunay already"),
    ("import mesecina as mes, ctypes\n@mes.structure()\ndef crash(samples):\n"
     "    if len(samples.samples.rows) > 2: ctypes.string_at(0)\n    return {}\n", "Segmentation fault")])
def test_mistakes_in_a_file_are_one_line(text, said, tmp_path):
    file = tmp_path / "idea.py"
    file.write_text(text)
    done = subprocess.run([_program.path(), "compute", SHAPES / "bean.poff", "--with", file], capture_output=True, text=True,
                          check=False)
    assert done.returncode == 3 and said in done.stderr and done.stderr.count("\n") == 1, done.stderr


def test_inputs_end_with_a_function_that_raises():
    kept = []

    @mes.structure()
    def keeper(delaunay):
        if len(delaunay.sites.rows):
            kept.append(delaunay)
            raise LookupError("no")
        return {}

    session = mes.Session(flower_points(20), experiments=[keeper])
    with pytest.raises(mes.ComputationFailed):
        session.keeper.statistics
    with pytest.raises(RuntimeError, match="while the function is at work"):
        kept[0].sites.position


def test_a_function_that_reads_sessions():
    other = []

    @mes.structure()
    def inner(samples):
        if len(samples.samples.rows) == 0:
            return {"rows": {"length": np.zeros(0)}}
        session = other[0] if other else mes.Session(samples.samples.position[samples.samples.rows])
        return {"rows": {"length": [session.axis.length.sum()]}}

    session = mes.Session(flower_points(30), experiments=[inner])
    assert session.inner.rows.length[0] == session.axis.length.sum()
    other.append(session)  # the session that computes
    session.move(session.ids[0], (2, 2))
    with pytest.raises(mes.ComputationFailed, match="at work already"):
        session.inner.rows.length
    other.clear()
    session.move(session.ids[0], (3, 3))
    assert session.inner.rows.length[0] == session.axis.length.sum()


@pytest.mark.parametrize("work", [lambda: time.sleep(60),
                                  lambda: mes.Session(flower_points(10**6, 2)).digest("power-crust")])
def test_ctrl_c_stops_a_function(work):
    is_slow = [True]

    @mes.structure()
    def slow(samples):
        if is_slow[0] and len(samples.samples.rows):
            is_slow[0] = False
            timer.start()
            work()
        return {"count": len(samples.samples.rows)}

    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    session = mes.Session(flower_points(30), experiments=[slow])
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        session.slow.statistics
    assert time.monotonic() - begin < 10
    timer.join()
    assert session.slow.statistics == {"count": 30}


def test_ctrl_c_stops_a_layer():
    is_stopped = [True]

    @mes.layer(rows="delaunay/sites", kind="point")
    def marks(delaunay):
        if is_stopped[0] and len(delaunay.sites.rows):
            raise KeyboardInterrupt
        return delaunay.sites.position

    session = mes.Session(flower_points(30), experiments=[marks])
    with pytest.raises(KeyboardInterrupt):
        session.digest("marks")
    is_stopped[0] = False
    assert len(session.instances("marks", "point")) == 30


@pytest.mark.parametrize("more", [-1, 1])
def test_rows_of_another_table_are_as_many_as_there(more):
    @mes.structure(rows={"sites": "delaunay/sites"})
    def other(delaunay):
        count = len(delaunay.sites.position)
        return {"sites": {"x": np.zeros(count and count + more)}}

    with pytest.raises(mes.ComputationFailed, match=f"table sites has {5 + more} rows, and delaunay/sites has 5"):
        mes.Session(flower_points(5), experiments=[other]).other.sites.x


@pytest.mark.parametrize("values", [np.full(3, -1), np.full(3, 2**40)])
def test_numbers_that_a_column_does_not_hold(values):
    @mes.structure()
    def large(samples):
        return {"rows": {"x": values if len(samples.samples.rows) else np.zeros(0, dtype=int)}}

    with pytest.raises(mes.ComputationFailed, match="below 0 or above"):
        mes.Session(flower_points(5), experiments=[large]).large.rows.x


def test_inputs_are_copies_that_stay():
    kept = []

    @mes.structure()
    def keeper(delaunay):
        kept.append((delaunay, delaunay.sites.position))
        return {}

    session = mes.Session(flower_points(20), experiments=[keeper])
    session.structure("keeper").statistics
    tables, places = kept[-1]
    before = places.copy()
    session.move(session.ids[0], (3, 3))
    session.structure("keeper").statistics
    np.testing.assert_array_equal(places, before)
    with pytest.raises(RuntimeError, match="while the function is at work"):
        tables.sites.position


def test_those_of_a_session_reach_the_program_of_its_window(tmp_path, program):
    pytest.importorskip("cloudpickle")
    factor = 3.0

    @mes.structure()
    def enlarged(samples):
        """Samples farther from the origin."""
        return {"points": {"place": factor * samples.samples.position[samples.samples.rows]}}

    @mes.layer(inputs=["enlarged"], rows="enlarged/points", kind="disk")
    def enlarged_disks(given):
        """Disks around them, as large as the text of a function that is no global name."""
        return np.column_stack([given.points.place, np.full(len(given.points.place), len(enlarged.description))])

    session = mes.Session([[0, 0], [1, 0], [5, 2]], experiments=[enlarged, enlarged_disks])
    [file] = _files_of(session.experiments, tmp_path)
    session.save(tmp_path / "points.poff")
    said = json.loads(program("compute", tmp_path / "points.poff", "--with", file, "--layers", "enlarged-disks", "--digest"))
    assert said["layers"]["enlarged-disks"]["digest"] == session.digest("enlarged-disks")
    # Those of a file that is named are there once.
    assert _files_of([own.middle, own.__file__], tmp_path) == [own.__file__]
