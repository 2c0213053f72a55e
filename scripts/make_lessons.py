#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the lessons of assets/lessons: sessions with captions, by a built program.

    scripts/make_lessons.py                  with build/release/mesecina, or $MESECINA_BINARY
    scripts/make_lessons.py --check          nothing is written; the exit code says whether the files are up to date

A lesson is data, a timeline of edits, and steps, each with a caption and the layers that are seen. Samples that an
evolution moves are asked from the program; everything else is here. Only the standard library is used.
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "assets" / "lessons"
PROGRAM = os.environ.get("MESECINA_BINARY", str(ROOT / "build" / "release" / "mesecina"))
DIGITS = 4  # of coordinates


def program(*arguments, text=""):
    return subprocess.run([PROGRAM, *arguments], input=text, capture_output=True, text=True, check=True).stdout


def styles():
    """The style that each layer has by itself, as sessions write it."""
    out = {}
    for layer in json.loads(program("list", "layers", "--json")):
        style = layer["style"]
        out[layer["id"]] = {"color": style["color"], "opacity": style["opacity"], "point_size": style["point_size_px"],
                            "line_width": style["line_width_px"], "dashed": style["dashed"], "flat": style["flat"]}
        if not style["thin_when_dense"]:
            out[layer["id"]]["thin_when_dense"] = False
    return out


STYLES = styles()


def flat(points):
    return [round(x, DIGITS) for point in points for x in point]


def polar_curve(radius, count, center=(0.0, 0.0)):
    """Samples of r(t), evenly spaced along the curve; radius is a function of the angle."""
    fine = 20_000
    at = lambda t: (center[0] + radius(t) * math.cos(t), center[1] + radius(t) * math.sin(t))
    points = [at(2.0 * math.pi * i / fine) for i in range(fine + 1)]
    lengths = [0.0]
    for a, b in zip(points, points[1:]):
        lengths.append(lengths[-1] + math.dist(a, b))
    out, k = [], 0
    for i in range(count):
        while lengths[k + 1] < lengths[-1] * i / count:
            k += 1
        out.append(points[k])
    return out


def read_shape(name):
    """Samples of a sample shape, along its first loop."""
    lines = (ROOT / "assets" / "shapes" / f"{name}.poff").read_text().splitlines()
    count = int(lines[0].split()[1])
    points = [tuple(map(float, line.split())) for line in lines[1:1 + count]]
    loop = next(line for line in lines if line.startswith("# loop"))
    return [points[int(word)] for word in loop.split()[3:]]


def box_around(points, room):
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    margin = room * max(max(xs) - min(xs), max(ys) - min(ys))
    return [round(v, 2) for v in (min(xs) - margin, min(ys) - margin, max(xs) + margin, max(ys) + margin)]


def evolved(points, evolution, steps, *settings):
    """Where an evolution brings samples of one closed loop."""
    text = f"POFF {len(points)} 0 0\n" + "".join(f"{x!r} {y!r}\n" for x, y in points)
    text += "# loop closed " + " ".join(map(str, range(len(points)))) + "\n"
    arguments = ["evolve", "-", "--evolution", evolution, "--steps", str(steps)]
    for setting in settings:
        arguments += ["--set", setting]
    lines = program(*arguments, text=text).splitlines()
    return [tuple(map(float, line.split()[:2])) for line in lines[1:1 + len(points)]]


class Lesson:
    def __init__(self, title, points=(), balls=(), view=None, closed=True):
        self.title, self.view = title, view
        self.points = [tuple(round(x, DIGITS) for x in p) for p in points]
        self.data = {"samples": flat(points)}
        if points and closed:
            self.data["contours"] = [{"closed": True, "points": list(range(len(points)))}]
        if balls:
            self.data["balls"] = flat(balls)
        self.timeline, self.steps, self.settings = [], [], None

    def compute(self, precision, shortcut=True):
        self.settings = {"precision": precision, "parameters": {"union-shortcut": 1 if shortcut else 0}}

    def edit(self, name, **changes):
        self.timeline.append({"edit": {"name": name, **changes}})

    def move_to(self, name, points, **more):
        moves = []
        for i, point in enumerate(points):
            moves += [i, *flat([point])]
        self.edit(name, move=moves, **more)
        self.points = [tuple(round(x, DIGITS) for x in p) for p in points]

    def step(self, caption, *layers, view=None, **changed):
        """Layers from the bottom; changed styles by layer, with _ for -."""
        shown = []
        for layer in layers:
            style = {**STYLES[layer], **changed.get(layer.replace("-", "_"), {})}
            shown.append({"layer": layer, "style": style, "visible": True})
        lines = [line.strip() for line in caption.strip().splitlines()]
        out = {"caption": "\n".join(lines), "layers": {"layers": shown}}
        if self.timeline:
            out["position"] = len(self.timeline)
        if self.settings:
            out["settings"] = self.settings
        if view or self.view:
            out["view"] = view or self.view
        self.steps.append(out)

    def text(self):
        dump = lambda value: json.dumps(value, ensure_ascii=False, separators=(",", ":"), sort_keys=True)
        head = {"title": self.title, "data": self.data}
        if self.view:
            head["view"] = self.view
        head["layers"] = self.steps[0]["layers"]
        out = '{"mesecina":"session","schema":1,\n' + dump(head)[1:-1]
        out += ',\n"lesson":{"title":' + dump(self.title) + ',"steps":[\n'
        out += ",\n".join(map(dump, self.steps)) + "]}"
        return out + ',\n"timeline":[\n' + ",\n".join(map(dump, self.timeline)) + "\n]}\n"


def circle_through(a, b, c):
    d = 2.0 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    if d == 0.0:
        return None
    b2 = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
    c2 = (c[0] - a[0]) ** 2 + (c[1] - a[1]) ** 2
    x = ((c[1] - a[1]) * b2 - (b[1] - a[1]) * c2) / d
    y = ((b[0] - a[0]) * c2 - (c[0] - a[0]) * b2) / d
    return (a[0] + x, a[1] + y), math.hypot(x, y)


def corners_opposite(points, i, j):
    """The third corners of the two Delaunay triangles at an edge."""
    out = []
    for k, corner in enumerate(points):
        if k in (i, j):
            continue
        circle = circle_through(points[i], points[j], corner)
        if circle and all(math.dist(p, circle[0]) >= circle[1] - 1e-9 for p in points):
            out.append(k)
    assert len(out) == 2, out
    return out


def angle(points, corner, i, j, name):
    """An annotation that measures the angle at a corner. Its first two anchors are the legs, its last the corner."""
    return {"kind": "angle", "at": [x for k in (i, corner, j) for x in points[k]],
            "follows": [[i], [corner], [j]], "text": f"$\\{name}$", "letters": 22, "shift": [0, 0]}


FAINT = {"opacity": 0.35}
LINE = {"line_width": 3.0}


def crust():
    trefoil = lambda t: 100.0 * (1.0 + 0.62 * math.sin(3.0 * t) + 0.05 * math.cos(2.0 * t))
    points = polar_curve(trefoil, 60)
    lesson = Lesson("What a crust is", points, view=box_around(points, 0.12), closed=False)
    dots = {"points": {"point_size": 7.0}}
    lesson.step("""# A curve, known by samples
        All that is given is a finite set $P$ of points on a curve.

        Which of them are **neighbours** along it?""", "points", **dots)
    lesson.step("""# Who is nearest
        The **Voronoi diagram** gives each sample its cell: the places that are nearer to it than to any other sample.

        Where three cells meet is a *Voronoi vertex*.""", "voronoi", "points", **dots)
    lesson.step("""# Who meets whom
        Samples whose cells share an edge are joined: the **Delaunay triangulation**.

        Neighbours along a densely sampled curve are among its edges. But which edges are they?""",
                "delaunay", "points", **dots)
    p = lesson.points
    i, j = 16, 17
    a, b = corners_opposite(p, i, j)
    lesson.edit("Annotate", annotations=[angle(p, a, i, j, "alpha"), angle(p, b, i, j, "beta")])
    lesson.step("""# One look at each edge
        An edge is seen from the two corners opposite to it, under angles $\\alpha$ and $\\beta$.

        It is a **crust edge** if
        $\\alpha + \\beta \\le 90$°.

        Then some circle through its ends, centred on its Voronoi edge, holds neither end of that Voronoi edge.
        """, "delaunay", "points", delaunay=FAINT, **dots)
    lesson.edit("Annotate", annotations=[])
    lesson.step("""# The one-step crust
        These are all edges that pass.

        - The test looks at **two triangles** and nothing else.
        - Moving a sample changes the crust near that sample only.""",
                "delaunay", "curve", "points", delaunay=FAINT, curve=LINE, **dots)
    lesson.step("""# Crust or skeleton
        Every edge that fails leaves its **dual** instead: the edge between the two Voronoi cells.

        Together they are the medial axis of the plane without the curve, or nearly so: *inside* and *outside* of it.
        """, "all-medial-axis", "curve", "points", curve=LINE, all_medial_axis=LINE, **dots)
    removed = [k for k in range(len(p)) if k % 4 != 0]
    lesson.edit("Delete samples", remove=removed)
    lesson.step("""# Too few samples
        Every fourth sample is left. Where the curve bends, or comes close to another part of itself, the test is misled.

        Samples with one or three crust edges are marked.""",
                "delaunay", "curve", "points", "curve-defects", delaunay=FAINT, curve=LINE,
                curve_defects={"point_size": 16.0}, **dots)
    lesson.timeline.append({"undo": True})
    lesson.step("""# How dense is dense enough?
        What counts is the **local feature size**: how far a place on the curve is from the medial axis.

        Samples closer together than a small part of it are enough. They may be sparse where the shape is wide and the
        curve is straight; they have to be dense where it is narrow.""",
                "medial-axis", "curve", "points", curve=LINE, medial_axis=LINE, **dots)
    return lesson


def one_step_axis():
    points = read_shape("bean")[::3]
    lesson = Lesson("The one-step axis", points, view=box_around(points, 0.1))
    dots = {"points": {"point_size": 5.0}}
    lesson.step("""# The medial axis
        The places inside of a shape that have **two nearest places** on its boundary, or more.

        It keeps what is essential: one piece for a piece, a cycle around each hole.

        Here nothing is known of the shape but samples.""", "points", **dots)
    lesson.step("""# Inside and outside
        The crust separates them: a triangle is inside if one leaves it to infinity by crossing the crust an odd
        number of times.

        The centre of its circumcircle is an **inner Voronoi vertex**.""",
                "voronoi", "curve", "interior-voronoi-vertices", "points", voronoi=FAINT, **dots)
    lesson.step("""# Inner Voronoi balls
        The circle around each of these centres passes through three samples and has none inside.

        It touches the boundary, nearly, and stays within the shape, nearly.""",
                "interior-voronoi-circles", "curve", "interior-voronoi-vertices", "points", **dots)
    lesson.step("""# Their union
        It is close to the shape, the closer the denser the samples.

        The medial axis of a **union of balls** can be computed exactly. It is made of finitely many segments.""",
                "interior-voronoi-disks", "curve", "points", **dots)
    lesson.step("""# One step
        Of the Voronoi diagram keep the edges with *both* ends inside.

        For dense samples this **is** the medial axis of the union. No other structure is computed: no power diagram, no
        crossings of circles, no square roots.""",
                "interior-voronoi-disks", "curve", "medial-axis", "points", medial_axis=LINE, **dots)
    lesson.compute("exact", shortcut=False)
    lesson.step("""# The same the long way
        Balls, power diagram, dual complex, crossings of circles, *their* Voronoi diagram, in exact numbers: the black
        axis lies on the coloured one.

        Pieces that are in only one of the two would be marked. There are none.""",
                "interior-voronoi-disks", "medial-axis", "a-ball-medial-axis", "axis-difference", "points",
                medial_axis={"line_width": 6.0}, a_ball_medial_axis={"line_width": 1.5, "color": "#000000"}, **dots)
    lesson.compute("fast")
    removed = [k for k in range(len(points)) if k % 4 != 0]
    lesson.edit("Delete samples", remove=removed)
    lesson.step("""# And if samples are sparse?
        Every fourth sample is left. The balls stick out of the shape and the axis is coarse.

        How coarse it may be until it is no longer the axis of the union is a question that the program answers at each
        sample, exactly: see the *theorem light*.""",
                "interior-voronoi-disks", "curve", "medial-axis", "theorem-check", "points", medial_axis=LINE, **dots)
    return lesson


def union_of_balls():
    balls = [(0, 0, 60), (72, 36, 44), (80, -40, 50), (140, 0, 50), (206, 26, 34), (-72, 44, 36), (2, -112, 28)]
    around = [(x + s * r, y + t * r) for x, y, r in balls for s, t in ((1, 0), (-1, 0), (0, 1), (0, -1))]
    lesson = Lesson("A union of balls, step by step", balls=balls, view=box_around(around, 0.06))
    lesson.compute("exact", shortcut=False)
    disks = ("b-inner-disks", "b-inner-circles")
    corners = {"b_v_points": {"point_size": 8.0}}
    lesson.step("""# Balls
        A molecule, a robot's reach, the inner balls of a shape: many things are a **union of balls**.

        Its medial axis can be computed exactly, in five steps.""", *disks, "b-inner-centers")
    lesson.step("""# 1. Power diagram
        The *power* of a place against a ball is the squared distance to its centre less the squared radius.

        Each ball gets the cell in which its power is the least. Cells meet in straight lines.""",
                *disks, "b-ball-power-diagram", "b-inner-centers")
    lesson.step("""# 2. Dual complex
        Centres whose cells meet **within the union** are joined: by an edge where two do, by a triangle where three do.

        It has the holes and pieces of the union: they are *homotopy equivalent*.""",
                *disks, "b-dual-faces", "b-dual-interior-edges", "b-dual-regular-edges", "b-dual-singular-edges",
                "b-inner-centers")
    lesson.step("""# 3. Corners of the boundary
        The boundary of the union consists of arcs. Where two of them meet is a **v-point**.

        Its coordinates have square roots: exact numbers are not for free here.""",
                *disks, "b-union-boundary", "b-v-points", b_union_boundary=LINE, **corners)
    lesson.step("""# 4. Voronoi diagram of the v-points
        Its cells say which corner is the nearest one. The diagram knows nothing of arcs: much of it has nothing to do
        with the axis.""", *disks, "b-union-boundary", "b-v-voronoi", "b-v-points", **corners)
    lesson.step("""# 5. The medial axis
        That diagram within the triangles of the dual complex, and the edges and centres that no triangle has: its
        **singular** parts.

        Attali and Montanvert, 1997; Amenta and Kolluri, 2001.""",
                *disks, "b-dual-faces", "b-union-boundary", "b-ball-medial-axis", "b-v-points",
                b_ball_medial_axis=LINE, **corners)
    return lesson


def where_doubles_lie():
    points = read_shape("bean")[::3]
    lesson = Lesson("Where doubles lie", points, view=box_around(points, 0.1))
    dots = {"points": {"point_size": 5.0}}
    axis = {"a_ball_medial_axis": {"line_width": 2.5, "color": "#000000"}}
    lesson.compute("exact", shortcut=False)
    lesson.step("""# A degenerate input, always
        All inner Voronoi balls that touch a sample pass through **that sample**.

        For the general way to the axis of their union this is the worst case: every dual triangle around the sample has
        an orthogonal circle of radius exactly 0.""",
                "a-inner-disks", "a-inner-circles", "points", **dots)
    lesson.step("""# In exact numbers
        Every sign is what it is. The axis is a clean tree, and its v-points are samples.""",
                "a-inner-disks", "a-ball-medial-axis", "a-v-points", **axis)
    lesson.compute("naive", shortcut=False)
    lesson.step("""# In doubles
        The sign of a rounded zero is a toss of a coin. Triangles of the dual complex go missing, v-points come in
        several copies a last digit apart, and the axis with them.""",
                "a-inner-disks", "a-ball-medial-axis", "a-v-points", **axis)
    lesson.step("""# Every wrong decision
        Edges and triangles of the dual complex that doubles miss, invent or misjudge, found by a comparison with exact
        arithmetic.""", "a-inner-disks", "precision-difference")
    lesson.compute("fast")
    lesson.step("""# Not to ask is better
        The one-step axis needs no such sign: it takes edges of the Voronoi diagram of the samples, and these are
        decided by predicates that are exact and quick.""",
                "a-inner-disks", "curve", "medial-axis", "points", medial_axis=LINE, **dots)
    return lesson


def smoothing():
    points = read_shape("bean")[::2]
    lesson = Lesson("Smoothing and the axis", points, view=box_around(points, 0.1))
    layers = ("interior-voronoi-disks", "curve", "medial-axis", "points")
    look = {"points": {"point_size": 4.0}, "medial_axis": {"line_width": 2.5}}
    lesson.step("""# A smooth curve
        Its axis is short: it ends at centres of curvature, where the boundary bends most.""", *layers, **look)
    noisy = evolved(lesson.points, "noise", 1, "noise-factor=0.22")
    lesson.move_to("Noise", noisy)
    lesson.step("""# A little noise
        Each sample moves a little along its normal. The curve changes little; the axis grows **hairs**, one for
        each bump.

        The medial axis is not stable: however small a bump is, a branch leads to it.""", *layers, **look)
    done = 0
    for steps, words in ((2, """# Laplacian smoothing
        In each step every sample moves *halfway* to the middle of its two neighbours along the curve.

        After two steps the shortest hairs are gone."""),
                         (8, """# Eight steps
        Bumps fade the faster the narrower they are. Of a wave that turns by $\\omega$ from sample to sample each step
        leaves the part $(1 + \\mathrm{cos} \\omega) / 2$."""),
                         (40, """# Forty steps
        What is left of the axis is the branch that carries the shape.

        The price: the curve shrinks as well, slowly.""")):
        lesson.move_to(f"Smooth, {steps} steps", evolved(lesson.points, "smooth", steps - done),
                       state=True)
        done = steps
        lesson.step(words, *layers, **look)
    return lesson


LESSONS = {"crust": crust, "one-step-axis": one_step_axis, "union-of-balls": union_of_balls,
           "where-doubles-lie": where_doubles_lie, "smoothing": smoothing}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    is_stale = False
    lessons = {name: make() for name, make in LESSONS.items()}
    texts = {f"{name}.json": lesson.text() for name, lesson in lessons.items()}
    titles = [{"file": f"{name}.json", "title": lesson.title} for name, lesson in lessons.items()]
    texts["index.json"] = json.dumps(titles, indent=2, ensure_ascii=False) + "\n"
    for name, text in texts.items():
        path = OUTPUT / name
        if path.exists() and path.read_text() == text:
            continue
        is_stale = True
        if arguments.check:
            print(f"{path} is not what scripts/make_lessons.py makes", file=sys.stderr)
        else:
            OUTPUT.mkdir(exist_ok=True)
            path.write_text(text)
    return 1 if arguments.check and is_stale else 0


if __name__ == "__main__":
    sys.exit(main())
