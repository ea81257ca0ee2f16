#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the picture of plugins/solver_merged_windows: errors against time on up to six meshes, beside other solvers.

    tools/demo/errors.py build/release/bin plugins/solver_merged_windows/errors.svg MESH...

The folder holds geodrome and geodrome-bench. A MESH is a file or shape:KIND:FACES. The figures are printed as a table.
Uses Python's standard library alone. Ends with a message, and without a picture, if a figure is missing.
"""
import itertools
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

DELTAS = ["1e-1", "1e-2", "1e-3", "1e-4", "1e-5"]
MERGED = [f"merged_windows:delta={delta}" for delta in DELTAS]
OTHERS = ["fast_marching", "heat"]
EXACT = "chen_han"
SOURCES = 5
ROUNDING = 1e-12  # a relative error below this is none

COLOURS = {"merged_windows": "#0072b2", "fast_marching": "#d55e00", "heat": "#117733"}
INK, GREY, GRID = "#222", "#666", "#e4e4e4"
HALO = ' stroke="#fff" stroke-width="3" paint-order="stroke"'
PANEL, GAP, LEFT, TOP, COLUMNS = (252, 224), (30, 62), 64, 84, 3


def output_of(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        reasons = re.findall(r'"error": {[^}]*"(?:text|message)": "(.*)"', done.stdout) or [done.stderr.strip()]
        sys.exit("\n".join([f"status {done.returncode} of {' '.join(map(str, command))}", *reasons]))
    return done.stdout


def figure(value, what):
    """Returns a number that was measured, or ends the program."""
    if not isinstance(value, (int, float)) or not math.isfinite(value) or value < 0:
        sys.exit(f"{what} is missing: the program gave {value}")
    return value


class Figures:
    """What was measured on one mesh: largest and mean |D/d - 1| of each solver, and its seconds."""

    def __init__(self, bin_folder, mesh, scratch):
        self.name, file = mesh_file(bin_folder, mesh, scratch)
        self.errors = self.measured_errors(bin_folder, file)
        self.measure_seconds(bin_folder, file)

    def measured_errors(self, bin_folder, file):
        """Compares all vertices from sources spread evenly among the rows."""
        rows = int(json.loads(output_of(bin_folder / "geodrome", "check", file, "--json"))["input"]["rows"])
        sources = ",".join(str(rows * k // SOURCES) for k in range(SOURCES))
        solvers = [EXACT, *MERGED, *OTHERS]
        stage = "solver=" + ",".join(solvers)
        command = ["compare", file, "--sources", sources, "--stage", stage, "--json", "--quiet"]
        comparison = json.loads(output_of(bin_folder / "geodrome", *command))
        self.faces = comparison["input"]["faces"]
        return {each["name"]: self.errors_of(each, SOURCES * (rows - 1)) for each in comparison["combinations"]}

    def errors_of(self, combination, places):
        what = f"{self.name}: the error of {combination['name']}"
        if combination["error"]:
            sys.exit(f"{what} is missing: {combination['error']['text']}")
        errors = combination["errors"]
        if errors["compared"] != places:
            sys.exit(f"{what} is missing at {places - errors['compared']} of {places} vertices")
        largest = max(figure(errors[name], what) for name in ("max_over", "max_under"))
        return largest, figure(errors["mean"], what)

    def measure_seconds(self, bin_folder, file):
        """Takes ratios within one run, since a busy machine hardly changes them; one exact time scales them all."""
        exact, ratios = [], {}
        for solver in [*MERGED, *OTHERS]:
            text = output_of(bin_folder / "geodrome-bench", "solvers", file, "--solver", solver, "--peer", EXACT,
                             "--sources", SOURCES)
            queries = [float(word) for word in re.findall(r" query +([0-9.]+) s", text)]
            ratio = re.search(r"peer / solver: query ([0-9.]+)", text)
            if len(queries) != 2 or not ratio or float(ratio[1]) == 0:
                sys.exit(f"{self.name}: the time of {solver} is missing in what geodrome-bench prints:\n{text}")
            exact.append(queries[1])
            ratios[solver] = 1 / float(ratio[1])
        self.exact_seconds = sorted(exact)[len(exact) // 2]
        self.ratios = ratios

    def seconds(self, solver):
        return self.exact_seconds * self.ratios[solver]


def mesh_file(bin_folder, mesh, scratch):
    """Returns the name of a mesh, and its file, which is made for a shape."""
    if not mesh.startswith("shape:"):
        return pathlib.Path(mesh).stem, mesh
    if mesh.count(":") != 2:
        sys.exit(f"{mesh}: write shape:KIND:FACES")
    _, kind, faces = mesh.split(":")
    file = f"{scratch}/{kind}.ply"
    output_of(bin_folder / "geodrome", "shape", kind, "--mesh", "--faces", faces, "-o", file)
    return kind, file


def table(meshes):
    yield "| mesh | faces | solver | largest | mean | ms | exact / it |"
    yield "|---|---|---|---|---|---|---|"
    for mesh in meshes:
        yield f"| {mesh.name} | {mesh.faces:,} | {EXACT} | 0 | 0 | {1e3 * mesh.exact_seconds:.3g} | 1 |"
        for solver, ratio in mesh.ratios.items():
            largest, mean = mesh.errors[solver]
            errors = f"{largest:.1e} | {mean:.1e}" if largest > ROUNDING else "0 | 0"
            yield f"| | | {solver} | {errors} | {1e3 * mesh.seconds(solver):.3g} | {1 / ratio:.2f} |"


class Scales:
    """What all panels share: the same decades of errors, and of time as a share of the exact solver's."""

    def __init__(self, meshes):
        errors = [e for mesh in meshes for pair in mesh.errors.values() for e in pair if e > ROUNDING]
        self.bottom, self.top = math.floor(math.log10(min(errors))), math.ceil(math.log10(max(errors)))
        ratios = [1, *itertools.chain(*(mesh.ratios.values() for mesh in meshes))]
        self.first, self.last = math.log10(min(ratios)) - 0.12, math.log10(max(ratios)) + 0.3

    def x(self, ratio):
        return PANEL[0] * (math.log10(ratio) - self.first) / (self.last - self.first)

    def y(self, error):
        """Returns the foot of the panel for an error of 0: a decade below the least power of ten."""
        decades = math.log10(error) - self.bottom + 1 if error > ROUNDING else 0
        return PANEL[1] * (1 - decades / (self.top - self.bottom + 1))


def text(x, y, words, anchor="middle", colour=INK, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}"{more}>{words}</text>'


def line(x0, y0, x1, y1, colour, more=""):
    return f'<path stroke="{colour}" d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}"{more}/>'


def mark(solver, x, y, filled):
    """Returns the mark of a solver: shapes differ beside colours."""
    colour = COLOURS[solver]
    shape = {
        "merged_windows": f"M{x - 4.2:.1f} {y:.1f}a4.2 4.2 0 1 0 8.4 0a4.2 4.2 0 1 0 -8.4 0z",
        "fast_marching": f"M{x - 4:.1f} {y - 4:.1f}h8v8h-8z",
        "heat": f"M{x:.1f} {y - 5:.1f}l5 9h-10z",
    }[solver]
    return f'<path stroke="{colour}" stroke-width="1.6" fill="{colour if filled else "#fff"}" d="{shape}"/>'


def power(exponent):
    return f'10<tspan dy="-4" font-size="9">{str(exponent).replace("-", "−")}</tspan>'


def frame(mesh, scales, in_first_column):
    """Returns title, grid, and labels of one panel; the exact solver's time is the same place in each."""
    width, height = PANEL
    yield text(0, -10, f'<tspan font-weight="600">{mesh.name}</tspan>, {mesh.faces:,} faces', "start")
    for exponent in range(scales.bottom, scales.top + 1):
        y = scales.y(10.0**exponent)
        yield line(0, y, width, y, GRID)
        if in_first_column:
            yield text(-8, y + 4, power(exponent), "end", GREY)
    if in_first_column:
        yield text(-8, height + 4, "0", "end", GREY)
    for decade, digit in itertools.product(range(-3, 6), (1, 2, 5)):
        ratio = digit * 10.0**decade / (1e3 * mesh.exact_seconds)
        if scales.first <= math.log10(ratio) <= scales.last - 0.03:
            yield line(scales.x(ratio), 0, scales.x(ratio), height, GRID)
            yield text(scales.x(ratio), height + 16, f"{digit * 10.0**decade:g}", colour=GREY)
    yield line(0, height, width, height, GREY)
    yield line(scales.x(1), 0, scales.x(1), height, INK, ' stroke-width="2" stroke-dasharray="6 4"')


def labels(mesh, scales):
    """Returns delta beside the points of merged windows: one label for close ones, none where it would cover others."""
    groups = []
    for delta, solver in zip(DELTAS, MERGED):
        y = scales.y(mesh.errors[solver][0])
        if groups and abs(y - groups[-1][1]) < 12:
            groups[-1][0].append(delta)
        else:
            groups.append(([delta], y, scales.x(mesh.ratios[solver])))
    for deltas, y, x in groups:
        middle, width = y - (8 if y == PANEL[1] else 0), 30 * len(deltas)
        words = '<tspan dy="4">, </tspan>'.join(map(power_of, deltas))
        begins = [x + 9, *([scales.x(1) + 6] if 0 < scales.x(1) - x < 60 else []), x - 9 - width]
        begin = next((begin for begin in begins if is_free(mesh, scales, begin, width, middle)), None)
        if begin is not None:
            place, anchor = (x - 9, "end") if begin < x else (begin, "start")
            yield text(place, middle + 4, words, anchor, COLOURS["merged_windows"], HALO)


def is_free(mesh, scales, begin, width, y):
    """Whether a label fits the panel and covers no mark of another solver, nor the line of the exact one."""
    covers = begin - 4 < scales.x(1) < begin + width + 2
    for solver in OTHERS:
        x, (largest, mean) = scales.x(mesh.ratios[solver]), map(scales.y, mesh.errors[solver])
        covers |= begin - 5 < x < begin + width + 5 and largest - 8 < y < mean + 12
    return not covers and 0 <= begin and begin + width <= PANEL[0] + 4


def power_of(delta):
    return power(int(math.log10(float(delta)) - 0.5))


def curve(mesh, scales, which):
    """Returns the points of merged windows, and a line through those whose error is not 0."""
    places = [(scales.x(mesh.ratios[s]), scales.y(mesh.errors[s][which]), mesh.errors[s][which]) for s in MERGED]
    joined = "L".join(f"{x:.1f} {y:.1f}" for x, y, error in places if error > ROUNDING)
    dashes = ' stroke-dasharray="2 3"' if which else ""
    yield f'<path fill="none" stroke="{COLOURS["merged_windows"]}" stroke-width="1.8"{dashes} d="M{joined}"/>'
    yield from (mark("merged_windows", x, y, not which) for x, y, _ in places)


def others(mesh, scales):
    for solver in OTHERS:
        x, (largest, mean) = scales.x(mesh.ratios[solver]), map(scales.y, mesh.errors[solver])
        yield line(x, largest, x, mean, COLOURS[solver], ' stroke-width="1.4"')
        yield mark(solver, x, largest, True) + mark(solver, x, mean, False)


def legend():
    for x, solver in zip((0, 162, 302), ["merged_windows", *OTHERS]):
        yield mark(solver, LEFT + x + 5, 24, True) + mark(solver, LEFT + x + 19, 24, False)
        yield text(LEFT + x + 31, 28, solver, "start")
    yield line(LEFT + 388, 24, LEFT + 414, 24, INK, ' stroke-width="2" stroke-dasharray="6 4"')
    yield text(LEFT + 421, 28, f"time of {EXACT}, whose error is 0", "start")
    deltas = '<tspan dy="4"> to </tspan>'.join([power_of(DELTAS[0]), power_of(DELTAS[-1])])
    words = f"Filled: largest, open: mean |D/d − 1| over all vertices. From the top down: delta = {deltas}"
    yield text(LEFT, 50, words, "start", GREY)


def picture(meshes):
    scales = Scales(meshes)
    rows = math.ceil(len(meshes) / COLUMNS)
    columns = min(COLUMNS, len(meshes))
    width = LEFT + columns * (PANEL[0] + GAP[0])
    height = TOP + rows * (PANEL[1] + GAP[1]) - 14
    yield f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
    yield 'font-family="system-ui, Helvetica, Arial, sans-serif" font-size="13">'
    yield "<title>Errors of approximate distances against processor time</title>"
    yield f'<rect width="{width}" height="{height}" fill="#fff"/>'
    yield from legend()
    for index, mesh in enumerate(meshes):
        row, column = divmod(index, COLUMNS)
        x, y = LEFT + column * (PANEL[0] + GAP[0]), TOP + row * (PANEL[1] + GAP[1])
        yield f'<g transform="translate({x} {y})">'
        yield from frame(mesh, scales, column == 0)
        yield from itertools.chain(curve(mesh, scales, 1), others(mesh, scales), curve(mesh, scales, 0))
        yield from labels(mesh, scales)
        if row == rows - 1:
            yield text(PANEL[0] / 2, PANEL[1] + 38, "milliseconds of one query", colour=GREY)
        yield "</g>"
    yield "</svg>"


def main():
    if not 4 <= len(sys.argv) <= 9:
        sys.exit("usage: errors.py BIN_FOLDER OUT.svg MESH... (up to six)")
    bin_folder = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as scratch:
        meshes = [Figures(bin_folder, mesh, scratch) for mesh in sys.argv[3:]]
    print("\n".join(table(meshes)))
    lines = (textwrap.fill(line, 116, break_long_words=False, break_on_hyphens=False) for line in picture(meshes))
    pathlib.Path(sys.argv[2]).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
