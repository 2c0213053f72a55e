# SPDX-License-Identifier: GPL-3.0-or-later
"""The persistence diagram of growing disks: which holes of a noisy sample are holes of the shape."""
import matplotlib.pyplot as plt
import numpy as np

import mesecina as mes

random = np.random.default_rng(4)
angle = random.uniform(0, 2 * np.pi, 300)
ring = np.column_stack([np.cos(angle), np.sin(angle)]) + random.normal(0, 0.06, (300, 2))
figure_of_eight = np.concatenate([ring, 0.55 * ring[:180] + (1.55, 0)])
session = mes.Session(figure_of_eight)

pairs = session.persistence()
is_finite = np.isfinite(pairs["death"])
left, right = plt.subplots(1, 2, figsize=(7.5, 3.6), layout="constrained")[1]
left.plot(*session.points.T, ".", color="#30506f", markersize=3)
left.set_aspect("equal")
for dimension, color, name in ((0, "#0072b2", "components"), (1, "#d55e00", "holes")):
    chosen = pairs[(pairs["dimension"] == dimension) & is_finite]
    right.plot(chosen["birth"], chosen["death"], "o", color=color, markersize=3.5, alpha=0.7, label=name)
    if dimension == 1:
        life = np.sort(chosen["death"] - chosen["birth"])[::-1]
        print(f"holes live {life[0]:.2f} and {life[1]:.2f}; the next one {life[2]:.2f}")
top = 1.05 * pairs["death"][is_finite].max()
right.plot([0, top], [0, top], color="#888", linewidth=0.8)
right.set(xlabel="radius at birth", ylabel="radius at death", xlim=(-0.02, top), ylim=(-0.02, top))
right.legend(loc="lower right")
plt.gcf().savefig("persistence_diagram.png", dpi=120)
