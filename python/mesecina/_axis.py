# SPDX-License-Identifier: GPL-3.0-or-later
"""The medial axis as a graph."""
import numpy as np

from ._tables import Structure, builtin, described_structures


class Axis:
    """The one-step medial axis of a session, as a graph with numbered nodes and edges.

    It is a copy of values in the tables of the session, so it stays as it is when the session changes. The
    certificate of the session says whether it is proved to be the medial axis of the union of inner balls.
    Source: Giesen, Miklos, Pauly, *Medial axis approximation of planar shapes from union of balls*, 2007.

    Attributes, all read-only arrays of NumPy:

    ``points``
        shape (n, 2): the nodes, centres of inner Voronoi balls, in units of the document
    ``radius``
        shape (n,): the radius of the ball at each node
    ``edges``
        shape (m, 2): numbers of the nodes at both ends of each edge
    ``length``
        shape (m,): the length of each edge
    ``samples``
        shape (m, 2): ids of the two samples that are nearest to each edge, at the same distance
    ``rows``
        shape (m,): rows of the edges in the table ``medial-axis/edges``, to look up other columns
    """

    def __init__(self, bench):
        self._bench = bench  # not the session, which keeps its axis
        edges = self._table("medial-axis", "edges")
        rows = edges.rows
        rows = rows[~edges.is_zero_length[rows]]
        faces = edges.nodes[rows]
        balls = self._table("inner-balls", "faces")
        # Faces with one circumcircle are one node.
        faces = balls.ball[faces]
        nodes = np.zeros(len(balls.ball), dtype=bool)
        nodes[balls.ball[balls.rows]] = True
        chosen = np.flatnonzero(nodes)
        number = np.cumsum(nodes, dtype=np.int64) - 1
        sites = self._table("delaunay", "edges").sites[rows]
        samples = self._table("delaunay", "sites").sample[sites]
        self.points = balls.center[chosen]
        self.radius = balls.radius[chosen]
        self.edges = number[faces].reshape(-1, 2)
        self.length = edges.length[rows]
        self.samples = self._table("samples", "samples")["id"][samples].reshape(-1, 2)
        self.rows = rows
        self._values = {}
        for one in (self.points, self.radius, self.edges, self.length, self.samples, self.rows):
            one.flags.writeable = False
        self._revision = bench.revision

    def __getstate__(self):
        """All but the session. Values by edge that were not read so far are read now, if the session is the same."""
        if self._bench is not None and self._revision == self._bench.revision:
            _ = self.lambda_, self.angle
        return {**self.__dict__, "_bench": None}

    def __setstate__(self, state):
        self.__dict__.update(state)
        for one in (self.points, self.radius, self.edges, self.length, self.samples, self.rows, *self._values.values()):
            one.flags.writeable = False

    def _table(self, structure, name):
        return Structure(self._bench, described_structures(builtin())[structure])[name]

    @property
    def lambda_(self):
        """The lambda value of each edge, shape (m,): the radius of the smallest circle around its nearest samples."""
        return self._value("lambda-axis", "lambda")

    @property
    def angle(self):
        """The object angle of each edge in degrees, shape (m,): half the angle between its two nearest samples, seen from it."""
        return self._value("angle-axis", "object_angle")

    def _value(self, structure, column):
        if column not in self._values:
            if self._bench is None or self._revision != self._bench.revision:
                raise ValueError("the session has changed since this axis was made; ask it for a new one")
            values = self._table(structure, "edges")[column][self.rows]
            values.flags.writeable = False
            self._values[column] = values
        return self._values[column]

    @property
    def degree(self):
        """How many edges meet at each node, shape (n,): 1 at ends, 3 or more at branchings."""
        return np.bincount(self.edges.ravel(), minlength=len(self.points))

    def to_networkx(self):
        """A ``networkx.Graph``: nodes with ``position`` and ``radius``, edges with ``length`` and ``lambda_``.

        Nodes are numbered as in ``points``. Two edges between the same nodes are one there, the shorter.
        """
        import networkx

        out = networkx.Graph()
        out.add_nodes_from((i, {"position": (float(x), float(y)), "radius": float(r)})
                           for i, ((x, y), r) in enumerate(zip(self.points, self.radius)))
        order = np.argsort(-self.length, kind="stable")
        out.add_edges_from((int(a), int(b), {"length": float(length), "lambda_": float(value)})
                           for (a, b), length, value in zip(self.edges[order], self.length[order], self.lambda_[order]))
        return out

    @property
    def __geo_interface__(self):
        """The edges as a MultiLineString, for shapely and others."""
        ends = self.points[self.edges]
        return {"type": "MultiLineString", "coordinates": [[tuple(a), tuple(b)] for a, b in ends.tolist()]}

    def __repr__(self):
        return (f"<Axis: {len(self.points)} nodes, {len(self.edges)} edges, "
                f"length {self.length.sum():.6g}>")
