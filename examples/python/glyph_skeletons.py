# SPDX-License-Identifier: GPL-3.0-or-later
"""Skeletons of letters: where the pen went, and how broad it was."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

import mesecina as mes

session = mes.text("Ragazzi", font="DejaVu Serif", spacing=0.8)
axis = session.axis
radius = axis.radius[axis.edges].mean(axis=1)
# Branches into corners end where the outline turns; strokes lie between sides that are about parallel.
stroke = axis.angle > 75

figure, ax = plt.subplots(figsize=(7, 2.4), layout="constrained")
session.plot(ax, layers=["curve"])
ax.add_collection(LineCollection(axis.points[axis.edges[~stroke]], colors="#9aa7b4", linewidths=0.6))
lines = LineCollection(axis.points[axis.edges[stroke]], array=2 * radius[stroke], cmap="inferno", linewidths=2)
ax.add_collection(lines)
figure.colorbar(lines, label="width of the stroke")
ax.set_axis_off()
figure.savefig("glyph_skeletons.png", dpi=120)
print(f"{len(session.contours)} outlines; strokes are {np.median(2 * radius[stroke]):.1f} wide at the median")
