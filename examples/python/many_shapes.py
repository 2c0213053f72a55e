# SPDX-License-Identifier: GPL-3.0-or-later
"""The branches of the axes of many outlines, as one table, on a cluster of Dask.

    python3 many_shapes.py FOLDER branches.csv                      # two workers on this machine
    python3 many_shapes.py FOLDER branches.csv --scheduler HOST:PORT # a cluster that runs already
    python3 many_shapes.py --make 1000 FOLDER                       # outlines to try it with

Each outline's rows are written as soon as they are there. A second start leaves out what the table has, so that nothing is
lost when a machine goes down; an outline that fails is named in `branches.csv.failed`, and tried again next time.
"""
import argparse
import csv
import pathlib
import sys

import numpy as np

import mesecina as mes


COLUMNS = ("outline", "light", "branch", "from", "to", "edges", "length", "radius_least", "radius_mean",
           "radius_largest", "lambda", "angle")


def branches_of(path):
    """The rows of one outline: its name, the light of its certificate, and the measures of each branch of its axis."""
    session = mes.open(path)
    light = session.certificate.light
    return [(pathlib.Path(path).stem, light, *(one[name].item() for name in COLUMNS[2:])) for one in session.branches()]


def run(folder, table, executor, show=print):
    files = sorted(pathlib.Path(folder).glob("*.poff"))
    table = pathlib.Path(table)
    known = set()
    if table.exists():
        with table.open(newline="") as file:
            known = {row["outline"] for row in csv.DictReader(file)}
    left = [str(one) for one in files if one.stem not in known]
    failed = []
    with table.open("a", newline="") as file:
        rows = csv.writer(file)
        if not known and file.tell() == 0:
            rows.writerow(COLUMNS)
        for done, result in enumerate(mes.map(branches_of, left, executor), start=1):
            if result.error is None:
                rows.writerows(result.value)
                file.flush()
            else:
                failed.append(f"{result.item}: {result.error}")
            if done % max(1, len(left) // 20) == 0 or done == len(left):
                show(f"{done} of {len(left)} outlines, {len(failed)} failed")
    pathlib.Path(f"{table}.failed").write_text("".join(f"{one}\n" for one in failed))
    return failed


def make(count, folder):
    """Outlines of random flowers, and their files."""
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    for seed in range(count):
        random = np.random.default_rng(seed)
        angle = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
        radius = 1 + sum(random.uniform(0, 0.25) / k * np.cos(k * angle + random.uniform(0, 6)) for k in range(2, 9))
        points = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
        mes.Session(points, contours=[range(len(points))]).save(pathlib.Path(folder) / f"flower{seed:04}.poff")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder")
    parser.add_argument("table", nargs="?", default="branches.csv")
    parser.add_argument("--make", type=int, metavar="N", help="write N outlines to the folder instead")
    parser.add_argument("--scheduler", help="address of a scheduler of Dask; default: workers on this machine")
    parser.add_argument("--workers", type=int, default=2)
    given = parser.parse_args()
    if given.make:
        return make(given.make, given.folder)
    from distributed import Client, LocalCluster

    if given.scheduler:
        client = Client(given.scheduler)
    else:
        client = Client(LocalCluster(n_workers=given.workers, threads_per_worker=1, dashboard_address=None))
    with client, client.get_executor() as executor:
        failed = run(given.folder, given.table, executor)
    return f"{len(failed)} outlines failed; see {given.table}.failed" if failed else None


if __name__ == "__main__":
    sys.exit(main())
