# SPDX-License-Identifier: GPL-3.0-or-later
"""Results equal those of the program, bit for bit, after any edits."""
import io
import json
import os
import pickle

import numpy as np
import pytest

import mesecina as mes
from conftest import SHAPES, flower_points


@pytest.mark.parametrize("shape", ["lizard", "eccentric-ring", "broken-ring"])
def test_digests_are_those_of_compute(shape, program):
    path = SHAPES / f"{shape}.poff"
    session = mes.open(path)
    layers = [one["id"] for one in mes.layers()]
    report = json.loads(program("compute", path, "--layers", ",".join(layers), "--digest", "--no-timing"))
    compared = 0
    for layer in layers:
        entry = report["layers"][layer]
        if "digest" in entry:
            assert session.digest(layer) == entry["digest"], layer
            compared += 1
    assert compared > 150


def test_tables_are_those_of_export(program):
    path = SHAPES / "bean.poff"
    session = mes.open(path)
    for structure in ("delaunay", "one-step-crust", "inner-balls", "medial-axis", "lambda-axis", "a-union"):
        for name in session.structure(structure).tables:
            data = program("export", path, "--structure", structure, "--table", name, "--format", "npy")
            exported = np.load(io.BytesIO(data))
            table = session.structure(structure)[name]
            rows = table.rows
            for column in table.columns:
                np.testing.assert_array_equal(table[column][rows], exported[column][rows], f"{structure}/{name}/{column}")


def test_statistics_are_those_of_compute(program):
    path = SHAPES / "trefoil.poff"
    report = json.loads(program("compute", path, "--layers", "medial-axis", "--no-timing"))
    session = mes.open(path)
    # The report leaves out values that JSON does not have.
    for structure, entry in report["structures"].items():
        for key, value in session.statistics(structure).items():
            if key in entry:
                assert entry[key] == value, (structure, key)
    assert session.statistics("medial-axis")["length"] == report["structures"]["medial-axis"]["length"]


def test_the_axis_of_an_annulus_is_a_circle():
    angle = np.linspace(0.0, 2.0 * np.pi, 400, endpoint=False)
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    axis = mes.Session(np.concatenate([circle, 2.0 * circle])).axis
    np.testing.assert_allclose(np.hypot(*axis.points.T), 1.5, atol=2e-4)
    np.testing.assert_allclose(axis.radius, 0.5, atol=2e-4)
    assert (axis.degree == 2).all()
    assert axis.length.sum() == pytest.approx(3.0 * np.pi, rel=1e-4)
    ends = axis.points[axis.edges]
    np.testing.assert_allclose(np.hypot(*(ends[:, 0] - ends[:, 1]).T), axis.length, atol=1e-12)


def test_the_samples_of_an_axis_edge_are_the_nearest(flower):
    axis = flower.axis
    positions = dict(zip(flower.ids.tolist(), flower.points))
    middle = axis.points[axis.edges].mean(axis=1)
    for place, (a, b) in zip(middle, axis.samples.tolist()):
        nearest = np.hypot(*(flower.points - place).T).min()
        for one in (a, b):
            assert np.hypot(*(positions[one] - place)) == pytest.approx(nearest)
    assert (axis.lambda_ > 0).all() and (axis.angle <= 180).all()


def test_an_axis_stays_when_the_session_changes(flower):
    axis = flower.axis
    before = axis.points.copy()
    flower.move(flower.ids[0], (0.9, 0.1))
    with pytest.raises(ValueError, match="has changed"):
        axis.lambda_
    assert flower.axis is not axis and flower.axis is flower.axis
    np.testing.assert_array_equal(axis.points, before)
    with pytest.raises(ValueError):
        axis.points[0, 0] = 1.0


def test_an_axis_is_pickled_without_its_session(flower):
    axis = flower.axis
    other = pickle.loads(pickle.dumps(axis))
    for name in ("points", "radius", "edges", "length", "samples", "lambda_", "angle"):
        np.testing.assert_array_equal(getattr(other, name), getattr(axis, name))
        assert not getattr(other, name).flags.writeable
    flower.move(flower.ids[0], (0.9, 0.1))
    late = pickle.loads(pickle.dumps(axis))
    np.testing.assert_array_equal(late.lambda_, axis.lambda_)


def test_edits_give_what_a_fresh_session_has():
    """Tables that are followed by their changed rows, and digests, against a computation from scratch."""
    random = np.random.default_rng(5)
    session = mes.Session(flower_points(300))
    columns = ("circumcenter", "sites", "is_finite")
    kept = {name: session.delaunay.faces[name].copy() for name in columns}
    for step in range(int(os.environ.get("MESECINA_EDITS", "2000"))):
        kind = random.integers(4)
        ids = session.ids
        if kind == 0 and len(ids) < 400:
            session.insert(random.uniform(-1.5, 1.5, (random.integers(1, 4), 2)))
        elif kind == 1 and len(ids) > 200:
            session.remove(random.choice(ids, 2, replace=False))
        elif kind == 2:
            session.move(random.choice(ids), random.uniform(-1.5, 1.5, 2))
        elif not session.undo():
            session.insert([0.1, 0.2])
        faces = session.delaunay.faces
        changed = faces.changed
        for name in columns:
            now = faces[name]
            if changed is None:
                kept[name] = now.copy()
                continue
            grown = np.empty_like(now)
            common = min(len(now), len(kept[name]))
            grown[:common] = kept[name][:common]
            changed_here = changed[changed < len(now)]
            grown[changed_here] = now[changed_here]
            kept[name] = grown
            rows = faces.rows
            np.testing.assert_array_equal(grown[rows], now[rows])
        del now
        if step % 100 == 0:
            fresh = mes.Session(session.points)
            for layer in ("delaunay", "curve", "medial-axis", "interior-voronoi-disks"):
                assert session.digest(layer) == fresh.digest(layer), (step, layer)


def test_settings_and_the_certificate():
    session = mes.open(SHAPES / "lizard.poff")
    assert session.certificate.is_proved and session.certificate.reasons == []
    session.set("precision", "exact")
    assert session.value("precision") == "exact" and session.certificate.light == "green"
    session.set("lambda-limit", 2.5)
    assert session.value("lambda-limit") == 2.5
    kept = session.lambda_axis.edges
    rows = kept.rows
    assert ((kept["lambda"][rows] >= 2.5) | ~kept.is_kept[rows]).all()
    noise = mes.Session(np.random.default_rng(1).uniform(size=(50, 2)))
    assert not noise.certificate.is_proved and noise.certificate.reasons
    assert mes.Session().certificate.light == "none"


@pytest.mark.parametrize("points", [[], [[0, 0]], [[0, 0], [1, 1]], [[0, 0], [1, 1], [2, 2]], [[1, 1]] * 5])
def test_few_samples(points):
    session = mes.Session(points)
    assert len(session) == len(points) and session
    assert len(session.axis.points) == 0 and session.axis.edges.shape == (0, 2)
    for structure in mes.structures():
        for table in structure["tables"]:
            one = session.structure(structure["id"])[table["name"]]
            assert len(one.compact()) == len(one)


def test_tables_as_frames(flower):
    pandas = pytest.importorskip("pandas")
    frame = flower.delaunay.sites.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    assert list(frame.columns) == ["position_x", "position_y", "sample", "face"] and len(frame) == 240
    np.testing.assert_array_equal(np.asarray(flower.delaunay.sites)["position"], frame[["position_x", "position_y"]])


def test_the_axis_as_a_graph_and_a_geometry():
    networkx = pytest.importorskip("networkx")
    axis = mes.open(SHAPES / "lizard.poff").axis
    graph = axis.to_networkx()
    assert networkx.is_connected(graph) and graph.number_of_edges() == len(axis.edges)
    assert sum(length for *_, length in graph.edges.data("length")) == pytest.approx(axis.length.sum())
    assert graph.nodes[3]["radius"] == axis.radius[3]
    shapely = pytest.importorskip("shapely.geometry")
    assert shapely.shape(axis).length == pytest.approx(axis.length.sum())
