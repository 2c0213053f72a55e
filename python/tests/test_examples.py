# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples and the notebook run without warnings and draw their figures."""
import concurrent.futures
import csv
import importlib.util
import json
import multiprocessing
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import mesecina as mes
from conftest import ROOT

EXAMPLES = ROOT / "examples" / "python"
FIGURES = sorted(one for one in EXAMPLES.glob("*.py") if one.stem != "many_shapes")


def test_there_are_eleven():
    assert len(FIGURES) == 11


@pytest.mark.parametrize("example", FIGURES, ids=lambda one: one.stem)
def test_an_example_draws_its_figure(example, tmp_path):
    done = subprocess.run([sys.executable, "-W", "error::RuntimeWarning", example], cwd=tmp_path, capture_output=True,
                          text=True, check=False)
    assert done.returncode == 0 and not done.stderr, done.stderr
    from matplotlib import image

    pixels = image.imread(tmp_path / f"{example.stem}.png")[..., :3]
    is_drawn = (pixels < 0.95).any(axis=2)
    assert 0.01 < is_drawn.mean() < 0.9
    # The drawing fills the picture, not only a corner.
    assert is_drawn.any(axis=0).mean() > 0.5 and is_drawn.any(axis=1).mean() > 0.5


def test_a_carved_letter_stays_in_its_outline(tmp_path):
    geometry = pytest.importorskip("shapely.geometry")
    subprocess.run([sys.executable, EXAMPLES / "v_carve.py"], cwd=tmp_path, capture_output=True, check=True)
    letters = mes.text("Vela", font="DejaVu Serif", size=40, spacing=0.25)
    border = geometry.MultiLineString([np.vstack([letters.points[one], letters.points[one[:1]]])
                                       for one in letters.contours])
    cut, at, is_down = [], np.zeros(3), False
    for line in (tmp_path / "v_carve.ngc").read_text().splitlines()[1:-1]:
        to = at.copy()
        for word in line.split()[1:]:
            if word[0] in "XYZ":
                to["XYZ".index(word[0])] = float(word[1:])
        if line.startswith("G0"):
            # The bit only travels above the material, and straight up or down elsewhere.
            assert (at[2] > 0 and to[2] > 0) or (at[:2] == to[:2]).all()
        elif at[2] < 0:
            cut.append((at[:2], to[:2]))
        if to[2] < 0:
            # The cone of 60 degrees touches samples; the border between two of them is half a spacing away from each.
            wide = -to[2] * np.tan(np.radians(30))
            near = border.distance(geometry.Point(to[:2]))
            rounded = 0.001  # mm
            assert near < wide + rounded and wide**2 - near**2 < (0.25 / 2) ** 2 + 2 * wide * rounded
        at = to
    # Each edge of the axis is cut once.
    axis = letters.axis
    length = sum(np.linalg.norm(to - of) for of, to in cut)
    assert len(cut) == len(axis.edges)
    assert abs(length - np.linalg.norm(np.diff(axis.points[axis.edges], axis=1)[:, 0], axis=1).sum()) < 0.1


def test_the_notebook(tmp_path):
    pytest.importorskip("nbconvert")
    subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir", tmp_path,
                    "--ExecutePreprocessor.startup_timeout=600", "--ExecutePreprocessor.timeout=600",
                    EXAMPLES / "first_steps.ipynb"], check=True, capture_output=True,
                   env={name: value for name, value in os.environ.items() if name != "MPLBACKEND"})  # the notebook has its own
    cells = json.loads((tmp_path / "first_steps.ipynb").read_text())["cells"]
    outputs = [one for cell in cells for one in cell.get("outputs", [])]
    assert not any(one["output_type"] == "error" for one in outputs)
    assert sum("image/png" in one.get("data", {}) for one in outputs) == 3


def many_shapes():
    spec = importlib.util.spec_from_file_location("many_shapes", EXAMPLES / "many_shapes.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["many_shapes"] = module
    spec.loader.exec_module(module)
    return module


def test_many_shapes_on_a_cluster(tmp_path, monkeypatch):
    distributed = pytest.importorskip("distributed")
    # Workers of a busy machine take their time to start.
    import dask

    dask.config.set({"distributed.comm.timeouts.connect": "600s"})
    monkeypatch.syspath_prepend(str(EXAMPLES))
    monkeypatch.setenv("PYTHONPATH", f"{EXAMPLES}:{pathlib.Path(mes.__file__).parent.parent}")
    module = many_shapes()
    module.make(12, tmp_path / "shapes")
    (tmp_path / "shapes" / "broken.poff").write_text("POFF 1 0 0\nx 0\n")
    table = tmp_path / "table.csv"
    said = []
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, \
            distributed.Client(cluster) as client:
        failed = module.run(tmp_path / "shapes", table, client.get_executor(), said.append)
    assert len(failed) == 1 and "broken.poff" in failed[0] and "broken.poff" in (tmp_path / "table.csv.failed").read_text()
    assert said[-1] == "13 of 13 outlines, 1 failed"
    rows = list(csv.DictReader(table.open()))
    assert {one["outline"] for one in rows} == {f"flower{i:04}" for i in range(12)}
    # A second start, without the cluster, keeps the rows of an interrupted run and adds the others.
    first = {one["outline"] for one in rows[: len(rows) // 2]} - {rows[len(rows) // 2]["outline"]}
    with table.open("w", newline="") as file:
        writer = csv.DictWriter(file, module.COLUMNS)
        writer.writeheader()
        writer.writerows(one for one in rows if one["outline"] in first)
    (tmp_path / "shapes" / "broken.poff").unlink()
    assert module.run(tmp_path / "shapes", table, None, said.append) == []
    assert said[-1] == f"{12 - len(first)} of {12 - len(first)} outlines, 0 failed"

    def order(one):
        return one["outline"], int(one["branch"])

    assert sorted(csv.DictReader(table.open()), key=order) == sorted(rows, key=order)


def length_of(seed):
    if seed == 3:
        raise LookupError("three")
    random = np.random.default_rng(seed)
    return mes.Session(random.uniform(size=(200, 2))).axis.length.sum()


@pytest.mark.parametrize("executor", [lambda: None, lambda: concurrent.futures.ThreadPoolExecutor(2),
                                      lambda: concurrent.futures.ProcessPoolExecutor(
                                          2, mp_context=multiprocessing.get_context("spawn"))])
def test_map(executor):
    pool = executor()
    results = {one.item: one for one in mes.map(length_of, range(6), pool)}
    if pool is not None:
        pool.shutdown()
    assert sorted(results) == list(range(6))
    assert isinstance(results[3].error, LookupError) and results[3].value is None
    assert all(results[one].error is None and results[one].value == length_of(one) for one in (0, 1, 2, 4, 5))
    assert list(mes.map(length_of, [])) == []
