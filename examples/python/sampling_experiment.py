# SPDX-License-Identifier: GPL-3.0-or-later
"""How far the axis of samples lies from the axis of the curve, against the sampling density: 200 runs on an ellipse."""
import matplotlib.pyplot as plt
import numpy as np

import mesecina as mes

A, B = 2.0, 1.0
END = (A * A - B * B) / A  # the axis of the ellipse goes from (-END, 0) to (END, 0)


def feature_size(points):
    """The distance to the axis of the ellipse; outside, the axis is farther away."""
    nearest = np.clip(points[:, 0], -END, END)
    return np.hypot(points[:, 0] - nearest, points[:, 1])


def run(count, seed):
    random = np.random.default_rng(seed)
    angle = np.sort((np.arange(count) + random.uniform(-0.3, 0.3, count)) * 2 * np.pi / count)
    points = np.column_stack([A * np.cos(angle), B * np.sin(angle)])
    between = 0.5 * (angle + np.append(angle[1:], angle[0] + 2 * np.pi))
    middle = np.column_stack([A * np.cos(between), B * np.sin(between)])
    gap = np.hypot(*(middle - points).T)
    epsilon = (gap / feature_size(middle)).max()
    session = mes.Session(points)
    axis = session.axis
    # From the axis of the samples to that of the ellipse.
    nearest = np.column_stack([np.clip(axis.points[:, 0], -END, END), np.zeros(len(axis.points))])
    error = np.hypot(*(axis.points - nearest).T).max(initial=0.0)
    return epsilon, error, session.certificate.is_proved


runs = np.array([run(count, seed) for seed in range(10) for count in np.geomspace(12, 1200, 20).astype(int)])
epsilon, error, is_proved = runs.T
slope, _ = np.polyfit(np.log(epsilon), np.log(error), 1)
print(f"{len(runs)} runs; proved to be the axis of the inner balls: {int(is_proved.sum())}; the distance goes with epsilon^{slope:.2f}")

figure, ax = plt.subplots(figsize=(6, 4), layout="constrained")
ax.loglog(epsilon, error, "o", color="#009e73", markersize=4, alpha=0.6, label="a run")
reference = np.array([epsilon.min(), epsilon.max()])
ax.loglog(reference, 0.1 * reference**2, color="#888", linewidth=0.8, label="a tenth of the square of epsilon")
ax.set(xlabel="epsilon of the sample", ylabel="distance to the axis of the ellipse")
ax.legend()
figure.savefig("sampling_experiment.png", dpi=120)
