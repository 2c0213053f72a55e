# SPDX-License-Identifier: GPL-3.0-or-later
"""A session: samples and balls, and the geometry that follows them."""
import contextlib
import functools
import io
import json
import os
import pathlib
import tempfile
import warnings

import numpy as np

from . import _arrays, _mesecina, _plot, _program
from ._axis import Axis
from ._picture import Picture
from ._experiments import Experiment, moved, with_experiments
from ._tables import Structure, attribute_of, builtin, described_structures

_LAYERS = ("interior-voronoi-disks", "curve", "medial-axis", "points")


def _shown(edit):
    """An edit that windows of the session show."""

    @functools.wraps(edit)
    def done(self, *arguments, **named):
        out = edit(self, *arguments, **named)
        if self._windows:
            self._show()
        return out

    return done


class Session:
    """Samples, balls and contours, their history and settings, and the structures that follow them.

    Nothing is computed before it is read; then it is brought up to date, in time that depends on the change. Every
    combinatorial decision about the samples is exact, except with the number type "naive".

    Structures are attributes, named as on the command line with underscores: ``session.delaunay``,
    ``session.one_step_crust``; their tables are attributes of these (`Table`).

    A session is used by one thread at a time; different sessions may be used by different threads, and compute side by
    side. It can be pickled: its data and settings go along, its history does not.

    points
        array-like of shape (n, 2), or None
    balls
        array-like of shape (k, 3), x, y and radius, or None
    contours
        known curves through the points: a sequence of indices for a closed curve; or a pair of a sequence and a bool,
        which says whether the curve is closed
    history
        False: nothing can be undone, and edits take less memory
    experiments
        structures and layers of one's own, each after those that it reads (`structure`, `layer`)

    Raises ValueError for arrays of another shape, numbers that are not finite, or beyond 2^-500 to 2^500 in magnitude.
    """

    def __init__(self, points=None, *, balls=None, contours=(), history=True, experiments=()):
        self.remarks = []  #: remarks of the reader of a file, of polygons or of an image, one line each
        self.experiments = tuple(experiments or ())  #: its own structures and layers
        self.catalogue = with_experiments(builtin(), self.experiments) if self.experiments else builtin()
        self._structures = described_structures(self.catalogue)
        self._keeps_history = bool(history)
        self._bench = _mesecina.Bench(self.catalogue, self._keeps_history)
        self._axis = None
        self._windows = set()
        self._listeners = []
        self._is_in_step = False
        given = [_arrays.rows([] if points is None else points, 2), _contours(contours),
                 _arrays.rows([] if balls is None else balls, 3)]
        if any(map(len, given)):
            self._bench.load(*given)
            self._bench.forget_history()

    @classmethod
    def from_polygons(cls, *geometries, vertices=False):
        """A session with the outlines of polygons, lines or collections of them.

        geometries
            of shapely, or anything else with ``__geo_interface__``, or such a dict. Coordinates are taken as they are.
        vertices
            True: samples are the vertices alone. Otherwise long sides get samples between them, as in files that are opened.
        """
        features = []
        for one in geometries:
            geometry = getattr(one, "__geo_interface__", one)
            if not isinstance(geometry, dict) or "type" not in geometry:
                raise TypeError(f"a geometry with __geo_interface__ is expected, not {type(one).__name__}")
            geometry = _without_rings(geometry)
            if geometry["type"] == "FeatureCollection":
                if not isinstance(geometry.get("features"), (list, tuple)):
                    raise ValueError("a FeatureCollection has a list of features")
                features += geometry["features"]
            elif geometry["type"] == "Feature":
                features.append(geometry)
            else:
                features.append({"type": "Feature", "properties": None, "geometry": geometry})
        text = json.dumps({"type": "FeatureCollection", "features": features}, default=_as_json)
        return cls._from_bytes(text.encode(), "geometry", "geojson", vertices=vertices, degrees=True)

    @classmethod
    def from_image(cls, image):
        """A session with the outlines of the shape in an image.

        image
            array of shape (rows, columns): of bool, where True is the shape; or of grey values, of which the darker or the
            lighter ones are the shape, whichever are fewer along the edge, separated by Otsu's method

        As matplotlib's ``imshow`` has it, the centre of the pixel in row r and column c is at x = c, y = r.
        """
        pixels = _arrays.array(image)
        if pixels.ndim != 2 or pixels.size == 0:
            hint = "; take one channel, or the mean of the channels, first" if pixels.ndim == 3 else ""
            raise ValueError(f"an image of shape (rows, columns) is expected, not {pixels.shape}{hint}")
        if pixels.dtype == bool:
            # A frame of background says which of both is the shape.
            margin = 1
            grey = np.pad(np.where(pixels, 0, 255), margin, constant_values=255)
        elif pixels.dtype.kind in "fiu":
            margin = 0
            if not np.isfinite(pixels).all():
                raise ValueError("some pixels are not finite")
            pixels = pixels * 0.25  # differences of the largest doubles are no doubles
            low, high = pixels.min(), pixels.max()
            grey = np.rint((pixels.astype(np.float64) - low) / ((high - low) or 1.0) * 255.0)
        else:
            raise TypeError(f"pixels are numbers or bool, not {pixels.dtype}")
        height, width = grey.shape
        data = b"P5 %d %d 255\n" % (width, height) + grey.astype(np.uint8).tobytes()
        out = cls._from_bytes(data, "image", "picture")
        samples, contours, balls = out._bench.data()
        samples = np.column_stack([samples[:, 0] - 0.5 - margin, height - 0.5 - margin - samples[:, 1]])
        seen = cls(samples, contours=[(indices, is_closed) for is_closed, indices in contours], balls=balls)
        seen.remarks = out.remarks
        return seen

    @classmethod
    def _from_bytes(cls, data, name, format="", vertices=False, degrees=False, experiments=(), history=True):
        out = cls(experiments=experiments, history=history)
        out.remarks = out._bench.open_bytes(data, name, format, bool(vertices), degrees)["warnings"]
        out._bench.forget_history()
        return out

    # Files.

    def save(self, path, format=""):
        """Writes a file, which appears complete or not at all.

        format
            "poff": samples and contours; "wpoff": balls; "session": data and settings; default: by the extension, .poff,
            .wpoff or .json. Every number reads back bit for bit.

        Warns of data for which the format has no place.
        """
        path = _arrays.path(path)
        self._bench.save(path, _arrays.text(format, "format"))
        lost = {"poff": len(self.ball_ids) and "balls", "wpoff": len(self.ids) and "samples"}
        if what := lost.get(format or os.path.splitext(os.fsdecode(path))[1].lower().lstrip(".")):
            warnings.warn(f"{os.fsdecode(path)} has no place for the {what}; a session (.json) keeps everything", stacklevel=2)

    def __reduce__(self):
        return _restored, (_mesecina.version(), self._bench.text("session"), self.experiments, self._keeps_history)

    def copy(self):
        """Another session with the same data, settings and experiments, without the history."""
        restored, arguments = self.__reduce__()
        return restored(*arguments)

    # Data.

    @property
    def points(self):
        """Positions of the samples in input order, a copy of shape (n, 2), in units of the document."""
        return self._bench.samples()

    @property
    def ids(self):
        """Ids of the samples, shape (n,), in the order of ``points``. An id is never used again by the session."""
        return self._bench.sample_ids()

    @property
    def balls(self):
        """Balls of the document in input order, a copy of shape (k, 3): x, y and radius."""
        return self._bench.balls()

    @property
    def ball_ids(self):
        """Ids of the balls, shape (k,)."""
        return self._bench.ball_ids()

    @property
    def contours(self):
        """Known curves, a list of pairs of indices into ``points``, shape (l,), and whether the curve is closed.

        They can be set: a sequence of such pairs, or of indices for closed curves. Raises ValueError for an index that does
        not exist.
        """
        return [(indices, is_closed) for is_closed, indices in self._bench.data()[1]]

    @contours.setter
    @_shown
    def contours(self, contours):
        self._bench.set_contours(_contours(contours))

    @_shown
    def insert(self, points):
        """Inserts samples, array-like of shape (n, 2), or one of shape (2,). Returns their ids, or its id."""
        if np.ndim(points) == 1 and np.size(points):
            return int(self._bench.insert(_arrays.rows([points], 2))[0])
        return self._bench.insert(_arrays.rows(points, 2))

    @_shown
    def move(self, ids, points):
        """Moves samples: an id and a position, or n ids and positions of shape (n, 2).

        Raises ValueError for an id that is not alive or is named twice.
        """
        one = _arrays.one_id(ids)
        if one is None:
            self._bench.move(_arrays.ids(ids), _arrays.rows(points, 2))
            return
        try:
            x, y = points
            self._bench.move_one(one, x, y)
        except (TypeError, ValueError) as error:
            if isinstance(error, ValueError) and np.shape(points) == (2,):
                raise
            self._bench.move(np.array([one], dtype=np.uint32), _arrays.rows([points], 2))

    @_shown
    def remove(self, ids):
        """Removes samples by their ids, one or several."""
        self._bench.remove(_some_ids(ids))

    @_shown
    def insert_balls(self, balls):
        """Inserts balls of shape (k, 3): x, y and radius. Returns their ids."""
        return self._bench.insert_balls(_arrays.rows(balls, 3))

    @_shown
    def change_balls(self, ids, balls):
        """Gives k balls other centres and radii, shape (k, 3)."""
        self._bench.change_balls(_arrays.ids(ids), _arrays.rows(balls, 3))

    @_shown
    def remove_balls(self, ids):
        """Removes balls by their ids, one or several."""
        self._bench.remove_balls(_some_ids(ids))

    @contextlib.contextmanager
    def edit(self, name="Edit"):
        """Makes all edits of a ``with`` block one step of undo. They stay if the block raises an exception."""
        self._bench.begin_step(_arrays.text(name, "the name of a step"))
        self._is_in_step = True
        try:
            yield self
        finally:
            self._is_in_step = False
            self._bench.end_step()
            self._show()

    @_shown
    def undo(self):
        """Takes the last step back. Returns False if there is none, or within a step."""
        return self._bench.undo()

    @_shown
    def redo(self):
        """Repeats the last step that was taken back. Returns False if there is none, or within a step."""
        return self._bench.redo()

    def on_change(self, callback):
        """Calls ``callback(session)`` whenever something was done in a window of the session. Returns the callback."""
        self._listeners.append(callback)
        return callback

    def _show(self):
        """Its windows show what was done."""
        for one in list(self._windows):
            if not self._is_in_step and not one.poll():
                self._windows.discard(one)

    # Settings.

    @_shown
    def set(self, name, value):
        """Sets a parameter to a number, or ``"precision"`` to a number type, as `mesecina list parameters` names them.

        Raises ValueError for an unknown name or a value out of its range.
        """
        if name == "precision":
            self._bench.set_precision(_arrays.text(value, "precision"))
        else:
            self._bench.set(_arrays.text(name, "the name of a parameter"), _arrays.number(value, name))

    def value(self, name):
        """The value of a parameter, or the number type for ``"precision"``."""
        if name == "precision":
            return self._bench.precision()
        return self._bench.value(_arrays.text(name, "the name of a parameter"))

    # Results.

    def run(self):
        """Brings up to date all that was read so far. Reading does this by itself."""
        self._bench.run()

    def structure(self, structure):
        """A structure by its id, as in ``"one-step-crust"``."""
        if _arrays.text(structure, "the id of a structure") not in self._structures:
            raise ValueError(f"unknown structure {structure}")
        return Structure(self._bench, self._structures[structure])

    @property
    def axis(self):
        """The one-step medial axis as a graph of the session as it is now (`Axis`)."""
        if self._axis is None or self._axis._revision != self._bench.revision:
            self._axis = Axis(self._bench)
        return self._axis

    @property
    def changed(self):
        """The rows that the last edits changed: ``session.changed["delaunay/faces"]`` (`Table.changed`)."""
        return _Changed(self)

    @property
    def certificate(self):
        """Whether the one-step axis is proved to be the medial axis for these samples (`Certificate`)."""
        return Certificate(self._bench)

    def statistics(self, structure):
        """Counters and measures of a structure, as `mesecina compute` reports them; a dict."""
        return self.structure(structure).statistics

    def digest(self, layer):
        """32 hexadecimal digits that depend on what the layer draws; equal to those of ``mesecina compute --digest``."""
        return self._bench.digest(_arrays.text(layer, "the id of a layer"))

    def instances(self, layer, kind):
        """The primitives of one kind that a layer draws: coordinates, and a scalar in the last column.

        kind
            point: x y; disk, circle: x y r; segment: x1 y1 x2 y2; ray, line: x y dx dy; triangle: x1 y1 x2 y2 x3 y3;
            arc: x y r x1 y1 x2 y2, counter-clockwise; parabola: x1 y1 xc yc x2 y2, with the control point in the middle

        Read-only and without a copy, as columns of tables are.
        """
        return self._bench.instances(_arrays.text(layer, "the id of a layer"), _arrays.text(kind, "a kind"))

    # Pictures.

    def plot(self, ax=None, layers=_LAYERS):
        """Draws layers on axes of matplotlib, the present ones by default, bottom first. Returns the axes."""
        if ax is None:
            from matplotlib import pyplot

            ax = pyplot.gca()
        return _plot.plot(self, ax, layers)

    def render(self, layers=None, width=800, height=None, format="png", **options):
        """A picture as the program draws it.

        layers
            ids, bottom first; default: those visible at start
        width, height
            in pixels; the height is three quarters of the width by default
        format
            png, svg, pdf, ps, eps, ipe or tex
        options
            those of ``mesecina render``: ``view="0,0,1,1"``, ``background="transparent"``, ``scale=2``
        """
        height = height or max(1, round(0.75 * width))
        with tempfile.TemporaryDirectory(prefix="mesecina-") as folder:
            path = os.path.join(folder, f"picture.{format}")
            self._command("render", layers=layers, size=f"{width}x{height}", output=path, **options)
            return Picture(pathlib.Path(path).read_bytes(), f".{format}")

    # Commands of the program, on a copy of the session.

    def compute(self, layers=None, **options):
        """Counts and measures of layers and structures: the report of ``mesecina compute`` as a dict."""
        return json.loads(self._command("compute", layers=layers, **options))

    def branches(self, layer="medial-axis"):
        """The branches of an axis with their measures: a structured array, as ``mesecina branches`` writes it."""
        return _program.table(self._command("branches", layer=layer))

    def centerline(self, **options):
        """Points of centre lines: a structured array, as ``mesecina centerline`` writes it; stations if `every` is given."""
        return _program.table(self._command("centerline", format="csv", **options))

    def persistence(self, of="samples"):
        """Births and deaths of components and holes: a structured array, as ``mesecina persistence`` writes it."""
        return _program.table(self._command("persistence", of=of))

    def sweep(self, parameter, low, high, steps, layers=None):
        """Counts and measures while a parameter goes from `low` to `high`: a structured array."""
        return _program.table(self._command("sweep", parameter=f"{parameter}={low!r}..{high!r}", steps=steps,
                                            layers=layers))

    def repair(self, **options):
        """A new session with more samples where the curve has too few (``mesecina repair``)."""
        return self._transformed("repair", **options)

    def decimate(self, **options):
        """A new session without samples that the curve and the axis do not need (``mesecina decimate``)."""
        return self._transformed("decimate", **options)

    def sample(self, **options):
        """A new session with other samples of the same curves (``mesecina sample``): ``rule="spacing", spacing=0.1``."""
        return self._transformed("sample", **options)

    def evolve(self, evolution, steps=1, **options):
        """A new session after some steps of an evolution.

        evolution
            an id, with the options of ``mesecina evolve``; or one's own (`evolution`), with its parameters
        """
        if not isinstance(evolution, Experiment):
            return self._transformed("evolve", evolution=evolution, steps=steps, **options)
        out = self.copy()
        for step in range(steps):
            curves = out.contours or _chains(out)
            out.move(out.ids, moved(evolution, out.points, curves, step, options))
        out._bench.forget_history()
        return out

    def export(self, layer, format, **options):
        """The bytes of a layer's geometry as text (``mesecina export``): "csv", "geojson", "wkt", "svg", ..."""
        return self._command("export", layer=layer, format=format, **options)

    def _command(self, command, output="-", **options):
        return _program.run(command, "-", data=self._bench.text("session"), **{"from": "session"}, output=output,
                            **options)

    def _transformed(self, command, **options):
        return Session._from_bytes(self._command(command, **options), command, "poff")

    def __getattr__(self, name):
        catalogue = self.__dict__.get("catalogue")
        found = None if name.startswith("_") or catalogue is None else _attributes(catalogue).get(name)
        if found is None:
            raise AttributeError(f"a session has no structure or attribute {name!r}")
        return Structure(self._bench, self._structures[found])

    def __dir__(self):
        return [*super().__dir__(), *_attributes(self.catalogue)]

    def __len__(self):
        """How many samples there are."""
        return len(self.ids)

    def __bool__(self):
        return True

    def __repr__(self):
        return f"<Session: {len(self.ids)} samples, {len(self.contours)} contours, {len(self.ball_ids)} balls>"


class Certificate:
    """The certificate of the one-step axis of a session. It is computed when it is read."""

    def __init__(self, bench):
        self._bench = bench

    @property
    def light(self):
        """"green": proved; "yellow": exact, but not proved; "red": the number type gave a wrong result; "none"."""
        return self._bench.light()

    @property
    def is_proved(self):
        """The one-step axis is the medial axis of the union of inner balls, for these samples."""
        return self.light == "green"

    @property
    def findings(self):
        """Dicts with ``structure``, ``level`` (note, doubt, wrong), ``text``, ``count`` and ``places``, shape (m, 2)."""
        return self._bench.findings()

    @property
    def reasons(self):
        """The reasons why it is not proved, a list of texts."""
        return [one["text"] for one in self.findings if one["level"] != "note"]

    def __repr__(self):
        return f"<Certificate: {self.light}{''.join('; ' + one for one in self.reasons)}>"


class _Changed:
    """Rows that the last edits changed, by table."""

    def __init__(self, session):
        self._session = session

    def __getitem__(self, table):
        structure, _, name = _arrays.text(table, "the id of a table").replace(".", "/").partition("/")
        return self._session.structure(structure)[name].changed


def open(path, format="", *, vertices=False, degrees=False, crs="", experiments=()):
    """Opens a file of any format that `mesecina list formats` names, and returns a `Session`.

    format
        id of the format; default: found by what the file holds, then by its name
    vertices
        True: samples of a drawing, map or mesh are its vertices alone; else its curves are sampled
    degrees
        True: longitude and latitude of a map stay degrees; else they are projected to metres
    crs
        coordinate system of the positions, as "EPSG:25832"; default: that which the file names

    Raises FileNotFoundError, and InputError with file, line and column. Other remarks of the reader become
    warnings.
    """
    path = _arrays.path(path)
    io.open(path, "rb").close()  # raises the exceptions of Python
    out = Session(experiments=experiments)
    out.remarks = out._bench.open(path, _arrays.text(format, "format"), bool(vertices), bool(degrees),
                                  _arrays.text(crs, "crs"))["warnings"]
    for line in out.remarks:
        warnings.warn(line, stacklevel=2)
    out._bench.forget_history()
    return out


def shape(name, *, samples=None, spacing=None, jitter=0.0, seed=1, **parameters):
    """A session with samples of a shape with parameters (`mesecina list shapes`).

    samples, spacing
        how many, or how far apart along curves
    jitter
        each sample moves by up to so many mean spacings
    parameters
        numbers, or texts of formulas, by the ids of the shape with underscores

    The same call gives the same samples on every machine.
    """
    values = [(key.rstrip("_").replace("_", "-"), value) for key, value in parameters.items()]
    numbers = [(key, _arrays.number(value, key)) for key, value in values if not isinstance(value, str)]
    formulas = [(key, value) for key, value in values if isinstance(value, str)]
    points, contours, balls = _mesecina.shape(
        _arrays.text(name, "the id of a shape"), numbers, formulas,
        None if samples is None else _arrays.count(samples, "samples"),
        None if spacing is None else _arrays.number(spacing, "spacing"),
        _arrays.number(jitter, "jitter"), _arrays.count(seed, "seed"))
    return Session(points, contours=[(indices, is_closed) for is_closed, indices in contours], balls=balls)


def text(letters, **options):
    """A session with samples of the outlines of a text; options are those of ``mesecina text``: font, size, samples."""
    return Session._from_bytes(_program.run("text", letters, output="-", **options), "text", "poff")


def _restored(version, text, experiments=(), history=True):
    try:
        return Session._from_bytes(text, "pickle", "session", experiments=experiments, history=history)
    except ValueError as error:
        raise ValueError(f"a session of version {version} cannot be read by version {_mesecina.version()}: "
                         f"{error}") from error


def _chains(session):
    """The curves of the crust through the samples, as `Session.contours` has them."""
    crust, edges = session.one_step_crust.edges, session.delaunay.edges
    ends = session.delaunay.sites.sample[edges.sites[np.flatnonzero(crust.is_crust & _alive(edges))]]
    order = {int(one): i for i, one in enumerate(session.samples.samples.rows)}
    beside = {}
    for a, b in ends.tolist():
        beside.setdefault(a, []).append(b)
        beside.setdefault(b, []).append(a)
    out, used = [], set()
    # Chains end where one or more than two edges meet; what is left then are loops.
    for start in sorted(beside, key=lambda one: (len(beside[one]) == 2, one)):
        for following in beside[start]:
            if (start, following) in used:
                continue
            chain, before, here = [start], start, following
            used |= {(start, following), (following, start)}
            while here != start and len(beside[here]) == 2:
                chain.append(here)
                before, here = here, beside[here][beside[here][0] == before]
                used |= {(before, here), (here, before)}
            is_closed = here == start
            out.append((np.array([order[one] for one in (chain if is_closed else [*chain, here])]), is_closed))
    return out


def _alive(table):
    out = np.zeros(len(table.sites), dtype=bool)
    out[table.rows] = True
    return out


def _contours(contours):
    out = []
    for one in () if contours is None else contours:
        is_closed = True
        if isinstance(one, tuple) and len(one) == 2 and isinstance(one[1], (bool, np.bool_)):
            one, is_closed = one
        out.append((bool(is_closed), _arrays.ids(one)))
    return out


def _some_ids(ids):
    one = _arrays.one_id(ids)
    return _arrays.ids(ids) if one is None else np.array([one], dtype=np.uint32)


def _without_rings(geometry):
    """The geometry with polygons for rings, which shapely has and GeoJSON does not."""
    if geometry["type"] == "LinearRing":
        return {"type": "Polygon", "coordinates": [geometry.get("coordinates")]}
    if geometry["type"] == "GeometryCollection" and isinstance(geometry.get("geometries"), (list, tuple)):
        return {**geometry, "geometries": [_without_rings(one) if isinstance(one, dict) and "type" in one else one
                                           for one in geometry["geometries"]]}
    return geometry


def _as_json(value):
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is no part of a geometry")


@functools.lru_cache(maxsize=16)
def _attributes(catalogue):
    return {attribute_of(one): one for one in described_structures(catalogue)
            if not hasattr(Session, attribute_of(one))}
