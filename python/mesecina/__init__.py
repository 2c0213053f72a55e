# SPDX-License-Identifier: GPL-3.0-or-later
"""Sample-based geometry in the plane: exact, incremental structures as arrays.

    import mesecina as mes

    s = mes.open("lizard.poff")            # or mes.Session(points), from_polygons, from_image, mes.shape
    s.axis.points[s.axis.edges]            # the medial axis, shape (m, 2, 2)
    s.certificate.is_proved                # is it the axis of the union of inner balls?
    s.delaunay.faces.circumradius          # a column of a table, without a copy
    s.move(17, (3.0, 4.0))                 # everything follows, in time that depends on the change
    s.changed["delaunay/faces"]            # the rows that did
    s.plot()                               # on axes of matplotlib; s.render() as the program draws it

What has an id on the command line has the same one here. Coordinates, radii and lengths are doubles in the unit of the
document; ids and row numbers are uint32.
"""
try:
    import numpy as _numpy  # noqa: F401
except ImportError as error:
    raise ImportError("mesecina needs NumPy (on Debian: apt install python3-numpy)") from error

from ._axis import Axis
from ._errors import ComputationFailed, InputError, ProgramError
from ._mesecina import formats, layers, parameters, shapes, structures, version
from ._picture import Picture
from ._session import Certificate, Session, open, shape
from ._tables import Structure, Table

__version__ = version()
__all__ = ["Axis", "Certificate", "ComputationFailed", "InputError", "Picture", "ProgramError", "Session", "Structure",
           "Table", "formats", "layers", "open", "parameters", "shape", "shapes", "structures", "version"]
