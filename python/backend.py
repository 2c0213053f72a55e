# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the wheel with CMake, for ``pip install ./python`` (PEP 517), with nothing but the standard library.

The wheel has the package, its compiled part, the library, and the program with its assets, which makes pictures.
"""
import base64
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
BUILD = ROOT / "build" / "wheel"


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project = tomllib.loads((HERE / "pyproject.toml").read_text())["project"]
    _compile()
    name = f"{project['name']}-{project['version']}"
    tag = _tag()
    wheel = f"{name}-{tag}.whl"
    with tempfile.TemporaryDirectory() as folder:
        staged = pathlib.Path(folder)
        _stage(staged / "mesecina")
        _write_metadata(staged / f"{name}.dist-info", project, tag)
        _pack(staged, pathlib.Path(wheel_directory) / wheel, f"{name}.dist-info/RECORD")
    return wheel


def _compile():
    def run(*words):
        subprocess.run([*map(str, words)], check=True, cwd=ROOT)

    run("cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DMESECINA_TESTS=OFF",
        "-DMESECINA_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}", "-DCMAKE_INSTALL_RPATH=$ORIGIN")
    run("cmake", "--build", BUILD, "--target", "mesecina_python", "mesecina_library", "mesecina")


def _stage(package):
    """Collects the files of the wheel: the package, the library beside its compiled part, and the program in a folder."""
    with tempfile.TemporaryDirectory() as folder:
        prefix = pathlib.Path(folder)
        subprocess.run(["cmake", "--install", str(BUILD), "--prefix", folder, "--component", "python", "--strip"],
                       check=True, stdout=subprocess.DEVNULL)
        shutil.copytree(next(prefix.glob("lib/**/mesecina/__init__.py")).parent, package)
    library = next(one for one in (BUILD / "core" / "library").glob("libmesecina.so.*") if one.suffix[1:].isdigit()
                   and one.stem == "libmesecina.so")
    shutil.copy(library, package)
    subprocess.run(["strip", "--strip-unneeded", str(package / library.name)], check=True)
    program = package / "_program"
    (program / "bin").mkdir(parents=True)
    shutil.copy(BUILD / "mesecina", program / "bin" / "mesecina")
    subprocess.run(["strip", str(program / "bin" / "mesecina")], check=True)
    shutil.copytree(ROOT / "assets", program / "share" / "mesecina")
    shutil.copytree(ROOT / "examples" / "experiments", program / "share" / "mesecina" / "examples")


def _tag():
    version = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{version}-{version}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _write_metadata(folder, project, tag):
    folder.mkdir()
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {one}" for one in project["dependencies"]]
    (folder / "METADATA").write_text("\n".join(lines) + "\n")
    (folder / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: mesecina\nRoot-Is-Purelib: false\nTag: {tag}\n")
    shutil.copy(ROOT / "LICENSE", folder / "LICENSE")


def _pack(staged, wheel, record_name):
    record = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as out:
        for path in sorted(one for one in staged.rglob("*") if one.is_file()):
            name = path.relative_to(staged).as_posix()
            data = path.read_bytes()
            info = zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0))
            info.external_attr = (0o100755 if os.access(path, os.X_OK) else 0o100644) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            out.writestr(info, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(data)}")
        out.writestr(zipfile.ZipInfo(record_name, (2020, 1, 1, 0, 0, 0)), "\n".join([*record, f"{record_name},,", ""]))
