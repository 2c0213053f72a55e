# SPDX-License-Identifier: GPL-3.0-or-later
"""Input is read or refused with one line: arrays, files, polygons, images and pickles."""
import copy
import fractions
import os
import pickle
import subprocess
import sys
import warnings

import numpy as np
import pytest

import mesecina as mes
from conftest import ROOT, SHAPES, flower_points


@pytest.mark.parametrize("points", [
    [(0, 0), (1, 2)], np.array([[0, 0], [1, 2]], dtype=np.int8), np.array([[0, 0], [1, 2]], dtype=np.float32),
    np.asfortranarray([[0.0, 0.0], [1.0, 2.0]]), np.array([[0.0, 9, 0], [1.0, 9, 2]])[:, ::2],
    [(fractions.Fraction(0), 0), (1, fractions.Fraction(2))]])
def test_arrays_of_any_kind(points):
    np.testing.assert_array_equal(mes.Session(points).points, [[0, 0], [1, 2]])


@pytest.mark.parametrize("points, error, text", [
    ([[1, 2, 3]], ValueError, r"shape \(n, 2\)"), ([1.0, 2.0, 3.0], ValueError, "shape"), (3.0, ValueError, "shape"),
    ([[[0, 0]]], ValueError, "shape"), ([[0, 1], [2, float("nan")]], ValueError, "row 1 is not finite"),
    ([[float("inf"), 0]], ValueError, "not finite"), ("points", TypeError, "numbers"), ([["a", "b"]], TypeError, "numbers"),
    (np.zeros((2, 2), dtype=complex), TypeError, "complex"), (np.zeros((2, 2), dtype=bool), TypeError, "bool"),
    (np.array([[2**60 + 1, 0]]), ValueError, "not exact as doubles"), ([[2.0**600, 0]], ValueError, "2\\^500"),
    ([[1e-200, 1e200]], ValueError, ""), (np.ma.array(np.zeros((2, 2)), mask=np.eye(2)), ValueError, "masked"),
    ([[2**70 + 1, 0]], ValueError, "not exact as doubles"), ([[10**400, 0]], ValueError, "not exact as doubles"),
    (object(), TypeError, ""), ([[0, 0], [1]], ValueError, "")])
def test_arrays_that_are_refused(points, error, text):
    with pytest.raises(error, match=text) as caught:
        mes.Session(points)
    assert "\n" not in str(caught.value)
    session = mes.Session(flower_points(10))
    with pytest.raises(error):
        session.insert(points)
    assert len(session) == 10


@pytest.mark.parametrize("ids, error", [(99, ValueError), (-1, ValueError), (2**40, ValueError), ([0, 0], ValueError),
                                        ([0.5], TypeError), ("a", TypeError), (True, TypeError),
                                        (np.True_, TypeError), (np.ma.array([1, 2], mask=[0, 1]), ValueError),
                                        ([[0]], ValueError)])
def test_ids_that_are_refused(ids, error):
    session = mes.Session(flower_points(10))
    for work in (session.remove, lambda one: session.move(one, np.zeros((np.size(one), 2))
                                                          if np.ndim(one) else (0.0, 0.0))):
        with pytest.raises(error):
            work(ids)
    np.testing.assert_array_equal(session.points, flower_points(10))
    session.remove([])
    session.move([], [])
    assert len(session.insert([])) == 0


def test_steps_of_undo():
    session = mes.Session([[0, 0]])
    assert not session.undo()
    with session.edit("Three"):
        ids = session.insert([[1, 1], [2, 2]])
        session.move(ids[0], (5, 5))
    assert session.insert((3, 3)) not in ids
    assert session.undo() and session.undo() and not session.undo()
    np.testing.assert_array_equal(session.points, [[0, 0]])
    assert session.redo()
    np.testing.assert_array_equal(session.points, [[0, 0], [5, 5], [2, 2]])
    np.testing.assert_array_equal(session.ids[1:], ids)
    with pytest.raises(ZeroDivisionError), session.edit():
        session.remove(ids[0])
        1 / 0
    assert len(session) == 2 and session.undo() and len(session) == 3


def test_balls_and_contours():
    session = mes.Session(flower_points(6), balls=[[0, 0, 1], [1, 0, 0.5]], contours=[[0, 1, 2], ([3, 4, 5], False)])
    assert [(list(indices), is_closed) for indices, is_closed in session.contours] == [([0, 1, 2], True),
                                                                                       ([3, 4, 5], False)]
    ids = session.ball_ids
    session.change_balls(ids[:1], [[2, 2, 2]])
    session.remove_balls(ids[1])
    new = session.insert_balls([[7, 7, 7]])
    np.testing.assert_array_equal(session.balls, [[2, 2, 2], [7, 7, 7]])
    np.testing.assert_array_equal(session.ball_ids, [ids[0], new[0]])
    with pytest.raises(ValueError):
        session.insert_balls([[0, 0, -1]])
    with pytest.raises(ValueError):
        mes.Session([[0, 0]], contours=[[0, 1]])


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one)),
                                   mes.Session.copy])
def test_copies(again):
    session = mes.open(SHAPES / "eccentric-ring.poff")
    session.set("lambda-limit", 0.25)
    session.set("precision", "exact")
    other = again(session)
    assert other.digest("medial-axis") == session.digest("medial-axis")
    assert other.value("lambda-limit") == 0.25 and other.value("precision") == "exact"
    np.testing.assert_array_equal(other.points, session.points)
    other.remove(other.ids[0])
    assert len(session) == len(other) + 1


def test_contours_are_set_and_taken_back(flower):
    flower.contours = [range(20), ([30, 40, 50], False)]
    assert [(indices.tolist(), is_closed) for indices, is_closed in flower.contours] == [
        (list(range(20)), True), ([30, 40, 50], False)]
    with pytest.raises(ValueError, match="does not exist"):
        flower.contours = [[0, 240]]
    assert len(flower.contours) == 2
    flower.remove(flower.ids[:19])
    assert [indices.tolist() for indices, _ in flower.contours] == [[0], [11, 21, 31]]
    flower.contours = []
    assert flower.contours == [] and flower.undo() and len(flower.contours) == 2
    assert flower.undo() and flower.undo() and flower.contours == []


def test_a_format_that_loses_data_is_warned_of(tmp_path):
    session = mes.Session([[0, 0], [1, 0]], balls=[[0, 0, 1]])
    with pytest.warns(UserWarning, match="no place for the balls"):
        session.save(tmp_path / "a.poff")
    with pytest.warns(UserWarning, match="no place for the samples"):
        session.save(tmp_path / "a", format="wpoff")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        session.save(tmp_path / "a.json")
        mes.Session([[0, 0]]).save(tmp_path / "b.poff")


def test_copies_keep_no_history_where_the_session_does_not():
    for session in (mes.Session([[0, 0]], history=False), mes.Session([[0, 0]])):
        for one in (session.copy(), pickle.loads(pickle.dumps(session))):
            one.insert((1, 1))
            session.insert((1, 1))
            assert one.undo() is session.undo()


def test_a_pickle_of_another_version():
    function, (version, text, *_) = mes.Session([[0, 0]]).__reduce__()
    assert version == mes.version()
    with pytest.raises(ValueError, match="a session of version 9.9.9 cannot be read by version"):
        function("9.9.9", text.replace(b'"mesecina-session"', b'"other"') if b"mesecina-session" in text else b"{}")


def test_files(tmp_path):
    session = mes.open(SHAPES / "lizard.poff")
    for name in ("a.poff", "a.json"):
        session.save(tmp_path / name)
        np.testing.assert_array_equal(mes.open(tmp_path / name).points, session.points)
    with pytest.raises(ValueError, match="poff"):
        session.save(tmp_path / "a.txt")
    with pytest.raises(OSError):
        session.save(tmp_path / "none" / "a.poff")
    with pytest.raises(FileNotFoundError):
        mes.open(tmp_path / "none.poff")
    with pytest.raises(IsADirectoryError):
        mes.open(tmp_path)
    broken = tmp_path / "broken.poff"
    broken.write_text("POFF 2 0 0\n0 0\n1 x\n")
    with pytest.raises(mes.InputError) as caught:
        mes.open(broken)
    assert (caught.value.file, caught.value.line) == (str(broken), 3) and caught.value.column > 0
    assert pickle.loads(pickle.dumps(caught.value)).line == 3
    with pytest.raises(mes.InputError):
        mes.open(SHAPES / "lizard.poff", format="svg")
    with pytest.raises(ValueError):
        mes.open(SHAPES / "lizard.poff", format="nothing")


def test_names_of_files_that_are_no_text(tmp_path):
    session = mes.Session([[0, 0]])
    for path in (os.fsencode(tmp_path) + b"/\xff.poff", str(tmp_path / "\udcfe.poff")):
        session.save(path)
        assert len(mes.open(path)) == 1
    with pytest.raises(ValueError):
        session.save(tmp_path / "a\0.poff")
    assert sorted(os.listdir(tmp_path)) == ["\udcfe.poff", "\udcff.poff"]


def test_polygons():
    geometry = pytest.importorskip("shapely.geometry")
    ring = geometry.Polygon([(0, 0), (4, 0), (4, 2), (0, 2)], [[(1, 0.5), (3, 0.5), (3, 1.5), (1, 1.5)]])
    session = mes.Session.from_polygons(ring)
    assert len(session.contours) == 2 and len(session) > 100
    corners = mes.Session.from_polygons(ring, vertices=True)
    assert sorted(map(tuple, corners.points)) == sorted({*ring.exterior.coords, *ring.interiors[0].coords})
    # The axis of a frame runs around its hole.
    assert geometry.shape(session.axis).distance(geometry.Point(2, 1)) > 0.7
    box = {"type": "Polygon", "coordinates": [[[10, 0], [11, 0], [11, 1], [10, 1], [10, 0]]]}
    assert len(mes.Session.from_polygons(ring, box, geometry.box(20, 0, 21, 1)).contours) == 4
    assert len(mes.Session.from_polygons(ring.exterior, vertices=True)) == 4
    assert len(mes.Session.from_polygons(geometry.GeometryCollection([ring, ring.exterior]), vertices=True)) == 8
    line = {"type": "LineString", "coordinates": np.array([[0, 0], [1, 1]])}
    assert len(mes.Session.from_polygons(line, vertices=True)) == 2
    for empty in (geometry.Polygon(), geometry.GeometryCollection(), {"type": "FeatureCollection"}):
        with pytest.raises(ValueError):
            mes.Session.from_polygons(empty)
    for bad in ("polygon", 3, {"x": 1}):
        with pytest.raises(TypeError):
            mes.Session.from_polygons(bad)
    with pytest.raises(mes.InputError):
        mes.Session.from_polygons({"type": "Polygon", "coordinates": [[[0, 0], [float("nan"), 1], [1, 1]]]})


@pytest.mark.parametrize("as_image", [lambda mask: mask, lambda mask: np.where(mask, 10, 200),
                                      lambda mask: np.where(mask, 0.9, 0.1), lambda mask: mask * np.uint16(60000),
                                      lambda mask: np.where(mask, 1.7e308, -1.7e308), lambda mask: np.asfortranarray(mask)])
def test_images(as_image):
    mask = np.zeros((50, 70), dtype=bool)
    mask[10:30, 20:61] = True
    session = mes.Session.from_image(as_image(mask))
    assert len(session.contours) == 1
    np.testing.assert_allclose(session.points.min(axis=0), [19.5, 9.5], atol=1e-3)
    np.testing.assert_allclose(session.points.max(axis=0), [60.5, 29.5], atol=1e-3)
    # The axis of the rectangle has its middle line, which the image draws at row 19.5.
    assert np.abs(session.axis.points[:, 1] - 19.5).min() < 0.05
    whole = mes.Session.from_image(np.ones((20, 30), dtype=bool))
    np.testing.assert_allclose(whole.points.max(axis=0), [29.5, 19.5], atol=1e-3)
    assert whole.remarks
    with pytest.raises(ValueError, match="take one channel"):
        mes.Session.from_image(np.zeros((9, 9, 3)))
    for bad in (np.ma.array(mask, mask=mask), np.zeros((5, 5), dtype=bool), np.ones((1, 1), dtype=bool),
                np.zeros((0, 0)), [[float("nan")]]):
        with pytest.raises(ValueError):
            mes.Session.from_image(bad)
    with pytest.raises(TypeError):
        mes.Session.from_image([["a"]])


def test_shapes():
    ellipse = mes.shape("ellipse", samples=50)
    assert len(ellipse) == 50 and len(ellipse.contours) == 1
    np.testing.assert_array_equal(mes.shape("ellipse", samples=50).points, ellipse.points)
    for bad in (dict(name="none"), dict(name="ellipse", none=1), dict(name="ellipse", samples=5, spacing=1)):
        with pytest.raises(ValueError):
            mes.shape(**bad)
    for bad in (dict(samples=2.5), dict(seed="x"), dict(jitter=None), dict(a=[1])):
        with pytest.raises(TypeError) as caught:
            mes.shape("ellipse", **bad)
        assert "\n" not in str(caught.value)


def test_names_that_are_not_there():
    session = mes.Session()
    for work, error in [(lambda: session.none, AttributeError), (lambda: session.delaunay.none, AttributeError),
                        (lambda: session.delaunay.faces.none, AttributeError), (lambda: session.delaunay["none"], KeyError),
                        (lambda: session.delaunay.faces["none"], KeyError), (lambda: session.structure("none"), ValueError),
                        (lambda: session.set("none", 1), ValueError), (lambda: session.set("precision", "none"), ValueError),
                        (lambda: session.digest("none"), ValueError), (lambda: session.instances("curve", "x"), ValueError)]:
        with pytest.raises(error):
            work()
    for work in (lambda: session.set("lambda-limit", "1"), lambda: session.set(3, 1), lambda: session.set("precision", 1),
                 lambda: session.value(None), lambda: session.digest(None), lambda: session.instances("curve", None),
                 lambda: session.structure(None), lambda: session.changed[3], lambda: session.edit(3).__enter__(),
                 lambda: mes.open(SHAPES / "bean.poff", None), lambda: session.save("a.poff", 3)):
        with pytest.raises(TypeError) as caught:
            work()
        assert "\n" not in str(caught.value)
    assert "one_step_crust" in dir(session) and "faces" in dir(session.delaunay)
    assert "circumradius" in dir(session.delaunay.faces) and "circumradius" in repr(session.delaunay)
    assert not hasattr(session, "_repr_html_")


def test_without_numpy():
    code = "import sys; sys.modules['numpy'] = None; import mesecina"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == "ImportError: mesecina needs NumPy (on Debian: apt install python3-numpy)"


def test_a_coordinate_system_is_named(tmp_path):
    table = tmp_path / "house.txt"
    table.write_text("548200 5803100\n548212 5803100\n548212 5803108\n")
    with pytest.warns(UserWarning, match="ETRS89 / UTM zone 32N"):
        session = mes.open(table, crs="EPSG:25832")
    assert session.save(tmp_path / "a.poff") is None
    assert "# map metre of EPSG:25832" in (tmp_path / "a.poff").read_text()
    with pytest.raises(mes.InputError, match="PROJ knows"):
        mes.open(table, crs="EPSG:999999")
