#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the picture of README.md from a run of geodrome: a sample, the surface through it, distances and paths.

    tools/demo/picture.py build/release/bin/geodrome tools/demo/torus.svg

Uses Python's standard library alone. The same program gives the same picture, byte for byte.
"""
import csv
import math
import pathlib
import subprocess
import sys
import tempfile
import textwrap

SCALE = 180  # units of the picture per unit of length
PANEL = (600, 450)
SOURCE = (-0.35, -0.98, 0.39)  # the source is the sample's point nearest to this place, paths go to those nearest to:
PATH_ENDS = [(1.3, -0.45, 0.1), (0.45, 0.95, 0.4), (-0.75, 0.9, 0.4)]
LEVELS = 24  # isolines
RAMP = ["#fde9a9", "#f8b75c", "#ea7a4b", "#c2466a", "#7f2f7d", "#3a2a68"]  # near to far


def run(geodrome, *arguments):
    subprocess.run([geodrome, *arguments], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def numbers(line):
    return [float(word) for word in line.split()]


class Run:
    """A run of the program: the sample, the surface, distances from the source to all vertices, and paths."""

    def __init__(self, geodrome, folder):
        sample = f"{folder}/torus.xyz"
        run(geodrome, "shape", "torus", "--points", "2000", "--sampling", "blue", "-o", sample)
        self.points = [numbers(line) for line in pathlib.Path(sample).read_text().splitlines()]
        stages = ["--decimator", "none", "--quiet"]
        source = str(self.nearest(SOURCE))
        row, surface = f"{folder}/row.csv", f"{folder}/torus.off"
        run(geodrome, "distances", sample, "--sources", source, "-o", row, "--surface", surface, *stages)
        self.distances = [float(word) for word in pathlib.Path(row).read_text().split(",")]
        lines = pathlib.Path(surface).read_text().split("\n")
        vertices, faces = (int(word) for word in lines[1].split()[:2])
        self.vertices = [numbers(line) for line in lines[2 : 2 + vertices]]
        self.faces = [[int(word) for word in line.split()[1:4]] for line in lines[2 + vertices : 2 + vertices + faces]]
        assert self.vertices == self.points, "every point is a vertex, so that distances are those of vertices"
        self.source = self.points[int(source)]
        self.paths = [self.path(geodrome, sample, source, end, f"{folder}/path.csv", stages) for end in PATH_ENDS]

    def nearest(self, place):
        return min(range(len(self.points)), key=lambda i: math.dist(self.points[i], place))

    def path(self, geodrome, sample, source, end, file, stages):
        run(geodrome, "path", sample, "--from", source, "--to", str(self.nearest(end)), "-o", file, *stages)
        with open(file, newline="") as rows:
            return [[float(row[axis]) for axis in "xyz"] for row in csv.DictReader(rows)]


class View:
    """A parallel projection from the front and above; remembers which faces are seen, and how near they are."""

    def __init__(self, vertices, faces, left):
        elevation = math.radians(48)
        self.sine, self.cosine, self.left = math.sin(elevation), math.cos(elevation), left
        self.places = [self.place(vertex) for vertex in vertices]
        self.nearest = {}  # pixel: (depth, face), nearer is larger
        for index, face in enumerate(faces):
            self.cover(index, [self.places[i] for i in face])
        self.seen = {face for _, face in self.nearest.values()}

    def place(self, point):
        """Returns x and y in the picture, and the depth: larger is nearer."""
        x, y, z = point
        across, up = x, y * self.sine + z * self.cosine
        depth = -y * self.cosine + z * self.sine
        return self.left + PANEL[0] / 2 + SCALE * across, PANEL[1] / 2 + 6 - SCALE * up, depth

    def cover(self, index, corners):
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = corners
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if area == 0:
            return
        for x in range(math.ceil(min(ax, bx, cx)), math.floor(max(ax, bx, cx)) + 1):
            for y in range(math.ceil(min(ay, by, cy)), math.floor(max(ay, by, cy)) + 1):
                b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
                c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
                if b >= 0 and c >= 0 and b + c <= 1:
                    depth = az + b * (bz - az) + c * (cz - az)
                    self.nearest[x, y] = max(self.nearest.get((x, y), (-math.inf, 0)), (depth, index))

    def sees(self, place):
        x, y, depth = place
        return depth > self.nearest.get((round(x), round(y)), (-math.inf, 0))[0] - 0.05


def mixed(first, second, share):
    """Returns the colour at `share` of the way between two."""
    pairs = zip(bytes.fromhex(first[1:]), bytes.fromhex(second[1:]))
    return "#" + "".join(f"{round(a + share * (b - a)):02x}" for a, b in pairs)


def colour(share, light):
    """Returns the colour of a distance, as a share of the largest, on a face that is lit by `light` (0 to 1)."""
    place = min(share, 0.999) * (len(RAMP) - 1)
    flat = mixed(RAMP[int(place)], RAMP[int(place) + 1], place % 1)
    return mixed(flat, "#ffffff", (light - 0.7) * 0.9) if light > 0.7 else mixed(flat, "#1c1433", (0.7 - light) * 0.55)


def light_on(corners):
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = corners
    u, v = (bx - ax, by - ay, bz - az), (cx - ax, cy - ay, cz - az)
    normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    sun = (-0.35, -0.45, 0.82)
    return max(0.0, sum(n * s for n, s in zip(normal, sun)) / math.hypot(*normal))


def path_data(places):
    """Returns a polyline in tenths of a pixel, each step relative to the one before, since that is shorter.

    A minus sign needs no space before it; every tenth number has one all the same, where a line may be broken.
    """
    places = [(round(place[0] * 10), round(place[1] * 10)) for place in places]
    steps = [str(step) for p, q in zip(places, places[1:]) for step in (q[0] - p[0], q[1] - p[1])]
    spaced = ("" if step[0] == "-" and k % 10 else " " for k, step in enumerate(steps))
    return f"M{places[0][0]} {places[0][1]}l" + "".join(space + step for space, step in zip(spaced, steps)).lstrip()


def grown(corners):
    """Returns a triangle that is half a pixel wider on all sides, so that no gaps show between neighbours."""
    middle = [sum(corner[axis] for corner in corners) / 3 for axis in (0, 1)]
    for corner in corners:
        away = (corner[0] - middle[0], corner[1] - middle[1])
        size = 1 + 0.7 / max(math.hypot(*away), 0.7)
        yield middle[0] + size * away[0], middle[1] + size * away[1]


def drawn_faces(result, view):
    """Returns the faces that are seen, from back to front."""
    largest = max(result.distances)
    for index in sorted(view.seen, key=lambda i: sum(view.places[v][2] for v in result.faces[i])):
        face = result.faces[index]
        share = sum(result.distances[v] for v in face) / 3 / largest
        shade = colour(share, light_on([result.vertices[v] for v in face]))
        yield f'<path fill="{shade}" d="{path_data(list(grown([view.places[v] for v in face])))}z"/>'


def part(places, k, parts):
    return places[len(places) * k // parts : len(places) * (k + 1) // parts]


def drawn_points(view, classes=8):
    """Returns the points of the sample, nearer ones darker and larger; those of a class in one element."""
    places = sorted(view.places, key=lambda place: place[2])
    for k in range(classes):
        dots = "".join(f"M{round(x * 10)} {round(y * 10)}h0" for x, y, _ in part(places, k, classes))
        near = (k + 0.5) / classes
        shade = mixed("#d5d2de", "#3a2a68", near)
        yield f'<path stroke="{shade}" stroke-width="{round(24 + 20 * near)}" d="{dots}"/>'


def crossing(result, view, edge, level):
    """Returns the place on an edge at which the distance is `level`."""
    first, second = (result.distances[v] for v in edge)
    share = (level - first) / (second - first)
    return tuple(a + share * (b - a) for a, b in zip(view.places[edge[0]], view.places[edge[1]]))


def isoline(result, view, level):
    """Returns the seen parts of an isoline as polylines: its segments, one a face, put end to end."""
    neighbours = {}
    for index in sorted(view.seen):
        a, b, c = result.faces[index]
        ends = [tuple(sorted(e)) for e in ((a, b), (b, c), (c, a))]
        ends = [e for e in ends if (result.distances[e[0]] < level) != (result.distances[e[1]] < level)]
        places = [crossing(result, view, end, level) for end in ends]
        if len(ends) == 2 and all(view.sees(place) for place in places):
            neighbours.setdefault(ends[0], []).append(ends[1])
            neighbours.setdefault(ends[1], []).append(ends[0])
    for start in sorted(neighbours, key=lambda end: (len(neighbours[end]), end)):  # ends of open lines first
        line = [start]
        while neighbours[line[-1]]:
            following = neighbours[line[-1]].pop()
            neighbours[following].remove(line[-1])
            line.append(following)
        if len(line) > 1:
            yield path_data([crossing(result, view, edge, level) for edge in line])


def seen_parts(view, places):
    seen = []
    for place in [*places, None]:
        if place is not None and view.sees(place):
            seen.append(place)
        else:
            if len(seen) > 1:
                yield path_data(seen)
            seen = []


def finer(line):
    """Returns a polyline with ten points for each segment, so that hidden parts end where they are hidden."""
    for first, second in zip(line, line[1:]):
        yield from ([a + k / 10 * (b - a) for a, b in zip(first, second)] for k in range(10))
    yield line[-1]


def dot(place, radius, colour):
    return f'<circle cx="{round(place[0] * 10)}" cy="{round(place[1] * 10)}" r="{radius}" fill="{colour}"/>'


def drawn_lines(result, view):
    levels = [max(result.distances) * k / LEVELS for k in range(1, LEVELS)]
    lines = "".join(line for level in levels for line in isoline(result, view, level))
    yield f'<path stroke="#fff" stroke-opacity=".75" stroke-width="9" d="{lines}"/>'
    paths = [[view.place(point) for point in finer(path)] for path in result.paths]
    hidden = "".join(path_data([view.place(point) for point in path]) for path in result.paths)
    yield f'<path stroke="#12303a" stroke-width="11" stroke-dasharray="1 24" d="{hidden}"/>'
    seen = "".join(line for path in paths for line in seen_parts(view, path))
    yield f'<path stroke="#12303a" stroke-width="28" d="{seen}"/>'


def picture(result):
    sample = View(result.vertices, result.faces, 0)
    surface = View(result.vertices, result.faces, PANEL[0])
    width, height = 2 * PANEL[0], PANEL[1]
    yield f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width * 10} {height * 10}" width="{width}" '
    yield f'height="{height}"><title>Points of a torus; geodesic distances from one of them on the surface through '
    yield "them, with isolines and shortest paths</title>"
    yield f'<rect width="{width * 10}" height="{height * 10}" fill="#fff"/>'
    yield from drawn_faces(result, surface)
    yield '<g fill="none" stroke-linecap="round" stroke-linejoin="round">'
    yield from drawn_points(sample)
    yield from drawn_lines(result, surface)
    yield "</g>"
    for path in result.paths:
        yield dot(surface.place(path[-1]), 45, "#12303a")
    yield dot(surface.place(result.source), 75, "#12303a")
    yield dot(surface.place(result.source), 45, "#fff") + "</svg>"


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: picture.py GEODROME OUT.svg")
    with tempfile.TemporaryDirectory() as folder:
        result = Run(sys.argv[1], folder)
    lines = (textwrap.fill(line, 116, break_long_words=False, break_on_hyphens=False) for line in picture(result))
    pathlib.Path(sys.argv[2]).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
