# SPDX-License-Identifier: GPL-3.0-or-later
"""What rounding does to the union of the inner balls, whose boundary must touch itself in every sample of the curve.

A sample where two or more inner balls meet on the boundary of their union is a v-point (Giesen, Miklos, Pauly, Medial axis
approximation of planar shapes from union of balls, 2007). Three number types count them for a curve that lies farther
and farther from the origin. Rounding the coordinates there is part of the input: all types get the same samples.
"""
import matplotlib.pyplot as plt
import numpy as np

import mesecina as mes

angle = np.linspace(0, 2 * np.pi, 200, endpoint=False)
flower = np.column_stack([np.cos(angle), np.sin(angle)]) * (1 + 0.2 * np.cos(5 * angle))[:, None]
shifts = 2.0 ** np.arange(0, 41, 4)
counts = {"naive": [], "fast": [], "exact": []}
for shift in shifts:
    for precision, results in counts.items():
        session = mes.Session(flower + shift)
        session.set("precision", precision)
        try:
            results.append(len(session.a_union.v_points))
        except mes.ComputationFailed:
            results.append(np.nan)
assert counts["fast"] == counts["exact"]
print("v-points with exact numbers:", counts["exact"])
print("v-points with doubles:      ", counts["naive"])

figure, ax = plt.subplots(figsize=(6, 3.4), layout="constrained")
ax.plot(shifts, counts["exact"], "o-", color="#009e73", label="fast and exact")
ax.plot(shifts, counts["naive"], "x--", color="#d55e00", label="naive: plain doubles")
ax.set_xscale("log", base=2)
ax.set(xlabel="distance from the origin", ylabel="v-points", ylim=(0, None))
ax.legend()
figure.savefig("precision_study.png", dpi=120)
