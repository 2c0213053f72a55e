# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program ``mesecina`` for its commands: pictures, repairs, sampling, branches, persistence and sweeps.

It runs in a process of its own, so that neither its memory nor its display is that of the interpreter.
"""
import csv
import io
import os
import pathlib
import shutil
import subprocess

import numpy as np

from ._errors import InputError, ProgramError


def path():
    """Where the program is: ``$MESECINA_PROGRAM``, or in this package, or beside it in a build, or in ``$PATH``.

    Raises FileNotFoundError if there is none.
    """
    named = os.environ.get("MESECINA_PROGRAM")
    if named:
        return named
    package = pathlib.Path(__file__).absolute().parent
    for beside in (package / "_program" / "bin" / "mesecina", package.parent.parent / "mesecina"):
        if beside.is_file() and os.access(beside, os.X_OK):
            return str(beside)
    found = shutil.which("mesecina")
    if found is None:
        raise FileNotFoundError("the program mesecina is not installed; it makes pictures and runs commands "
                                "(or say where it is in $MESECINA_PROGRAM)")
    return found


def words_of(options):
    """Options as words of a command line: ``layers=["a", "b"]`` is ``--layers a,b``, ``force=True`` is ``--force``.

    ``set={"lambda-limit": 2}`` is ``--set lambda-limit=2``. None and False are left out.
    """
    out = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        option = "--" + name.strip("_").replace("_", "-")
        if value is True:
            out.append(option)
        elif isinstance(value, dict):
            for key, one in value.items():
                out += [option, f"{key}={_text(one)}"]
        else:
            out += [option, _text(value)]
    return out


def _text(value):
    if isinstance(value, (list, tuple)):
        return ",".join(_text(one) for one in value)
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    return str(value)


def run(command, *words, data=None, **options):
    """The bytes that a command of the program writes, from a file among `words` or from `data` on its standard input.

    Raises ValueError for a wrong option, InputError for a file or data that cannot be read, and ProgramError for other
    errors; the text is the message of the program.
    """
    done = subprocess.run([path(), command, *words_of(options), "--", *map(str, words)], input=data, capture_output=True,
                          check=False)
    if done.returncode == 0:
        return done.stdout
    said = done.stderr.decode(errors="replace").strip().removeprefix("mesecina: ")
    if done.returncode == 130:
        raise KeyboardInterrupt
    if done.returncode == 2:
        raise ValueError(said)
    if done.returncode == 3:
        raise InputError(said)
    raise ProgramError(said or f"it ended with status {done.returncode}", done.returncode)


def table(bytes_of_csv):
    """A structured array of the rows of CSV, with the names of its first line.

    Columns of whole numbers are int64, other columns of numbers float64, in which an empty cell is NaN, and the rest texts.
    """
    names, *rows = csv.reader(io.StringIO(bytes_of_csv.decode(), newline=""))
    columns = [_column(cells) for cells in zip(*rows)] if rows else [np.empty(0)] * len(names)
    out = np.empty(len(rows), dtype=[(name, column.dtype) for name, column in zip(names, columns)])
    for name, column in zip(names, columns):
        out[name] = column
    return out


def _column(cells):
    for cast, dtype in ((int, np.int64), (lambda cell: float(cell) if cell else np.nan, np.float64)):
        try:
            return np.array([cast(cell) for cell in cells], dtype=dtype)
        except (ValueError, OverflowError):
            pass
    return np.array(cells)
