# SPDX-License-Identifier: GPL-3.0-or-later
"""A moving curve and its axis, as an animation."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.collections import LineCollection

import mesecina as mes

angle = np.linspace(0, 2 * np.pi, 300, endpoint=False)


def curve(phase):
    radius = 1 + 0.25 * np.cos(3 * angle + phase) + 0.12 * np.sin(5 * angle - 2 * phase)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])


session = mes.Session(curve(0.0), history=False)
ids = session.ids
figure, ax = plt.subplots(figsize=(4, 4), layout="constrained")
outline, = ax.fill(*session.points.T, facecolor="#e8eef4", edgecolor="#30506f")
lines = ax.add_collection(LineCollection([], colors="#d55e00", linewidths=1.8))
ax.set(xlim=(-1.5, 1.5), ylim=(-1.5, 1.5), aspect="equal")
ax.set_axis_off()


def frame(phase):
    session.move(ids, curve(phase))
    axis = session.axis
    outline.set_xy(session.points)
    lines.set_segments(axis.points[axis.edges[axis.lambda_ > 0.08]])
    return outline, lines


animation = FuncAnimation(figure, frame, frames=np.linspace(0, 2 * np.pi, 40, endpoint=False))
animation.save("moving_curve.gif", writer=PillowWriter(fps=20))
figure.savefig("moving_curve.png", dpi=120)
