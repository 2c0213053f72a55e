# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions over arrays that become structures, layers and evolutions."""
import inspect
import os
import sys
import traceback
import types
import typing

import numpy as np

from . import _arrays, _mesecina
from ._tables import attribute_of, builtin, described_structures

_KINDS = {"point": 2, "disk": 3, "circle": 3, "segment": 4, "ray": 4, "line": 4, "triangle": 6, "arc": 7,
          "parabola": 6}


def structure(*, id=None, inputs=None, rows=None):
    """Makes a function over tables a structure.

        @mes.structure(rows={"edges": "delaunay/edges"})
        def long_edges(delaunay, limit: Annotated[float, (0, 1000)] = 10.0):
            "Edges that are longer than a limit"
            ends = delaunay.sites.position[delaunay.edges.sites]
            length = np.hypot(*(ends[:, 0] - ends[:, 1]).T)
            return {"edges": {"is_long": length > limit, "length": length}, "longest": length.max(initial=0.0)}

    Arguments of the function without a default are structures: their tables have columns and ``rows``, as those of a
    session. Columns are copies, in which rows that are not alive are 0. Arguments with a default are parameters: numbers
    in the range of their annotation (``Annotated[float, (low, high)]``), set as ``<structure>-<argument>``. The first
    line of the docstring describes the structure.

    The function returns a dict. Values that are dicts are tables, of columns: arrays of one length, of bool, uint8, int8, or
    1 to 3 uint32 or float64 in a row; a column ``alive`` of bool says which rows are. Other values are statistics.
    Its dict for no samples determines the tables and their columns.

    id
        of the structure; default: the name of the function, with hyphens
    inputs
        ids of the structures, if the arguments have other names
    rows
        for tables whose rows are those of another table: its id
    """

    def decorate(function):
        tables = {name: _arrays.text(table, f"rows of {name}") for name, table in dict(rows or {}).items()}
        return Experiment(function, "structure", id, inputs, {"rows": tables})

    return decorate


def layer(*, rows, kind, id=None, name=None, inputs=None, scalar="", color=(0.85, 0.33, 0.1), opacity=1.0, line_width=1.5,
          point_size=6.0, color_map=""):
    """Makes a function over tables a layer.

        @mes.layer(rows="long-edges/edges", kind="segment", scalar="length")
        def long_edge_lines(long_edges, delaunay):
            "Edges that are longer than a limit"
            lines = np.column_stack([delaunay.sites.position[delaunay.edges.sites].reshape(-1, 4), long_edges.edges.length])
            lines[~long_edges.edges.is_long] = np.nan
            return lines

    Arguments are as those of a `structure`. The function returns an array of shape (rows, coordinates), or with one column
    more for the scalar: the primitive of each row, as `Session.instances` has it. A row of NaN draws nothing.

    rows
        the table whose rows are drawn, one primitive each
    kind
        "point", "disk", "circle", "segment", "ray", "line", "triangle", "arc" or "parabola"
    scalar
        the meaning of the scalar, with its unit; empty: the layer has none
    color, opacity, line_width, point_size, color_map
        the first style: red, green and blue from 0 to 1, sizes in pixels, and a color map as in "viridis"
    """
    if kind not in _KINDS:
        raise ValueError(f"there is no kind of primitive {kind!r}; there are {', '.join(_KINDS)}")

    color = tuple(_arrays.number(one, "a part of a color") for one in color)
    if len(color) != 3:
        raise ValueError(f"a color has red, green and blue, not {len(color)} parts")
    for text in (rows, scalar, color_map):
        _arrays.text(text, "each of rows, scalar and color_map")

    def decorate(function):
        title = name or function.__name__.strip("_").replace("_", " ").capitalize()
        return Experiment(function, "layer", id, inputs,
                          {"rows": rows, "kind": kind, "name": title, "scalar": scalar, "color": color,
                           "opacity": float(opacity), "line_width": float(line_width), "point_size": float(point_size),
                           "color_map": color_map})

    return decorate


def evolution(*, id=None):
    """Makes a function of positions an evolution, for `Session.evolve`.

        @mes.evolution()
        def shrink(points, curves, step, factor: Annotated[float, (0, 1)] = 0.9):
            "Samples come nearer to their mean"
            return points.mean(axis=0) + factor * (points - points.mean(axis=0))

    The function gets the positions of the samples, shape (n, 2), the curves through them (as `Session.contours`; those of
    the crust if there are none) and the number of the step, and returns the next positions. Further arguments with a default
    are parameters.
    """

    def decorate(function):
        return Experiment(function, "evolution", id, None, {})

    return decorate


class Experiment:
    """A structure, a layer or an evolution that a function defines. It can still be called as the function.

    A session gets its structures and layers when it is made: ``mes.Session(points, experiments=[long_edges, long_edge_lines])``.
    """

    def __init__(self, function, what, given_id, inputs, spec):
        self.__wrapped__ = function
        self.__doc__ = function.__doc__
        self.__name__ = function.__name__
        self.__module__ = function.__module__
        self.what = what  #: "structure", "layer" or "evolution"
        self.id = given_id or function.__name__.strip("_").replace("_", "-")  #: as `Session.structure` takes it
        self.description = (inspect.getdoc(function) or self.__name__).split("\n")[0].rstrip(".")
        self._spec = spec
        arguments = list(inspect.signature(function).parameters.values())
        if any(one.kind in (one.VAR_POSITIONAL, one.VAR_KEYWORD) for one in arguments):
            raise TypeError(f"{self.__name__} names each of its arguments, without * and **")
        hints = typing.get_type_hints(function, include_extras=True)
        self._read = [one.name for one in arguments if one.default is one.empty]
        self.parameters = [_parameter(self.id, one, hints.get(one.name)) for one in arguments
                           if one.default is not one.empty]  #: dicts with ``id``, ``low``, ``high`` and ``default``
        self._inputs = inputs
        if what == "evolution" and self._read != ["points", "curves", "step"][:len(self._read)]:
            raise TypeError(f"the first arguments of {self.__name__} are points, curves and step")

    def __call__(self, *arguments, **named):
        return self.__wrapped__(*arguments, **named)

    def __reduce__(self):
        return self.__wrapped__.__qualname__  # a global name, as functions are pickled

    def _by_value(self):
        """As ``__reduce__``, for other interpreters, in which the name may be unknown."""
        return Experiment, (self.__wrapped__, self.what, self.id, self._inputs, self._spec)

    def __repr__(self):
        return f"<{self.what} {self.id}: {self.description}>"

    def _inputs_in(self, structures):
        """The ids of the structures that it reads, among the given ones."""
        if self._inputs is not None:
            if len(self._inputs) != len(self._read):
                raise TypeError(f"{self.id} has {len(self._read)} arguments for {len(self._inputs)} inputs")
            return list(self._inputs)
        known = {attribute_of(one): one for one in structures}
        missing = [one for one in self._read if one not in known]
        if missing:
            raise ValueError(f"there is no structure {missing[0].replace('_', '-')} for {self.id} to read")
        return [known[one] for one in self._read]

    def _call(self, structures, inputs, shown):
        tables = [_Tables(shown, structures[one]) for one in inputs]
        values = {one["argument"]: one["cast"](shown.parameter(one["id"])) for one in self.parameters}
        return self.__wrapped__(*tables, **values)

    def _describe_evolution(self):
        """Describes an evolution to the compiled part."""

        def move(points, curves, step, values):
            named = {one["argument"]: one["cast"](value) for one, value in zip(self.parameters, values)}
            return moved(self, points, [(indices, is_closed) for is_closed, indices in curves], step, named)

        return {"what": self.what, "id": self.id, "name": self.__name__.strip("_").replace("_", " ").capitalize(),
                "description": self.description, "parameters": self.parameters, "function": move}

    def _describe(self, catalogue):
        """Describes a structure or a layer to the compiled part. It raises the exceptions of the function for no samples."""
        structures = described_structures(catalogue)
        inputs = self._inputs_in(structures)
        spec = {"what": self.what, "id": self.id, "description": self.description, "inputs": inputs,
                "parameters": self.parameters, **self._spec}
        if self.what == "layer":
            width = _KINDS[spec["kind"]]

            def draw(shown):
                return _drawn(self._call(structures, inputs, shown), width, self.id)

            _drawn(self._call(structures, inputs, _NoInputs(structures, self.parameters)), width, self.id)
            spec["function"] = draw
            return spec
        known = {table["id"] for one in inputs for table in structures[one]["tables"]}
        for table in spec["rows"].values():
            if table not in known:
                raise ValueError(f"{self.id} reads no table {table}, whose rows its own would be")
        plan = _plan(self._call(structures, inputs, _NoInputs(structures, self.parameters)), spec["rows"], self.id)

        def compute(shown):
            return _computed(self._call(structures, inputs, shown), plan, self.id)

        spec.update(function=compute, tables=plan)
        return spec


def with_experiments(catalogue, experiments):
    """The catalogue with structures and layers, in their order."""
    for one in experiments:
        if not isinstance(one, Experiment) or one.what == "evolution":
            raise TypeError(f"a structure or a layer is expected, not {one!r}")
        catalogue = catalogue.with_experiment(one._describe(catalogue))
    return catalogue


def specs_of(file):
    """Describes to the compiled part all structures, layers and evolutions that a file defines, in their order.

    The file is run as a module of its own each time, with its folder first in the path.
    """
    module = types.ModuleType(os.path.splitext(os.path.basename(file))[0])
    module.__file__ = file
    sys.path.insert(0, os.path.dirname(os.path.abspath(file)))
    try:
        with open(file, encoding="utf-8") as source:
            code = compile(source.read(), file, "exec")
        sys.modules[module.__name__] = module
        exec(code, module.__dict__)  # noqa: S102 - the user's own code
    finally:
        sys.path.pop(0)
    found = [one for one in vars(module).values() if isinstance(one, Experiment)]
    if not found:
        raise ValueError("it defines no structure, layer or evolution (see docs/python.md)")
    catalogue, out = builtin(), []
    for one in dict.fromkeys(found):
        if one.what == "evolution":
            out.append(one._describe_evolution())
        else:
            out.append(one._describe(catalogue))
            catalogue = catalogue.with_experiment(out[-1])
    return out


def moved(experiment, points, curves, step, values):
    """The next positions that an evolution gives, checked."""
    arguments = [points, curves, step][:len(experiment._read)]
    known = {one["argument"] for one in experiment.parameters}
    for name in values:
        if name not in known:
            raise ValueError(f"{experiment.id} has no parameter {name}")
    out = _arrays.rows(experiment(*arguments, **values), 2)
    if len(out) != len(points):
        raise ValueError(f"{experiment.id} returned {len(out)} positions for {len(points)} samples")
    return out


def described(error, trace):
    """One line for the exception of a function: its kind, its text, and the line that raised it."""
    try:
        said = " ".join(str(error).split())
    except Exception:  # noqa: BLE001 - the text of the error is code of its class
        said = ""
    frames = traceback.extract_tb(trace)
    own = [one for one in frames if os.path.dirname(one.filename) != os.path.dirname(__file__)]
    place = f" ({os.path.basename(own[-1].filename)}:{own[-1].lineno})" if own else ""
    return f"{type(error).__name__}{': ' if said else ''}{said}{place}"


def _parameter(owner, argument, hint):
    default = argument.default.item() if isinstance(argument.default, np.generic) else argument.default
    if not isinstance(default, (bool, int, float)):
        raise TypeError(f"parameter {argument.name} of {owner} is a number, not {default!r}")
    extent = [one for one in getattr(hint, "__metadata__", ()) if isinstance(one, tuple) and len(one) == 2]
    if isinstance(default, bool):
        low, high = 0, 1
    elif extent:
        low, high = extent[0]
    else:
        low, high = (0, max(1, 10 * default)) if default >= 0 else (10 * default, -10 * default)
    cast = type(default)
    text = next((one for one in getattr(hint, "__metadata__", ()) if isinstance(one, str)), None)
    return {"id": f"{owner}-{argument.name.strip('_').replace('_', '-')}", "argument": argument.name, "cast": cast,
            "description": text or f"{argument.name.strip('_').replace('_', ' ').capitalize()} of {owner}",
            "low": float(low), "high": float(high), "default": float(default), "is_whole": cast is not float}


class _Tables:
    """A structure as a function reads it: tables as attributes."""

    def __init__(self, shown, description):
        self._shown = shown
        self._described = {attribute_of(one["name"]): one for one in description["tables"]}

    def __getattr__(self, name):
        try:
            return _Columns(self._shown, self.__dict__["_described"][name])
        except KeyError:
            raise AttributeError(f"the structure has no table {name!r}") from None

    def __getitem__(self, name):
        return getattr(self, attribute_of(name))


class _Columns:
    """A table as a function reads it: copies of its columns as attributes."""

    def __init__(self, shown, description):
        self._shown = shown
        self._description = description
        self._names = {attribute_of(one["name"]): one["name"] for one in description["columns"]}

    @property
    def rows(self):
        """The numbers of the rows that are alive."""
        return self._shown.live_rows(self._description["id"])

    def __getattr__(self, name):
        try:
            return self._shown.column(self._description["id"], self.__dict__["_names"][name])
        except KeyError:
            raise AttributeError(f"table {self._description['id']} has no column {name!r}") from None

    def __getitem__(self, name):
        return getattr(self, attribute_of(name))


class _NoInputs:
    """The inputs of a session without samples."""

    def __init__(self, structures, parameters):
        self._columns = {(table["id"], column["name"]): column for one in structures.values()
                         for table in one["tables"] for column in table["columns"]}
        self._values = {one["id"]: one["default"] for one in parameters}

    def column(self, table, name):
        column = self._columns[table, name]
        return np.empty((0, column["width"]) if column["width"] > 1 else 0, dtype=column["type"])

    def live_rows(self, table):
        return np.empty(0, dtype=np.uint32)

    def parameter(self, name):
        return self._values[name]


_TYPES = {"f": np.float64, "b": np.bool_, "u": np.uint32, "i": np.uint32}


def _column(values, where):
    array = _arrays.array(values)
    if array.ndim not in (1, 2) or (array.ndim == 2 and not 1 <= array.shape[1] <= 3):
        raise ValueError(f"{where} is an array of shape (rows,), or (rows, 2) or (rows, 3), not {array.shape}")
    if array.dtype in (np.uint8, np.int8):
        return np.ascontiguousarray(array)
    if array.dtype.kind not in _TYPES:
        raise TypeError(f"{where} has numbers or bool, not {array.dtype}")
    out = np.ascontiguousarray(array, dtype=_TYPES[array.dtype.kind])
    if array.dtype.kind in "iu" and not np.array_equal(out, array):
        raise ValueError(f"{where} has whole numbers below 0 or above 2^32 - 1")
    return out


def _name(key, owner):
    if not isinstance(key, str):
        raise TypeError(f"tables, columns and statistics of {owner} have texts as names, not {key!r}")
    return key


def _tables_of(out, owner):
    if not isinstance(out, dict):
        raise TypeError(f"{owner} returns a dict of tables and statistics, not {type(out).__name__}")
    tables, statistics = {}, {}
    for key, value in out.items():
        _name(key, owner)
        if isinstance(value, dict):
            tables[key] = {_name(name, owner): _column(one, f"{owner}/{key}/{name}") for name, one in value.items()}
            alive = tables[key].get("alive")
            if alive is not None and (alive.ndim != 1 or alive.size and alive.dtype != bool):
                raise TypeError(f"alive of {owner}/{key} is an array of bool of shape (rows,)")
            lengths = {len(one) for one in tables[key].values()}
            if len(lengths) > 1:
                raise ValueError(f"columns of {owner}/{key} have different lengths: {sorted(lengths)}")
        elif isinstance(value, (bool, int, np.integer, np.bool_)):
            statistics[key] = int(value)
        elif isinstance(value, (float, np.floating)):
            statistics[key] = float(value)
        elif isinstance(value, str):
            statistics[key] = value
        else:
            raise TypeError(f"{key} of {owner} is a dict of columns, a number or a text, not {type(value).__name__}")
    return tables, statistics


def _plan(out, rows, owner):
    tables, _ = _tables_of(out, owner)
    unknown = set(rows) - set(tables)
    if unknown:
        raise ValueError(f"{owner} returns no table {sorted(unknown)[0]}")
    return [{"name": name, "description": f"Table {name} of {owner}", "rows_of": rows.get(name, ""),
             "has_alive": "alive" in columns,
             "columns": [{"name": key, "description": f"Column {key}", "type": str(one.dtype),
                          "width": 1 if one.ndim == 1 else one.shape[1]}
                         for key, one in columns.items() if key != "alive"]}
            for name, columns in tables.items()]


def _computed(out, plan, owner):
    tables, statistics = _tables_of(out, owner)
    parts = []
    for table in plan:
        columns = dict(tables.pop(table["name"], {}))
        alive = columns.pop("alive", None)
        if (alive is not None) != table["has_alive"] or list(columns) != [one["name"] for one in table["columns"]]:
            raise ValueError(f"table {table['name']} of {owner} has other columns than without samples")
        for one, array in zip(table["columns"], columns.values()):
            if str(array.dtype) != one["type"] or (1 if array.ndim == 1 else array.shape[1]) != one["width"]:
                raise TypeError(f"column {table['name']}/{one['name']} of {owner} has another type than without samples: "
                                f"{array.dtype}, not {one['type']}")
        parts.append((list(columns.values()), None if alive is None else alive.astype(np.uint8)))
    if tables:
        raise ValueError(f"{owner} has a table {next(iter(tables))} that it does not have without samples")
    return parts, statistics


def _drawn(out, width, owner):
    array = np.asarray(out, dtype=np.float64)
    if array.size == 0:
        array = array.reshape(0, width + 1)
    if array.ndim != 2 or array.shape[1] not in (width, width + 1):
        raise ValueError(f"{owner} returns an array of shape (rows, {width}) or (rows, {width + 1}), not {array.shape}")
    if array.shape[1] == width:
        array = np.column_stack([array, np.zeros(len(array))])
    return np.ascontiguousarray(array)
