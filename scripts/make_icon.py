#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the icon: a crescent, its inner balls and its medial axis. Writes packaging/icons; needs rsvg-convert.

The crescent is what a disk (centre A, radius R) keeps of itself outside another disk (centre B, radius S). A ball
that touches both circles from within the crescent has |c - A| = R - r and |c - B| = S + r, so its centre lies on the
ellipse |c - A| + |c - B| = R + S: the medial axis, exactly.
"""
import math
import pathlib
import subprocess

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "packaging" / "icons"
SIZES = (16, 22, 24, 32, 48, 64, 128, 256, 512)
A, R, S, DISTANCE, TILT = (126.0, 130.0), 92.0, 74.0, 48.0, math.radians(-35.0)
BALLS = 11


def placed(along, across):
    """From the frame of the ellipse, whose centre lies between A and B, to the picture."""
    x = along + DISTANCE / 2.0
    return (A[0] + x * math.cos(TILT) - across * math.sin(TILT), A[1] + x * math.sin(TILT) + across * math.cos(TILT))


def ball(angle):
    """The ball whose centre is at this angle of the ellipse: x, y, radius."""
    long = (R + S) / 2.0
    short = math.sqrt(long * long - DISTANCE * DISTANCE / 4.0)
    along, across = long * math.cos(angle), short * math.sin(angle)
    return (*placed(along, across), R - math.hypot(along + DISTANCE / 2.0, across))


def tip():
    """The angle at which the radius becomes zero: one end of the axis, where the circles meet."""
    low, high = 0.0, math.pi
    for _ in range(60):
        middle = (low + high) / 2.0
        low, high = (low, middle) if ball(middle)[2] > 0.0 else (middle, high)
    return high


def points(pairs):
    return " ".join("%.2f,%.2f" % (x, y) for x, y in pairs)


def drawing():
    end = tip()
    axis = [ball(end + (2.0 * math.pi - 2.0 * end) * i / 120.0)[:2] for i in range(121)]
    first, last = axis[0], axis[-1]
    crescent = "M%.2f %.2f A%g %g 0 1 1 %.2f %.2f A%g %g 0 0 0 %.2f %.2f Z" % (
        *first, R, R, *last, S, S, *first)
    balls = [ball(end + (2.0 * math.pi - 2.0 * end) * (i + 0.5) / BALLS) for i in range(BALLS)]
    circles = "\n".join('    <circle cx="%.2f" cy="%.2f" r="%.2f"/>' % each for each in balls)
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later; drawn by scripts/make_icon.py -->
<svg xmlns="http://www.w3.org/2000/svg" width="256" height="256" viewBox="0 0 256 256">
  <defs>
    <linearGradient id="night" x1="0" y1="0" x2="0" y2="1">
      <stop offset="0" stop-color="#22345c"/>
      <stop offset="1" stop-color="#0f1830"/>
    </linearGradient>
  </defs>
  <rect x="8" y="8" width="240" height="240" rx="52" fill="url(#night)"/>
  <path d="{crescent}" fill="#f3ead0" fill-opacity="0.14"/>
  <g fill="#8ec5ff" fill-opacity="0.30" stroke="#8ec5ff" stroke-opacity="0.75" stroke-width="2.5">
{circles}
  </g>
  <path d="{crescent}" fill="none" stroke="#f7efd8" stroke-width="7" stroke-linejoin="round"/>
  <polyline points="{points(axis)}" fill="none" stroke="#ff8f5a" stroke-width="8" stroke-linecap="round"/>
</svg>
"""


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    picture = FOLDER / "mesecina.svg"
    picture.write_text(drawing())
    for size in SIZES:
        subprocess.run(["rsvg-convert", "-w", str(size), "-h", str(size), picture, "-o", FOLDER / f"{size}.png"],
                       check=True)


if __name__ == "__main__":
    main()
