# SPDX-License-Identifier: GPL-3.0-or-later
"""The code in docs/python.md runs as it stands, and every public name has a docstring."""
import ast
import inspect
import re
import subprocess
import sys

import pytest

import mesecina as mes
from conftest import ROOT


def test_the_blocks_of_the_document_run():
    pytest.importorskip("pandas")
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "python.md").read_text(), re.DOTALL)
    assert len(blocks) == 7
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
    assert names["denser"] and len(names["branches"])


def test_public_names_have_a_docstring():
    for name in mes.__all__:
        one = getattr(mes, name)
        assert inspect.getdoc(one), name
        if inspect.isclass(one):
            for member, value in vars(one).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, (property, classmethod))):
                    assert inspect.getdoc(getattr(one, member)), f"{name}.{member}"


def test_the_stubs_are_those_of_the_module():
    stubs = subprocess.run([sys.executable, ROOT / "scripts" / "make_stubs.py"], capture_output=True, text=True,
                           check=True).stdout
    ast.parse(stubs)
    assert stubs == (ROOT / "python" / "mesecina" / "__init__.pyi").read_text(), "renew it with scripts/make_stubs.py"
    assert "circumradius: NDArray[np.float64]" in stubs
