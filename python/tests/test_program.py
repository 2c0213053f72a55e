# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures, and commands of the program on a session."""
import numpy as np
import pytest

import mesecina as mes
from conftest import SHAPES
from mesecina import _program


def test_pictures(flower, tmp_path):
    picture = flower.render(layers=["curve", "medial-axis"], width=200)
    assert picture._repr_png_()[:4] == b"\x89PNG" and picture._repr_svg_() is None
    assert int.from_bytes(picture.data[16:20], "big") == 200 and int.from_bytes(picture.data[20:24], "big") == 150
    picture.save(tmp_path / "a.png")
    assert (tmp_path / "a.png").read_bytes() == picture.data
    with pytest.raises(ValueError):
        picture.save(tmp_path / "a.svg")
    drawing = flower.render(["curve"], format="svg", view="0,0,1,1")
    assert "<svg" in drawing._repr_svg_() and drawing._repr_png_() is None
    with pytest.raises(ValueError, match="unknown layer"):
        flower.render(["none"])


def test_commands_see_the_session(flower):
    for one in flower.ids[:5]:
        flower.remove(one)
    flower.set("lambda-limit", 0.125)
    report = flower.compute(["points", "medial-axis"], digest=True)
    assert report["layers"]["medial-axis"]["digest"] == flower.digest("medial-axis")
    branches = flower.branches()
    assert branches["length"].sum() == pytest.approx(flower.axis.length.sum(), rel=1e-6)
    stations = flower.centerline(every=0.1, prune=0)
    assert (stations["width"] > 0).all() and (stations["line"] == 1).all()
    persistence = flower.persistence()
    assert persistence.dtype.names[0] and len(persistence) > 0
    sweep = flower.sweep("lambda-limit", 0.0, 0.5, 6, layers=["lambda-medial-axis"])
    assert len(sweep) == 7 and sweep.dtype.names[0] == "lambda-limit"


def test_tables_of_the_program():
    rows = _program.table(b'a,b,c,d\n1,2,,"x,y"\n2,,,z\n')
    assert rows.dtype.names == ("a", "b", "c", "d") and rows["a"].dtype == np.int64
    np.testing.assert_array_equal(rows["b"], [2.0, np.nan])
    assert np.isnan(rows["c"]).all() and list(rows["d"]) == ["x,y", "z"]
    assert len(_program.table(b"a,b\n")) == 0


def test_new_sessions(flower):
    assert len(flower.repair(epsilon=0.02)) > len(flower)
    assert len(flower.decimate()) <= len(flower)
    assert len(flower.evolve("smooth", 2)) == len(flower)
    lizard = mes.open(SHAPES / "lizard.poff")
    assert len(lizard.sample(rule="number", samples=50)) == 50
    assert lizard.export("medial-axis", "csv").count(b"\n") > 100
    assert len(mes.text("--help")) > 100
    with pytest.raises(ValueError):
        flower.evolve("none")
    with pytest.raises(ValueError):
        flower.repair(epsilon=-1)


def test_a_program_that_is_not_there(flower, monkeypatch):
    monkeypatch.setenv("MESECINA_PROGRAM", "/nowhere/mesecina")
    with pytest.raises(FileNotFoundError):
        flower.branches()


def test_plots():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    session = mes.open(SHAPES / "lizard.poff")
    figure, ax = pyplot.subplots()
    assert session.plot(ax) is ax
    figure.canvas.draw()
    low, high = session.points.min(axis=0), session.points.max(axis=0)
    np.testing.assert_array_less([ax.get_xlim()[0], ax.get_ylim()[0]], low)
    np.testing.assert_array_less(high, [ax.get_xlim()[1], ax.get_ylim()[1]])
    every = [one["id"] for one in mes.layers()]
    small = mes.Session(np.random.default_rng(2).uniform(size=(12, 2)), balls=[[0, 0, 1], [1, 1, 1]])
    small.plot(ax, layers=every)
    figure.canvas.draw()
    with pytest.raises(ValueError):
        session.plot(ax, layers=["none"])
    session.move(session.ids[0], (0, 0))  # the drawing keeps no view of the session
    assert session.axis
    pyplot.close(figure)
