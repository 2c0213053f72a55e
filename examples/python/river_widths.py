# SPDX-License-Identifier: GPL-3.0-or-later
"""The centre line of a river and its width along it."""
import matplotlib.pyplot as plt
import networkx
import numpy as np
import shapely.geometry as geometry
from shapely.ops import unary_union

import mesecina as mes

# A river whose width is known: disks along a meandering line.
station = np.linspace(0, 60, 1500)
middle = np.column_stack([station, 4 * np.sin(station / 5) + np.cos(station / 2)])
half_width = 0.9 + 0.35 * np.sin(station / 3.5) + station / 80
river = unary_union([geometry.Point(place).buffer(r, 24) for place, r in zip(middle, half_width)])

axis = mes.Session.from_polygons(river).axis
graph = axis.to_networkx()
# The centre line is the longest way through the axis between two of its ends.
ends = [node for node, degree in graph.degree if degree == 1]
first, _ = max(networkx.single_source_dijkstra_path_length(graph, ends[0], weight="length").items(), key=lambda it: it[1])
far, ways = networkx.single_source_dijkstra(graph, first, weight="length")
last = max(far, key=far.get)
line = np.array(ways[last])
along = np.array([far[node] for node in line])
width = 2 * axis.radius[line]
print(f"{along[-1]:.1f} long, from {width.min():.2f} to {width.max():.2f} wide")

figure, (above, below) = plt.subplots(2, 1, figsize=(7, 4.6), height_ratios=[1.3, 1], layout="constrained")
above.fill(*river.exterior.xy, facecolor="#cfe3f3", edgecolor="#3a6ea5", linewidth=0.8)
above.plot(*axis.points[line].T, color="#d55e00", linewidth=1.6)
above.set_aspect("equal")
below.plot(along, width, color="#d55e00")
below.set(xlabel="along the centre line", ylabel="width", ylim=(0, None))
figure.savefig("river_widths.png", dpi=120)
