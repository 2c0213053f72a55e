# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays that callers hand in, checked and converted without loss."""
import operator

import numpy as np

_WIDTHS = {2: "x and y", 3: "x, y and radius"}
_LAST_ID = 0xFFFFFFFF


def _doubles(values, width):
    given = np.asarray(values)
    if given.size == 0:
        given = np.empty((0, width))
    if given.dtype.kind not in "fiuO":
        raise TypeError(f"numbers are expected, not {given.dtype}")
    out = np.ascontiguousarray(given, dtype=np.float64)
    if given.dtype.kind != "O" and given.dtype != np.float64 and not _equal(out, given):
        raise ValueError(f"some of the numbers of type {given.dtype} are no doubles; round them first")
    return out


def _equal(doubles, given):
    with np.errstate(all="ignore"):
        same = doubles.astype(given.dtype) == given
    return bool(np.all(same | (given != given)))


def rows(values, width):
    """An array of shape (n, width) of doubles; an empty sequence has no rows.

    Raises ValueError for another shape, for numbers that a double does not hold, and for NaN or infinity;
    TypeError for what are no numbers.
    """
    out = _doubles(values, width)
    if out.ndim != 2 or out.shape[1] != width:
        raise ValueError(f"an array of shape (n, {width}) with {_WIDTHS[width]} is expected, not {out.shape}")
    if not np.isfinite(out).all():
        row = int(np.flatnonzero(~np.isfinite(out).all(axis=1))[0])
        raise ValueError(f"row {row} is not finite: {tuple(float(v) for v in out[row])}")
    return out


def ids(values):
    """An array of shape (n,) of ids.

    Raises TypeError for what are no whole numbers, and ValueError for those that are no ids.
    """
    given = np.asarray(values)
    if given.size == 0:
        return np.empty(0, dtype=np.uint32)
    if given.dtype.kind not in "iu":
        raise TypeError(f"ids are whole numbers, not {given.dtype}")
    if given.ndim != 1:
        raise ValueError(f"ids are an array of shape (n,), not {given.shape}")
    if int(given.min()) < 0 or int(given.max()) > _LAST_ID:
        raise ValueError(f"there is no id {int(given.min()) if int(given.min()) < 0 else int(given.max())}")
    return np.ascontiguousarray(given, dtype=np.uint32)


def one_id(value):
    """The id as a number, or None if the value is not a single number."""
    try:
        number = operator.index(value)
    except TypeError:
        return None
    if not 0 <= number <= _LAST_ID:
        raise ValueError(f"there is no id {number}")
    return number
