# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixtures of the tests: shapes of the program, and the program itself."""
import pathlib
import subprocess

import numpy as np
import pytest

import mesecina as mes
from mesecina import _program

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SHAPES = ROOT / "assets" / "shapes"


@pytest.fixture
def program():
    """Runs the program and returns what it writes."""

    def run(*words):
        return subprocess.run([_program.path(), *map(str, words)], capture_output=True, check=True).stdout

    return run


@pytest.fixture
def flower():
    """A session with samples of a smooth curve."""
    return mes.Session(flower_points(240))


def flower_points(count, seed=None):
    angle = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    if seed is not None:
        angle = np.sort(np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi, count))
    radius = 1.0 + 0.2 * np.cos(3.0 * angle)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
