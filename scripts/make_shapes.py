#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the sample shapes of assets/shapes, and checks them.

    scripts/make_shapes.py                   the shapes given by formula
    scripts/make_shapes.py --sources DIR     those traced from pictures, fonts and maps as well (see LICENCES.md)
    scripts/make_shapes.py --check           nothing is written; every file's one-step crust is compared with its curve

A shape is a list of polylines, much finer than the samples. They are smoothed a little where the source has corners,
scaled to 400 units, and sampled with spacing proportional to the local feature size, but never coarser than a cap, so
that the picture looks smooth. The local feature size is bounded by the largest empty balls that touch the curve:
r(p) = min over q of |q - p|^2 / (2 n.(q - p)), n the normal at p, and by r(p') + |p - p'| along the curve.

Only the standard library is used; a minute or two is the price.
"""
import argparse
import json
import math
import pathlib
import sys

SIZE = 400.0
COARSE = 1800  # points at which the feature size is taken, all curves of a shape together
OUTPUT = pathlib.Path(__file__).resolve().parent.parent / "assets" / "shapes"


# ---------------------------------------------------------------- polylines
class Curve:
    def __init__(self, points, closed=True):
        self.points = list(points)
        self.closed = closed

    def length(self):
        return sum(math.dist(a, b) for a, b in self.segments())

    def segments(self):
        points = self.points + self.points[:1] if self.closed else self.points
        return zip(points, points[1:])

    def mapped(self, function):
        return Curve([function(p) for p in self.points], self.closed)


def resampled(curve, weights, count):
    """`count` points at equal steps of the measure whose density on segment i is weights[i]."""
    segments = list(curve.segments())
    measure = [0.0]
    for (a, b), weight in zip(segments, weights):
        measure.append(measure[-1] + weight * math.dist(a, b))
    steps = count if curve.closed else count - 1
    points, at = [], 0
    for i in range(count):
        wanted = min(measure[-1] * i / steps, measure[-1])
        while at + 1 < len(segments) and measure[at + 1] <= wanted:
            at += 1
        (a, b), low, high = segments[at], measure[at], measure[at + 1]
        t = min(1.0, (wanted - low) / (high - low)) if high > low else 0.0
        points.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
    return points


def evenly(curve, count):
    return Curve(resampled(curve, [1.0] * len(list(curve.segments())), count), curve.closed)


def smoothed(curve, sigma):
    """Gaussian along the curve. (2G - GG, which keeps sizes, makes narrow inlets cross themselves.)"""
    if sigma <= 0.0:
        return curve
    spacing = curve.length() / len(curve.points)
    reach = max(1, int(3.0 * sigma / spacing))
    kernel = [math.exp(-0.5 * (i * spacing / sigma) ** 2) for i in range(-reach, reach + 1)]
    total = sum(kernel)

    def once(values):
        n = len(values)
        return [sum(k * values[(i + j - reach) % n] for j, k in enumerate(kernel)) / total for i in range(n)]

    axes = [once([p[axis] for p in curve.points]) for axis in (0, 1)]
    return Curve(zip(*axes), True)


def to_size(curves):
    """Centred, the larger side `SIZE`."""
    xs = [p[0] for c in curves for p in c.points]
    ys = [p[1] for c in curves for p in c.points]
    scale = SIZE / max(max(xs) - min(xs), max(ys) - min(ys))
    cx, cy = (max(xs) + min(xs)) / 2.0, (max(ys) + min(ys)) / 2.0
    return [c.mapped(lambda p: ((p[0] - cx) * scale, (p[1] - cy) * scale)) for c in curves]


# ---------------------------------------------------------------- sampling
def feature_sizes(curves):
    """One list per curve: an upper bound of the local feature size at each point."""
    everything = [p for c in curves for p in c.points]
    result = []
    for curve in curves:
        points, n, sizes = curve.points, len(curve.points), []
        for i, (px, py) in enumerate(points):
            before = points[i - 1] if curve.closed or i > 0 else points[0]
            after = points[(i + 1) % n] if curve.closed or i + 1 < n else points[-1]
            tx, ty = after[0] - before[0], after[1] - before[1]
            norm = math.hypot(tx, ty) or 1.0
            nx, ny = -ty / norm, tx / norm
            least = SIZE
            for qx, qy in everything:
                dx, dy = qx - px, qy - py
                along = abs(nx * dx + ny * dy)
                square = dx * dx + dy * dy
                if square < 2.0 * least * along and square > 0.0:
                    least = square / (2.0 * along)
            sizes.append(least)
        for order in (range(2 * n), range(2 * n, 0, -1)):
            for k in order:
                i, j = k % n, (k - 1) % n if order.step > 0 else (k + 1) % n
                if not curve.closed and abs(i - j) != 1:
                    continue
                sizes[i] = min(sizes[i], sizes[j] + math.dist(points[i], points[j]))
        result.append(sizes)
    return result


def sampled(curves, epsilon, cap, floor):
    """Feature sizes come from a coarser copy, positions from the curves themselves."""
    total = sum(c.length() for c in curves)
    coarse = [evenly(c, max(48, round(COARSE * c.length() / total))) for c in curves]
    samples = []
    for curve, guide, sizes in zip(curves, coarse, feature_sizes(coarse)):
        density = [1.0 / min(cap, max(floor, 2.0 * epsilon * s)) for s in sizes]
        if curve.closed:
            density.append(density[0])
        step = guide.length() / (len(density) - 1)
        weights, along = [], 0.0
        scale = guide.length() / curve.length()
        for a, b in curve.segments():
            long = math.dist(a, b) * scale
            at = min((along + 0.5 * long) / step, len(density) - 1.001)
            i = int(at)
            weights.append(density[i] + (at - i) * (density[i + 1] - density[i]))
            along += long
        measure = sum(w * math.dist(a, b) for w, (a, b) in zip(weights, curve.segments()))
        count = max(8, math.ceil(measure)) + (0 if curve.closed else 1)
        samples.append(Curve(resampled(curve, weights, count), curve.closed))
    return samples


# ---------------------------------------------------------------- shapes by formula
FINE = 24000  # points of a curve given by formula; its chords are then true to 1e-4 units


def over(function, begin, end, closed=True):
    steps = FINE if closed else FINE - 1
    return Curve([function(begin + (end - begin) * i / steps) for i in range(FINE)], closed)


def circle(x, y, r):
    return over(lambda t: (x + r * math.cos(t), y + r * math.sin(t)), 0.0, 2.0 * math.pi)


def polar(radius):
    return over(lambda t: (radius(t) * math.cos(t), radius(t) * math.sin(t)), 0.0, 2.0 * math.pi)


def box(half_width, half_height, corner):
    points, n = [], FINE // 8
    for k, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        for i in range(n + 1):
            angle = math.pi / 2 * (k + i / n)
            points.append((sx * (half_width - corner) + corner * math.cos(angle),
                           sy * (half_height - corner) + corner * math.sin(angle)))
    return Curve(points)


def thickened(center, half_width):
    """Outline of a stroke: both sides of the curve center(t), t in 0 .. 1, and half circles at its ends."""
    n, left, right = FINE // 3, [], []
    for i in range(n + 1):
        t = i / n
        (ax, ay), (bx, by) = center(t - 1e-5), center(t + 1e-5)
        angle = math.atan2(by - ay, bx - ax)
        x, y = center(t)
        w = half_width(t)
        left.append((x - w * math.sin(angle), y + w * math.cos(angle)))
        right.append((x + w * math.sin(angle), y - w * math.cos(angle)))
        if i in (0, n):
            turn = math.pi / 2 if i == 0 else -math.pi / 2
            cap = [(x + w * math.cos(angle + turn + math.pi * k / 800), y + w * math.sin(angle + turn + math.pi * k / 800))
                   for k in range(1, 800)]
            first_cap, last_cap = (cap, None) if i == 0 else (first_cap, cap)
    return Curve(right + last_cap + left[::-1] + first_cap)


def ellipse():
    return [over(lambda t: (2 * math.cos(t), math.sin(t)), 0.0, 2.0 * math.pi)]


def bean():
    return [polar(lambda t: 1.0 + 0.45 * math.cos(t) + 0.28 * math.cos(2 * t + 0.6) - 0.12 * math.sin(3 * t))]


def trefoil():
    return [polar(lambda t: 1.0 + 0.42 * math.cos(3 * t - math.pi / 2) + 0.06 * math.cos(6 * t))]


def rounded_rectangle():
    return [box(200, 120, 30)]


def gear(teeth=12):
    points = []
    for k in range(teeth):
        start = 2 * math.pi * k / teeth
        for share, radius in ((0.00, 150), (0.22, 150), (0.32, 200), (0.68, 200), (0.78, 150)):
            angle = start + share * 2 * math.pi / teeth
            points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return [smoothed(evenly(Curve(points), 6000), 3.0), circle(0, 0, 62)]


def eccentric_ring():
    return [circle(0, 0, 200), circle(70, 0, 75)]


def plate():
    return [box(200, 140, 36), circle(-105, 30, 58), circle(35, -55, 44), circle(105, 55, 36)]


def two_arms():
    def center(t, sign):
        angle, radius = 1.75 * math.pi * t, 40.0 + 160.0 * t
        return (sign * radius * math.cos(angle), sign * radius * math.sin(angle))

    return [thickened(lambda t, s=sign: center(t, s), lambda t: 30.0 - 22.0 * t) for sign in (1, -1)]


def open_heart():
    return [over(lambda t: (13.4 * math.sin(t) - 3.2 * math.sin(3 * t),
                            13 * math.cos(t) - 5 * math.cos(2 * t) - 2 * math.cos(3 * t) - math.cos(4 * t)),
                 0.45, 2.0 * math.pi - 0.45, closed=False)]


def broken_ring():
    hole = over(lambda t: (88 * math.cos(t), 88 * math.sin(t)), 0.2, 2.0 * math.pi - 0.2, closed=False)
    return [circle(0, 0, 200), hole]


# ---------------------------------------------------------------- shapes from sources
def read_source(folder, name):
    words = (folder / f"{name}.poff").read_text().split()
    values = [float(w) for w in words[4:4 + 2 * int(words[1])]]
    points = list(zip(values[::2], values[1::2]))
    curves, at = [], 0
    for count in (int(w) for w in (folder / f"{name}.contours").read_text().split()):
        curves.append(Curve(points[at:at + count]))
        at += count
    return curves


def traced(name, smoothing, smallest=0.0, is_map=False):
    """`smoothing` in units of the finished shape; curves shorter than `smallest` are left out."""

    def make(folder):
        curves = read_source(folder, name)
        if is_map:
            latitude = math.radians(sum(p[1] for p in curves[0].points) / len(curves[0].points))
            curves = [c.mapped(lambda p: (p[0] * math.cos(latitude), p[1])) for c in curves]
        curves = [c for c in to_size(curves) if c.length() >= smallest]
        return [smoothed(evenly(c, max(200, round(c.length() / 0.3))), smoothing) for c in curves]

    return make


FORMULA = "GPL-3.0-or-later (made by formula for this program)"
CLIP_ART = "Public domain (Open Clip Art Library)"
DEJAVU = "Bitstream Vera licence, changes public domain (DejaVu fonts)"
EARTH = "Public domain (Natural Earth)"

# file, name, description, licence, how to make it, epsilon, cap and floor of the spacing
SHAPES = [
    ("elephant", "Elephant", "One outline: the axis runs through body, trunk, legs and tail.", CLIP_ART,
     traced("svg_elephant_3000", 1.4), 0.3, 3.8, 0.5),
    ("lizard", "Lizard", "A gecko with spread toes and a curled tail: its medial axis is its skeleton.", CLIP_ART,
     traced("svg_lizard_2500", 1.0), 0.42, 4.4, 0.9),
    ("kanji", "Kanji", "The character for love: eight parts, narrow gaps between them, one hole.", CLIP_ART,
     traced("svg_kanji_love_3000", 0.9), 0.27, 3.4, 0.6),
    ("ampersand", "Ampersand", "A glyph of DejaVu Sans: corners send an axis branch into each of them.", DEJAVU,
     traced("glyph_dejavusans_ampersand_2000", 0.9), 0.32, 3.6, 0.8),
    ("letter-g", "Letter g", "A glyph of DejaVu Serif with one counter.", DEJAVU,
     traced("glyph_dejavuserif_g_1500", 0.9), 0.27, 3.4, 0.6),
    ("sulawesi", "Sulawesi", "The coastline of an island with four peninsulas, slightly smoothed.", EARTH,
     traced("ne_sulawesi_10m", 1.6, is_map=True), 0.3, 3.0, 0.5),
    ("vanern", "Lake Vänern", "A lake with islands, slightly smoothed: holes make cycles of the axis.", EARTH,
     traced("ne_vanern", 3.2, is_map=True), 0.28, 3.2, 0.35),
    ("trefoil", "Trefoil", "Three lobes: a smooth curve whose axis has one branch point.", FORMULA,
     trefoil, 0.25, 5.0, 1.0),
    ("ellipse", "Ellipse", "The axis is known exactly: a segment between two centres of curvature.", FORMULA,
     ellipse, 0.2, 6.0, 1.0),
    ("bean", "Bean", "A smooth bent blob.", FORMULA, bean, 0.25, 5.0, 1.0),
    ("rounded-rectangle", "Rounded rectangle", "Four diagonal branches end at the centres of the corner arcs.",
     FORMULA, rounded_rectangle, 0.25, 6.0, 1.0),
    ("gear", "Gear", "Twelve teeth and a bore: a cycle with a branch into every tooth.", FORMULA,
     gear, 0.3, 4.0, 0.8),
    ("eccentric-ring", "Eccentric ring", "A disk with a hole off its centre: the axis is an ellipse.", FORMULA,
     eccentric_ring, 0.2, 6.0, 1.0),
    ("plate", "Plate with three holes", "Three cycles and four corner branches.", FORMULA,
     plate, 0.25, 5.0, 1.0),
    ("two-arms", "Two arms", "Two components that curl around each other.", FORMULA,
     two_arms, 0.25, 5.0, 0.8),
    ("open-heart", "Open heart", "An open stroke: the crust bridges the gap between its ends by itself.", FORMULA,
     open_heart, 0.25, 4.0, 0.8),
    ("broken-ring", "Broken ring", "A closed curve around an open one, whose gap the crust bridges.", FORMULA,
     broken_ring, 0.25, 5.0, 0.8),
]


# ---------------------------------------------------------------- files
def poff(curves):
    lines = ["POFF %d 0 0" % sum(len(c.points) for c in curves)]
    loops, at = [], 0
    for curve in curves:
        for x, y in curve.points:
            lines.append("%.9g %.9g" % (round(x, 5) + 0.0, round(y, 5) + 0.0))
        ids = " ".join(str(at + i) for i in range(len(curve.points)))
        loops.append("# loop %s %s" % ("closed" if curve.closed else "open", ids))
        at += len(curve.points)
    return "\n".join(lines + loops) + "\n"


def read_poff(text):
    lines = text.splitlines()
    n = int(lines[0].split()[1])
    points = [tuple(map(float, line.split())) for line in lines[1:n + 1]]
    loops = [line.split()[2:] for line in lines[n + 1:] if line.startswith("# loop")]
    return points, [(words[0] == "closed", [int(w) for w in words[1:]]) for words in loops]


def faults(points, loops):
    """Curve edges that are not crust, and crust edges between near samples that are not on the curve.

    The two ends of an open curve may be joined: the crust knows nothing of openness.
    """
    curve, bridges = set(), set()
    for closed, ids in loops:
        if not closed:
            bridges.add((min(ids[0], ids[-1]), max(ids[0], ids[-1])))
        for a, b in zip(ids, ids[1:] + (ids[:1] if closed else [])):
            curve.add((min(a, b), max(a, b)))
    near = [sorted(range(len(points)), key=lambda j: math.dist(p, points[j]))[1:15] for p in points]

    def is_crust(q, r):
        (qx, qy), (rx, ry) = points[q], points[r]
        least = [math.inf, math.inf]  # cotangents of the largest angles on both sides
        for group in (near[q], near[r], range(len(points))):
            for i in group:
                if i in (q, r):
                    continue
                ax, ay, bx, by = qx - points[i][0], qy - points[i][1], rx - points[i][0], ry - points[i][1]
                side, along = ax * by - ay * bx, ax * bx + ay * by
                if side == 0.0:
                    if along <= 0.0:
                        return False
                    continue
                left = side > 0.0
                least[left] = min(least[left], along / abs(side))
                if least[left] < 0.0 or least[0] * least[1] < 1.0:
                    return False
        return True

    missing = [e for e in curve if not is_crust(*e)]
    others = {(min(a, b), max(a, b)) for a in range(len(points)) for b in near[a]} - curve - bridges
    return missing, [e for e in others if is_crust(*e)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sources", type=pathlib.Path, help="folder with the POFF files that shapes were traced from")
    parser.add_argument("--check", action="store_true", help="write nothing, compare crusts with curves")
    parser.add_argument("--only", help="one shape by its file name without extension")
    arguments = parser.parse_args()
    is_good = True
    for file, _, _, _, make, epsilon, cap, floor in SHAPES:
        path = OUTPUT / f"{file}.poff"
        if arguments.only and arguments.only != file:
            continue
        needs_source = make.__name__ == "make"
        if not arguments.check and (arguments.sources or not needs_source):
            curves = to_size(make(arguments.sources) if needs_source else make())
            path.write_text(poff(sampled(curves, epsilon, cap, floor)))
        points, loops = read_poff(path.read_text())
        missing, foreign = faults(points, loops)
        is_good = is_good and not missing and not foreign
        where = ["(%g, %g)" % points[a] for a, _ in (missing + foreign)[:4]]
        print("%-20s %5d samples %3d curves %6d bytes   missing %d, foreign %d %s" %
              (file, len(points), len(loops), path.stat().st_size, len(missing), len(foreign), " ".join(where)), flush=True)
    if not arguments.check:
        index = [{"file": f"{file}.poff", "name": name, "description": text, "licence": licence}
                 for file, name, text, licence, *_ in SHAPES]
        (OUTPUT / "index.json").write_text(json.dumps(index, indent=2, ensure_ascii=False) + "\n")
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
