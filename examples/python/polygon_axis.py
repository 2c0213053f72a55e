# SPDX-License-Identifier: GPL-3.0-or-later
"""The medial axis of a polygon of shapely, without the short branches, as a geometry of shapely again."""
import matplotlib.pyplot as plt
import shapely.geometry as geometry
from matplotlib.collections import LineCollection

import mesecina as mes

walls = geometry.box(0, 0, 12, 7)
pillars = [geometry.Point(3.5, 3.5).buffer(1.2), geometry.box(7, 2, 8.5, 5)]
room = walls.difference(geometry.MultiPolygon(pillars))

session = mes.Session.from_polygons(room)
axis = session.axis
# An edge leads into a corner, or into the noise of the outline, where the walls that it is between are near each other.
main = axis.lambda_ > 0.4
path = geometry.MultiLineString(list(axis.points[axis.edges[main]]))
print(f"{len(session)} samples; the axis is {path.length:.2f} long, and {room.contains(path.buffer(1e-9))} inside")

figure, ax = plt.subplots(figsize=(7, 4.2), layout="constrained")
for ring in (room.exterior, *room.interiors):
    ax.fill(*ring.xy, facecolor="#e8eef4" if ring is room.exterior else "white", edgecolor="#30506f", linewidth=1)
ax.add_collection(LineCollection(axis.points[axis.edges[~main]], colors="#b8c4d0", linewidths=0.8))
lines = LineCollection(axis.points[axis.edges[main]], array=axis.radius[axis.edges[main]].mean(axis=1), linewidths=2.5)
ax.add_collection(lines)
figure.colorbar(lines, label="distance to the wall")
ax.set_aspect("equal")
figure.savefig("polygon_axis.png", dpi=120)
