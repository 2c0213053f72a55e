# SPDX-License-Identifier: GPL-3.0-or-later
"""An evolution of one's own: an elastic band that is pulled towards a point, and the axis that follows."""
from typing import Annotated

import matplotlib.pyplot as plt
import numpy as np

import mesecina as mes


@mes.evolution()
def pull(points, curves, step, strength: Annotated[float, (0, 1)] = 0.15, reach: Annotated[float, (0.1, 2)] = 0.7):
    """Samples are pulled towards the origin, the more the nearer they are, and then even out along their curve."""
    distance = np.hypot(*points.T)[:, None]
    out = points * (1 - strength * np.exp(-(distance / reach) ** 2))
    for curve, is_closed in curves:
        if is_closed:
            before, after = np.roll(curve, 1), np.roll(curve, -1)
            out[curve] = 0.5 * out[curve] + 0.25 * (out[before] + out[after])
    return out


if __name__ == "__main__":
    session = mes.shape("ellipse", samples=160)
    session.move(session.ids, session.points / np.abs(session.points).max() + (0, 0.35))
    figure, axes = plt.subplots(1, 4, figsize=(8, 2), layout="constrained", sharex=True, sharey=True)
    for ax, steps in zip(axes, (0, 4, 8, 12)):
        state = session.evolve(pull, steps, strength=0.25)
        state.plot(ax, layers=["curve", "medial-axis"])
        ax.set_title(f"{steps} steps", fontsize=9)
        ax.set_axis_off()
    figure.savefig("own_evolution.png", dpi=120)
    print(f"the axis is {session.axis.length.sum():.2f} long at first, {state.axis.length.sum():.2f} in the end")
