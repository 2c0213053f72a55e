# SPDX-License-Identifier: GPL-3.0-or-later
"""The branches of what a picture shows, as a table: lengths, widths, ends and junctions."""
import matplotlib.pyplot as plt
import numpy as np
import pandas

import mesecina as mes

# A net of vessels in a picture of 220 x 320 pixels.
rows, columns = np.mgrid[0:220, 0:320]
vessels = [((20, 30), (110, 90), 7), ((110, 90), (200, 60), 5), ((110, 90), (90, 190), 9), ((90, 190), (30, 290), 6),
           ((90, 190), (180, 270), 4)]
picture = np.zeros(rows.shape, dtype=bool)
for (r0, c0), (r1, c1), radius in vessels:
    t = np.clip(((rows - r0) * (r1 - r0) + (columns - c0) * (c1 - c0)) / ((r1 - r0) ** 2 + (c1 - c0) ** 2), 0, 1)
    picture |= np.hypot(rows - r0 - t * (r1 - r0), columns - c0 - t * (c1 - c0)) < radius

session = mes.Session.from_image(picture)
session.set("lambda-limit", 3.0)  # pixels make bumps, and bumps make branches
session.set("keep-topology", 1)
table = pandas.DataFrame(session.branches(layer="lambda-medial-axis"))
print(table[["from", "to", "length", "radius_least", "radius_mean", "radius_largest"]].round(2).to_string())

figure, ax = plt.subplots(figsize=(6, 4.2), layout="constrained")
ax.imshow(picture, cmap="Greys", alpha=0.4)
session.plot(ax, layers=["lambda-medial-axis"])
for _, one in table.iterrows():
    place = (one.from_x + one.to_x) / 2, (one.from_y + one.to_y) / 2
    ax.annotate(f"{one.branch:.0f}: {2 * one.radius_mean:.1f} wide", place, fontsize=8, ha="center",
                bbox={"boxstyle": "round", "facecolor": "white", "alpha": 0.8, "linewidth": 0})
ax.set(xlim=(0, 319), ylim=(219, 0))
figure.savefig("picture_table.png", dpi=120)
