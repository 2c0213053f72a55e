# SPDX-License-Identifier: GPL-3.0-or-later
"""Sample-based geometry in the plane: exact, incremental structures as arrays.

    import mesecina as mes

    s = mes.open("lizard.poff")            # or mes.Session(points), from_polygons, from_image, mes.shape
    s.axis.points[s.axis.edges]            # the medial axis, shape (m, 2, 2)
    s.certificate.is_proved                # is it the axis of the union of inner balls?
    s.delaunay.faces.circumradius          # a column of a table, without a copy
    s.move(17, (3.0, 4.0))                 # everything follows, in time that depends on the change
    s.changed["delaunay/faces"]            # the rows that have changed
    s.plot()                               # on axes of matplotlib; s.render() as the program draws it

Ids of structures, layers and parameters are those of the command line. Coordinates, radii and lengths are doubles in
the unit of the document; ids of samples and row numbers are uint32.
"""
try:
    import numpy as _numpy  # noqa: F401
except ImportError as error:
    raise ImportError("mesecina needs NumPy (on Debian: apt install python3-numpy)") from error

from ._axis import Axis
from ._errors import ComputationFailed, InputError, ProgramError
from ._experiments import Experiment, evolution, layer, structure
from ._map import Result, map
from ._mesecina import version
from ._picture import Picture
from ._session import Certificate, Session, open, shape, text
from ._tables import Structure, Table, builtin
from ._window import Window, window

__version__ = version()
__all__ = ["Axis", "Certificate", "ComputationFailed", "Experiment", "InputError", "Picture", "ProgramError",
           "Result", "Session", "Structure", "Table", "Window", "evolution", "evolutions", "formats", "layer",
           "layers", "map", "open", "parameters", "shape", "shapes", "structure", "structures", "text", "version",
           "window"]


def structures():
    """The structures of the program: dicts with ``id``, ``inputs``, ``parameters`` and ``tables`` with their columns."""
    return builtin().structures()


def layers():
    """The layers of the program, bottom first: dicts with ``id``, ``name``, ``description``, ``kinds``, ``scalar``, ..."""
    return builtin().layers()


def parameters():
    """The parameters of structures: dicts with ``id``, ``description``, ``unit``, ``low``, ``high``, ``default``, ..."""
    return builtin().parameters()


def evolutions():
    """The evolutions of the program: dicts with ``id``, ``description``, ``parameters``, ``is_random``, ..."""
    return builtin().evolutions()


def shapes():
    """The shapes that `shape` samples: dicts with ``id``, ``description``, ``parameters`` and ``formulas``."""
    return builtin().shapes()


def formats():
    """The formats of files: dicts with ``id``, ``name``, ``extensions``, ``can_read`` and ``can_write``."""
    return builtin().formats()
