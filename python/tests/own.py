# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures, layers and an evolution in a module that other processes can import."""
import math
from typing import Annotated

import numpy as np

import mesecina as mes


@mes.structure(rows={"edges": "delaunay/edges"})
def long_edges(delaunay, limit: Annotated[float, (0, 1000), "Longer edges are long"] = 0.5):
    """Edges that are longer than a limit."""
    ends = delaunay.sites.position[delaunay.edges.sites]
    length = np.hypot(*(ends[:, 0] - ends[:, 1]).T)
    rows = delaunay.edges.rows
    return {"edges": {"is_long": length > limit, "length": length}, "longest": length[rows].max(initial=0.0),
            "count": int((length[rows] > limit).sum())}


@mes.layer(rows="long-edges/edges", kind="segment", scalar="length", color=(0, 0.5, 1))
def long_edge_lines(long_edges, delaunay):
    """Edges that are longer than a limit."""
    lines = np.column_stack([delaunay.sites.position[delaunay.edges.sites].reshape(-1, 4), long_edges.edges.length])
    lines[~long_edges.edges.is_long] = np.nan
    return lines


@mes.structure()
def middle(samples):
    """The mean of the samples."""
    places = samples.samples.position[samples.samples.rows]
    count = len(places)
    # This sum does not depend on the order of the samples.
    mean = [[math.fsum(places[:, i]) / count for i in range(2)]] if count else np.empty((0, 2))
    return {"points": {"place": mean, "alive": np.ones(len(mean), dtype=bool)}}


@mes.layer(rows="middle/points", kind="disk", name="The middle")
def middle_disk(middle, radius=0.25):
    """A disk about the mean of the samples."""
    place = middle.points.place
    return np.column_stack([place, np.full(len(place), radius)])


@mes.evolution()
def shrink(points, curves, step, factor: Annotated[float, (0, 1)] = 0.5):
    """Samples come nearer to their mean."""
    return points if len(points) == 0 else points.mean(axis=0) + factor * (points - points.mean(axis=0))
