# SPDX-License-Identifier: GPL-3.0-or-later
"""Letters for a V-shaped bit: it follows the medial axis, as deep as the letter is wide there."""
import matplotlib.pyplot as plt
import networkx
import numpy as np
from matplotlib.collections import LineCollection

import mesecina as mes

BIT_ANGLE = 60.0  # degrees between the two sides of the bit
DEEPEST = 6.0  # mm
SAFE = 3.0  # mm above the material
FEED, PLUNGE = 600, 200  # mm a minute

session = mes.text("Vela", font="DejaVu Serif", size=40, spacing=0.25)  # sizes are mm here
axis = session.axis
depth = np.minimum(axis.radius / np.tan(np.radians(BIT_ANGLE / 2)), DEEPEST)


def cuts(graph):
    """Ways through the graph that together have each edge once, with few lifts of the bit."""
    for part in networkx.connected_components(graph):
        rest = networkx.MultiGraph(graph.subgraph(part))
        odd = sorted(node for node, degree in rest.degree if degree % 2)
        # An Euler path has two ends of odd degree at most. The bit is lifted along the edges that pair the others.
        for one, other in zip(odd[1::2], odd[2::2]):
            rest.add_edge(one, other, is_lift=True)
        way = []
        for one, other, key in networkx.eulerian_path(rest, source=odd[0] if odd else None, keys=True):
            if rest.edges[one, other, key].get("is_lift"):
                yield way
                way = []
                continue
            way = way or [one]
            way.append(other)
        yield way


ways = [way for way in cuts(axis.to_networkx()) if way]
lines = ["G21 G90 G17 (mm, absolute, XY plane)", f"G0 Z{SAFE:.3f}"]
for way in ways:
    x, y = axis.points[way[0]]
    lines += [f"G0 X{x:.3f} Y{y:.3f}", f"G1 Z{-depth[way[0]]:.3f} F{PLUNGE}"]
    for i, node in enumerate(way[1:]):
        x, y = axis.points[node]
        lines.append(f"G1 X{x:.3f} Y{y:.3f} Z{-depth[node]:.3f}" + (f" F{FEED}" if i == 0 else ""))
    lines.append(f"G0 Z{SAFE:.3f}")
with open("v_carve.ngc", "w", encoding="ascii") as file:
    file.write("\n".join(lines + ["M2"]) + "\n")

figure, ax = plt.subplots(figsize=(7, 3), layout="constrained")
session.plot(ax, layers=["contours"])
cut = LineCollection(axis.points[axis.edges], array=depth[axis.edges].mean(axis=1), cmap="viridis_r", linewidths=2,
                     capstyle="round")
ax.add_collection(cut)
figure.colorbar(cut, label="depth in mm")
ax.set_axis_off()
figure.savefig("v_carve.png", dpi=120)
length = np.linalg.norm(np.diff(axis.points[axis.edges], axis=1)[:, 0], axis=1).sum()
print(f"{len(ways)} cuts, {length:.0f} mm in all, at most {depth.max():.1f} mm deep")
