# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures and their tables, as arrays without a copy."""
import functools
import keyword

import numpy as np

from . import _mesecina


@functools.lru_cache(maxsize=None)
def builtin():
    """The catalogue of the program, without experiments."""
    return _mesecina.builtin()


@functools.lru_cache(maxsize=16)
def described_structures(catalogue):
    """The description of each structure of a catalogue by its id, inputs before those that read them."""
    return {one["id"]: one for one in catalogue.structures()}


def attribute_of(name):
    """The name as an attribute: ``lambda_axis`` for ``lambda-axis``, ``lambda_`` for ``lambda``."""
    name = name.replace("-", "_")
    return name + "_" if keyword.iskeyword(name) else name


class Table:
    """The rows of a structure, as in ``session.delaunay.faces``.

    A column is an attribute, or ``table["name"]``: an array of shape (rows,), or (rows, width), with all rows. Row
    numbers in other columns count in it. It is read-only and shows the memory of the session, without a copy. The values
    of rows that are not alive mean nothing; ``table.rows`` has the numbers of the others.

    While such an array lives, the session cannot be read after an edit (`BufferError`). ``compact`` and ``to_pandas``
    copy.
    """

    def __init__(self, bench, structure, description):
        self._bench = bench
        self._structure = structure
        self._description = description
        self._columns = {attribute_of(one["name"]): one["name"] for one in description["columns"]}

    @property
    def name(self):
        """As in ``"delaunay/faces"``."""
        return self._description["id"]

    @property
    def columns(self):
        """The names of its columns."""
        return [one["name"] for one in self._description["columns"]]

    @property
    def rows(self):
        """The numbers of the rows that are alive, an array of shape (n,), by increasing number. O(rows)."""
        return self._bench.live_rows(self.name)

    @property
    def changed(self):
        """Numbers of the rows that the last edit touched or removed, an array of shape (n,).

        It covers all edits between the last two readings of the session. It is None if any row may differ.
        """
        changes = self._bench.changes(self.name)
        return None if changes is None else np.concatenate(changes)

    def compact(self):
        """A structured array with a copy of the rows that are alive, one field a column."""
        rows = self.rows
        fields = [(one["name"], one["type"], (one["width"],) if one["width"] > 1 else ())
                  for one in self._description["columns"]]
        out = np.empty(len(rows), dtype=fields)
        for name in self.columns:
            out[name] = self[name][rows]
        return out

    def to_pandas(self):
        """A ``pandas.DataFrame`` with a copy of the rows that are alive; its index has their numbers."""
        import pandas

        rows = self.rows
        out = {}
        for column in self._description["columns"]:
            values = self[column["name"]][rows]
            if column["width"] == 1:
                out[column["name"]] = values
            else:
                for i, part in enumerate(column["parts"]):
                    out[f"{column['name']}_{part}"] = values[:, i]
        return pandas.DataFrame(out, index=rows)

    def __getitem__(self, name):
        if not isinstance(name, str) or name not in self.columns:
            raise KeyError(f"table {self.name} has no column {name!r}; it has {', '.join(self.columns)}")
        return self._bench.column(self.name, name)

    def __getattr__(self, name):
        try:
            column = self.__dict__["_columns"][name]
        except KeyError:
            raise AttributeError(f"table {self.name} has no column {name!r}") from None
        return self._bench.column(self.name, column)

    def __array__(self, dtype=None, copy=None):
        out = self.compact()
        return out if dtype is None else out.astype(dtype)

    def __len__(self):
        """How many rows are alive. O(rows)."""
        return len(self.rows)

    def __dir__(self):
        return [*super().__dir__(), *self._columns]

    def __repr__(self):
        lines = [f"{self.name}: {self._description['description']}"]
        for one in self._description["columns"]:
            shape = one["type"] + (f"[{one['width']}]" if one["width"] > 1 else "")
            lines.append(f"  {attribute_of(one['name']):<16} {shape:<10} {one['description']}")
        return "\n".join(lines)


class Structure:
    """A structure of a session, as in ``session.delaunay``. Its tables are attributes, or ``structure["name"]``."""

    def __init__(self, bench, description):
        self._bench = bench
        self._id = description["id"]
        self._tables = {attribute_of(one["name"]): one for one in description["tables"]}

    @property
    def name(self):
        """Its id, as the command line names it."""
        return self._id

    @property
    def tables(self):
        """The names of its tables."""
        return [one["name"] for one in self._tables.values()]

    @property
    def statistics(self):
        """Counters and measures, a dict of ints, floats, lists of ints and strings. They may take O(n)."""
        return self._bench.statistics(self._id)

    def __getitem__(self, name):
        description = self._tables.get(attribute_of(name)) if isinstance(name, str) else None
        if description is None:
            raise KeyError(f"structure {self._id} has no table {name!r}; it has {', '.join(self.tables) or 'none'}")
        return Table(self._bench, self._id, description)

    def __getattr__(self, name):
        description = self.__dict__.get("_tables", {}).get(name)
        if description is None:
            raise AttributeError(f"structure {self.__dict__.get('_id')} has no table {name!r}")
        return Table(self._bench, self._id, description)

    def __dir__(self):
        return [*super().__dir__(), *self._tables]

    def __repr__(self):
        return "\n".join([f"structure {self._id}", *("  " + line for name in self.tables
                                                      for line in repr(self[name]).split("\n"))])
