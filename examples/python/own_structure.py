# SPDX-License-Identifier: GPL-3.0-or-later
"""A structure of one's own: the relative neighbourhood graph, beside the Delaunay triangulation that contains it.

An edge is in the graph if no third sample is nearer to both ends than they are to each other (G. Toussaint, The relative
neighbourhood graph of a finite planar set, Pattern Recognition 12, 1980). Lengths are compared as doubles here; a
structure in C++ has exact predicates.
"""
import matplotlib.pyplot as plt
import numpy as np

import mesecina as mes


@mes.structure(rows={"edges": "delaunay/edges"})
def relative_neighbours(delaunay, slack=0.0):
    """Delaunay edges that no third sample is nearer to than their length."""
    rows, ends = delaunay.edges.rows, delaunay.edges.sites
    place = delaunay.sites.position
    is_kept = np.zeros(len(ends), dtype=bool)
    live = place[delaunay.sites.rows]
    for row in rows:
        a, b = place[ends[row]]
        length = np.hypot(*(a - b)) * (1 - slack)
        nearer = np.maximum(np.hypot(*(live - a).T), np.hypot(*(live - b).T)) < length
        is_kept[row] = not nearer.any()
    return {"edges": {"is_kept": is_kept}, "kept_edges": int(is_kept.sum())}


@mes.layer(rows="relative-neighbours/edges", kind="segment", color=(0.84, 0.37, 0), line_width=3)
def relative_neighbour_edges(relative_neighbours, delaunay):
    """The relative neighbourhood graph"""
    lines = delaunay.sites.position[delaunay.edges.sites].reshape(-1, 4)
    lines[~relative_neighbours.edges.is_kept] = np.nan
    return lines


if __name__ == "__main__":
    points = np.random.default_rng(8).uniform(size=(250, 2))
    session = mes.Session(points, experiments=[relative_neighbours, relative_neighbour_edges])
    print(session.statistics("relative-neighbours"))
    figure, ax = plt.subplots(figsize=(5, 5), layout="constrained")
    session.plot(ax, layers=["delaunay", "relative-neighbour-edges", "points"])
    figure.savefig("own_structure.png", dpi=120)
