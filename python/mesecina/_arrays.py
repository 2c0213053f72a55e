# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays that callers hand in, checked and converted without loss."""
import operator
import os
import warnings

import numpy as np

_WIDTHS = {2: "x and y", 3: "x, y and radius"}
_LAST_ID = 0xFFFFFFFF


def array(values):
    """The values as an array. Raises ValueError for rows of different lengths and for masked values."""
    if np.ma.is_masked(values):
        raise ValueError("some values are masked; take them out or fill them first")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", getattr(np, "VisibleDeprecationWarning", DeprecationWarning))
            return np.asarray(values)
    except (ValueError, Warning) as error:
        raise ValueError(f"the parts of this {type(values).__name__} make no array: "
                         "their lengths or types differ") from error


def _doubles(values, width):
    given = array(values)
    if given.size == 0:
        given = np.empty((0, width))
    if given.dtype.kind not in "fiuO":
        raise TypeError(f"numbers are expected, not {given.dtype}")
    try:
        out = np.ascontiguousarray(given, dtype=np.float64)
    except TypeError as error:
        raise TypeError(f"numbers are expected: {error}") from error
    except OverflowError:
        out = None
    if out is None or given.dtype != np.float64 and not _equal(out, given):
        raise ValueError(f"some of the numbers of type {given.dtype} are not exact as doubles; round them first")
    return out


def _equal(doubles, given):
    with np.errstate(all="ignore"):
        same = doubles.astype(given.dtype) == given
    return bool(np.all(same | np.isnan(doubles)))


def rows(values, width):
    """An array of shape (n, width) of doubles; an empty sequence has no rows.

    Raises ValueError for another shape, for numbers that a double does not hold, and for NaN or infinity, and
    TypeError for values that are not numbers.
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

    Raises TypeError for values that are not whole numbers, and ValueError for numbers that are not ids.
    """
    given = array(values)
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
    if isinstance(value, (bool, np.bool_)):
        raise TypeError("ids are whole numbers, not bool")
    try:
        number = operator.index(value)
    except TypeError:
        return None
    if not 0 <= number <= _LAST_ID:
        raise ValueError(f"there is no id {number}")
    return number


def number(value, name):
    """A double. Raises TypeError for anything but a number, and ValueError for a number that is too large."""
    if isinstance(value, (str, bytes)):
        raise TypeError(f"{name} is a number, not {type(value).__name__}")
    try:
        return float(value)
    except TypeError:
        raise TypeError(f"{name} is a number, not {type(value).__name__}") from None
    except OverflowError:
        raise ValueError(f"{name} is too large for a double") from None


def count(value, name):
    """A whole number from 0 to 2^64 - 1. Raises TypeError for anything else, and ValueError for one out of range."""
    try:
        out = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is a whole number, not {type(value).__name__}") from None
    if not 0 <= out < 2**64:
        raise ValueError(f"{name} is a whole number from 0 to 2^64 - 1, not {out}")
    return out


def text(value, name):
    """The text. Raises TypeError for anything else, and ValueError for one that cannot be written as UTF-8."""
    if not isinstance(value, str):
        raise TypeError(f"{name} is a text, not {type(value).__name__}")
    value.encode()
    return value


def path(value):
    """The bytes of a path. Raises TypeError for values that are not paths, and ValueError for a null byte."""
    out = os.fsencode(value)
    if b"\0" in out:
        raise ValueError("a path has no null byte")
    return out
