# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers on axes of matplotlib, as vectors."""
import numpy as np


def plot(session, ax, layers):
    """Draws layers on the axes, bottom first, in their default style. See `Session.plot`."""
    known = {one["id"]: one for one in session.catalogue.layers()}
    if isinstance(layers, str):
        layers = layers.split(",")
    for order, layer in enumerate(layers):
        if layer not in known:
            raise ValueError(f"unknown layer {layer}")
        style = known[layer]
        for kind in style["kinds"]:
            values = np.array(session._bench.instances(layer, kind))  # the drawing outlives the next edit
            if len(values):
                _draw(ax, kind, values[:, :-1], style, order)
    ax.set_aspect("equal")
    ax.autoscale_view()
    return ax


def _draw(ax, kind, values, style, order):
    from matplotlib.collections import EllipseCollection, LineCollection, PolyCollection

    color = style["color"]
    # A pixel of a screen is three quarters of a point on paper.
    common = {"alpha": style["opacity"], "zorder": 2 + 0.01 * order}
    width = 0.75 * style["line_width"]
    if kind == "point":
        ax.scatter(values[:, 0], values[:, 1], s=(0.75 * style["point_size"]) ** 2, color=[color], linewidths=0, **common)
    elif kind == "segment":
        ax.add_collection(LineCollection(values.reshape(-1, 2, 2), colors=[color], linewidths=width, capstyle="round",
                                         **common))
    elif kind == "triangle":
        ax.add_collection(PolyCollection(values.reshape(-1, 3, 2), facecolors=[color], linewidths=0, **common))
    elif kind in ("disk", "circle"):
        sizes = 2.0 * values[:, 2]
        ax.add_collection(EllipseCollection(
            sizes, sizes, np.zeros(len(sizes)), units="xy", offsets=values[:, :2], transOffset=ax.transData,
            facecolors=[color] if kind == "disk" else "none", edgecolors="none" if kind == "disk" else [color],
            linewidths=0 if kind == "disk" else width, **common))
        reach = values[:, 2:3]
        ax.update_datalim(np.concatenate([values[:, :2] - reach, values[:, :2] + reach]))
    elif kind == "arc":
        ax.add_collection(LineCollection([_arc(*one) for one in values], colors=[color], linewidths=width, **common))
    elif kind == "parabola":
        ax.add_collection(LineCollection([_parabola(*one) for one in values], colors=[color], linewidths=width, **common))
    elif kind in ("ray", "line"):
        for x, y, dx, dy in values:
            if kind == "line":
                ax.axline((x, y), (x + dx, y + dy), color=color, linewidth=width, **common)
            else:
                _ray(ax, (x, y), (dx, dy), color=color, linewidth=width, **common)


def _arc(x, y, radius, x1, y1, x2, y2):
    """Points along the arc, counter-clockwise; a chord is never longer than two degrees."""
    begin = np.arctan2(y1 - y, x1 - x)
    turn = (np.arctan2(y2 - y, x2 - x) - begin) % (2.0 * np.pi)
    if (x1, y1) == (x2, y2):
        turn = 2.0 * np.pi
    angles = begin + np.linspace(0.0, turn, max(2, int(np.ceil(np.degrees(turn) / 2.0)) + 1))
    return np.column_stack([x + radius * np.cos(angles), y + radius * np.sin(angles)])


def _parabola(x1, y1, x, y, x2, y2):
    """Points along the quadratic Bezier curve."""
    t = np.linspace(0.0, 1.0, 65)[:, None]
    return (1.0 - t) ** 2 * [[x1, y1]] + 2.0 * t * (1.0 - t) * [[x, y]] + t**2 * [[x2, y2]]


def _ray(ax, begin, direction, **style):
    """A ray ends at the extent of the data, and does not widen it."""
    low, high = np.array(ax.dataLim.min), np.array(ax.dataLim.max)
    reach = float(np.hypot(*(high - low))) if np.isfinite([low, high]).all() else 1.0
    unit = np.array(direction) / np.hypot(*direction)
    end = np.array(begin) + (reach or 1.0) * unit
    limits = ax.dataLim.frozen()
    ax.plot([begin[0], end[0]], [begin[1], end[1]], **style)
    ax.dataLim.set(limits)
