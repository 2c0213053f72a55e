# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures in notebooks and files."""
import pathlib


class Picture:
    """A picture of a session: PNG or SVG, which a notebook shows by itself."""

    def __init__(self, data, suffix):
        self.data = data  #: the bytes of the file
        self.suffix = suffix  #: ".png", ".svg" or ".pdf"

    def save(self, path):
        """Writes the file. Raises ValueError if the name has the extension of another format."""
        path = pathlib.Path(path)
        if path.suffix.lower() != self.suffix:
            raise ValueError(f"the picture is a {self.suffix} file, and {path.name} is not; see format= of render")
        path.write_bytes(self.data)

    def _repr_png_(self):
        return self.data if self.suffix == ".png" else None

    def _repr_svg_(self):
        return self.data.decode() if self.suffix == ".svg" else None

    def __repr__(self):
        return f"<Picture: {self.suffix[1:].upper()}, {len(self.data)} bytes>"
