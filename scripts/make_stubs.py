# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes mesecina/__init__.pyi from the module and from the tables of its structures.

    PYTHONPATH=build/release/python python3 scripts/make_stubs.py > python/mesecina/__init__.pyi
"""
import inspect

import mesecina as mes
from mesecina._tables import attribute_of

HEAD = '''# SPDX-License-Identifier: GPL-3.0-or-later
# Written by scripts/make_stubs.py.
from typing import Any, Callable, ContextManager, Iterator, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

__version__: str
'''
FLOATS, NUMBERS, FLAGS = "NDArray[np.float64]", "NDArray[np.uint32]", "NDArray[np.bool_]"
DICTS = "list[dict[str, Any]]"
# What functions and properties return, where it is not Any.
RETURNS = {
    "Axis": {"lambda_": FLOATS, "angle": FLOATS, "degree": "NDArray[np.int64]"},
    "Certificate": {"light": "str", "is_proved": "bool", "findings": DICTS, "reasons": "list[str]"},
    "Picture": {"save": "None"},
    "Structure": {"name": "str", "tables": "list[str]", "statistics": "dict[str, Any]"},
    "Table": {"name": "str", "columns": "list[str]", "rows": NUMBERS, "changed": f"Optional[{NUMBERS}]",
              "compact": "NDArray[Any]"},
    "Window": {"is_open": "bool", "poll": "bool", "wait": "bool", "close": "None"},
    "Session": {"from_polygons": "Session", "from_image": "Session", "save": "None", "copy": "Session", "points": FLOATS,
                "ids": NUMBERS, "balls": FLOATS, "ball_ids": NUMBERS, "contours": f"list[tuple[{NUMBERS}, bool]]",
                "move": "None", "remove": "None", "insert_balls": NUMBERS, "change_balls": "None", "remove_balls": "None",
                "edit": "ContextManager[Session]", "undo": "bool", "redo": "bool", "set": "None", "run": "None",
                "structure": "Structure", "axis": "Axis", "certificate": "Certificate", "statistics": "dict[str, Any]",
                "digest": "str", "instances": FLOATS, "render": "Picture", "compute": "dict[str, Any]",
                "branches": "NDArray[Any]", "centerline": "NDArray[Any]", "persistence": "NDArray[Any]",
                "sweep": "NDArray[Any]", "repair": "Session",
                "decimate": "Session", "sample": "Session", "evolve": "Session", "export": "bytes"},
}
FUNCTIONS = {"open": "Session", "shape": "Session", "text": "Session", "version": "str", "window": "Window",
             "map": "Iterator[Result]", "structure": "Callable[[Callable[..., Any]], Experiment]",
             "layer": "Callable[[Callable[..., Any]], Experiment]", "evolution": "Callable[[Callable[..., Any]], Experiment]"}
# Attributes that are set when an object is made.
MEMBERS = {
    "Axis": {"points": FLOATS, "radius": FLOATS, "edges": "NDArray[np.int64]", "length": FLOATS, "samples": NUMBERS,
             "rows": NUMBERS},
    "ComputationFailed": {"structure": "str", "witnesses": "list[int]"},
    "Experiment": {"what": "str", "id": "str", "description": "str", "parameters": DICTS},
    "InputError": {"file": "str", "line": "int", "column": "int"},
    "Picture": {"data": "bytes", "suffix": "str"},
    "ProgramError": {"status": "int"},
    "Session": {"remarks": "list[str]", "experiments": "tuple[Experiment, ...]"},
}
TYPES = {"float64": FLOATS, "uint32": NUMBERS, "uint8": "NDArray[np.uint8]", "int8": "NDArray[np.int8]", "bool": FLAGS}


def parameters_of(function):
    """The parameters as a stub has them: defaults that are not plain become dots."""
    try:
        all_of_them = list(inspect.signature(function).parameters.values())
    except ValueError:
        return "*arguments: Any"
    out, has_star = [], False
    for one in all_of_them:
        if one.kind is one.VAR_POSITIONAL:
            out.append(f"*{one.name}: Any")
            has_star = True
            continue
        if one.kind is one.VAR_KEYWORD:
            out.append(f"**{one.name}: Any")
            continue
        if one.kind is one.KEYWORD_ONLY and not has_star:
            out.append("*")
            has_star = True
        if one.name in ("self", "cls"):
            out.append(one.name)
            continue
        default = "" if one.default is one.empty else " = ..."
        out.append(f"{one.name}: Any{default}")
    return ", ".join(out)


def class_name(*names):
    return "_" + "".join(part.capitalize() for name in names for part in name.replace("_", "-").split("-"))


def members_of(name, one):
    returns = RETURNS.get(name, {})
    for member, kind in MEMBERS.get(name, {}).items():
        yield f"    {member}: {kind}"
    for member, value in vars(one).items():
        if member.startswith("_") and member not in ("__init__", "__getitem__", "__len__", "__call__"):
            continue
        kind = returns.get(member, "None" if member == "__init__" else "int" if member == "__len__" else "Any")
        if isinstance(value, property):
            yield f"    @property\n    def {member}(self) -> {kind}: ..."
        elif isinstance(value, classmethod):
            yield f"    @classmethod\n    def {member}(cls, {parameters_of(getattr(one, member))}) -> {kind}: ..."
        elif inspect.isfunction(value):
            yield f"    def {member}({parameters_of(value)}) -> {kind}: ..."


def classes_of_structures():
    """The text of a class for each kind of table and of structure, and the class of each structure by its id.

    Tables with the same columns have one class, and so do structures with the same tables.
    """
    texts, known, out = [], {}, {}

    def class_of(name, base, members):
        key = base, tuple(members)
        if key not in known:
            known[key] = name
            texts.append("\n".join([f"\nclass {name}({base}):", *(f"    {one}" for one in members or ["..."])]))
        return known[key]

    for structure in mes.structures():
        tables = []
        for table in structure["tables"]:
            columns = [f"{attribute_of(one['name'])}: {TYPES[one['type']]}" for one in table["columns"]]
            its_class = class_of(class_name(structure["id"], table["name"]), "Table", columns)
            tables.append(f"{attribute_of(table['name'])}: {its_class}")
        out[structure["id"]] = class_of(class_name(structure["id"]), "Structure", tables)
    return texts, out


def main():
    print(HEAD)
    functions = [name for name in mes.__all__ if not inspect.isclass(getattr(mes, name))]
    for name in functions:
        print(f"def {name}({parameters_of(getattr(mes, name))}) -> {FUNCTIONS.get(name, DICTS)}: ...")
    print("\nclass Result(NamedTuple):\n    item: Any\n    value: Any\n    error: Optional[Exception]")
    classes, structures = classes_of_structures()
    for name in mes.__all__:
        one = getattr(mes, name)
        if not inspect.isclass(one) or name == "Result":
            continue
        base = f"({one.__bases__[0].__name__})" if issubclass(one, Exception) else ""
        lines = [f"\nclass {name}{base}:", *members_of(name, one)]
        if name == "Session":
            lines += [f"    {attribute_of(structure)}: {its_class}" for structure, its_class in structures.items()
                      if not hasattr(mes.Session, attribute_of(structure))]
        print("\n".join(lines if len(lines) > 1 else [*lines, "    ..."]))
    print("\n".join(classes))


if __name__ == "__main__":
    main()
