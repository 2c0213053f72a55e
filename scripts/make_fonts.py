#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts the fonts of the program from those of Inter, version 3.019 (on Debian: fonts-inter 3.19, python3-fonttools).

    scripts/make_fonts.py DIR     from the .otf files in DIR, such as /usr/share/fonts/opentype/inter

Letters keep their outlines, widths and kerning. Other features of the fonts, and their letters beyond those below, go.
"""
import pathlib
import sys

from fontTools import subset

NAMES = ("Inter-Regular", "Inter-SemiBold", "Inter-Italic")
RANGES = (
    (0x20, 0x7E),  # ASCII
    (0xA0, 0x148), (0x14A, 0x17F),  # Latin with accents
    (0x391, 0x3A1), (0x3A3, 0x3C9), (0x3D1, 0x3D1), (0x3D5, 0x3D5), (0x3F5, 0x3F5),  # Greek
    (0x2013, 0x2014), (0x2018, 0x201D), (0x2022, 0x2022), (0x2026, 0x2026), (0x2032, 0x2032),  # punctuation
    (0x2113, 0x2113), (0x2190, 0x2194), (0x2202, 0x2202), (0x2205, 0x2205), (0x2212, 0x2212),  # mathematics
    (0x221A, 0x221A), (0x221E, 0x221E), (0x2248, 0x2248), (0x2260, 0x2260), (0x2264, 0x2265), (0x25CF, 0x25CF),
)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    letters = [letter for first, last in RANGES for letter in range(first, last + 1)]
    target = pathlib.Path(__file__).resolve().parent.parent / "assets" / "fonts"
    for name in NAMES:
        options = subset.Options(layout_features=["kern"], hinting=True, notdef_outline=True)
        font = subset.load_font(pathlib.Path(sys.argv[1]) / f"{name}.otf", options)
        missing = [chr(letter) for letter in letters if letter not in font.getBestCmap()]
        if missing:
            sys.exit(f"{name} lacks {' '.join(missing)}")
        subsetter = subset.Subsetter(options)
        subsetter.populate(unicodes=letters)
        subsetter.subset(font)
        subset.save_font(font, target / f"{name}.otf", options)


if __name__ == "__main__":
    main()
