#!/usr/bin/env python3
"""Writes docs/accuracy.* from the tables of tests/benchmark/accuracy: report.py <results> <docs>."""

import csv
import pathlib
import statistics
import sys

import charts
import tables
import tessellation

INTRODUCTION = """# Accuracy

What a lit colour costs and how wrong it is. `scripts/bench accuracy` measures and writes this page; no
figure in it is typed. Errors are in steps of 1/255 of a colour, against a float64 evaluation of the
specification's equation (tests/oracle) of the values that were given to OpenGL. `scripts/test` holds
short runs of all of it to the goals.

- **Mesa** is its fixed function. **Textbook GLSL** is the yardstick: the equation as a textbook writes
  it, on the core profile, one uniform for each value (tests/benchmark/textbook.cpp).
- **fastest**, **default** and **precise** are this library's qualities (`legacy_gl_options.quality`),
  by specialised programs. The general program, which draws a state until it has drawn enough to be
  worth a program of its own, agrees within half a step.
- CPU times are of the process, of vertices alone: triangles whose vertices are lit and that are then
  discarded (`GL_RASTERIZER_DISCARD`), since what the rasteriser costs is the same for all. The variants
  draw in turns in one process; a figure is the median of the ratio over the rounds, and the median over
  {processes} processes. The matrices are random float32 rotations that keep angles only nearly: the
  dearest case; a product of `glRotate` calls is cheaper.

Measured on {machine}, with {driver}.

![run time against error](accuracy.png)

[Class by class](accuracy_classes.png). Tables: [errors](accuracy_errors.csv), [times](accuracy_times.csv),
[stress](accuracy_stress.csv).
"""

TESSELLATION = """
## A finer mesh, or a better interpolation

Sphere and torus under one lamp, shininess 100, flat, Gouraud (`GL_SMOOTH`) and Phong (`GL_PHONG_WIN`, or
the quality per fragment). The reference is the Phong picture of 1024 slices; the error is the root mean
square over the pixels that both pictures cover, so that it tells of shading and not of the silhouette
(the CSV has the error of all pixels too). Whole frames, rasterised: [figures](accuracy_tessellation.csv).

![tessellation](accuracy_tessellation.png)

The highlight that Gouraud interpolation misses on coarse meshes:

![torus](accuracy_torus.png)

![sphere](accuracy_sphere.png)
"""

EPILOGUE = """
## How

- Where every light is a direction, the viewer is infinite and `GL_NORMALIZE` off, light and half vectors
  go through the inverse modelview in double: (n M⁻¹)·l = n·(M⁻¹ l). The shader's normal is the caller's.
- 1 − n·h is formed directly: from the products of the first 12 bits of normal and half vector, which are
  exact, or from the chord between unit vectors. Powers of it square the complement y = 1 − (1 − q)ᵏ by
  y(2 − y), the last factor of 8 by squaring 1 − y itself, or take a logarithm whose series starts from q.
- The sum of two unit vectors that are nearly opposite is turned by what rounding leaves of their lengths;
  (|a|² − |b|²)/2 is taken out of it along the second.
- Precise: vertices and the vectors to lights are pairs of floats where float32 rounds away what lighting
  amplifies, directional lights are split into multiples of 1/2048 and the rest beforehand, and so is a
  normal; its exp2 has all bits, where llvmpipe's has about 20. Outputs are `invariant`, or Mesa's compiler
  would drop what only rounding makes of an expression.
- Vectors are scaled by an exact power of two before they are made unit length (normals with denormal
  components on the CPU, since drivers flush them), attenuation has a unit of distance of its own, and sums of products beyond 1e36 are scaled.

## Out of reach

- Figures in bold are over their goal. Two-sided lighting: llvmpipe's vertices carry one more attribute
  where a fragment program reads `gl_FrontFacing`, filled from a second stream, and copying the vertices
  then takes 10 cycles each instead of 4. Without it (a program that chooses by the colour, and so
  wrongly) the time is 0.86 of Mesa's; Mesa's own rasteriser chooses the colour before fragments, by a
  state that the core profile does not have. The vertex program alone takes 0.85 of the time of Mesa's.
- What is left of a vertex program on llvmpipe is uniforms: every component that it reads is a compare,
  a branch, a load, a spill and a broadcast for every 8 vertices, 30 to 50 of them, as many for Mesa.
- Normals so short that they have denormal components, in the program's own buffer objects: the driver
  reads them, and GLSL lets it take denormal numbers for zero (GLSL 3.30 spec 4.1.4). On every other way
  they are made longer before the driver sees them (docs/deviations.md, row D25).
- Fractional spot exponents need a logarithm that is right near 1, which costs what Mesa's saves.
- A directional light on a vertex at infinity: docs/deviations.md, row D17.
- An error below about 2e-5: the output colour itself is a float32, and its sum of terms is rounded twice.
"""


def figure(value):
    return "0" if value == 0 else f"{value:.1e}"


def mark(text, value, goal):
    return f"{text} ✓" if value <= goal else f"**{text} > {goal:g}**"


def errors_table(errors, out):
    out.append("\n## Errors\n\nLargest error of any sample. ✓: within the goal that the class has; the "
               f"fastest quality's goal is {tables.FASTEST_BOUND} everywhere.\n")
    out.append("| class | " + " | ".join(tables.VARIANTS) + " | default : Mesa |")
    out.append("|---|" + "---|" * (len(tables.VARIANTS) + 1))
    for name, row in errors.items():
        goals = tables.GOALS.get(name)
        cells = []
        for variant in tables.VARIANTS:
            text = figure(row[variant])
            if variant == "fastest":
                text = mark(text, row[variant], tables.FASTEST_BOUND)
            elif goals and variant in ("default", "precise"):
                text = mark(text, row[variant], goals[0] if variant == "default" else goals[1])
            cells.append(text)
        cells.append(f"1 : {row['Mesa'] / row['default']:.0f}" if row["default"] else "-")
        out.append(f"| {name} | " + " | ".join(cells) + " |")


def times_table(times, out):
    out.append("\n## CPU time over Mesa's\n\nMedian, and the range over the processes. Goals: default 1, "
               f"with eight lights 0.9; precise {tables.PRECISE_TIME:g}.\n")
    out.append("| class | " + " | ".join(tables.VARIANTS[1:]) + " |")
    out.append("|---|" + "---|" * (len(tables.VARIANTS) - 1))
    for name, row in times.items():
        goals = tables.GOALS.get(name)
        cells = []
        for variant in tables.VARIANTS[1:]:
            values = row[variant]
            text = f"{statistics.median(values):.2f}"
            if variant == "default" and goals:
                text = mark(text, statistics.median(values), goals[2])
            elif variant == "precise":
                text = mark(text, statistics.median(values), tables.PRECISE_TIME)
            cells.append(f"{text} ({min(values):.2f} to {max(values):.2f})")
        out.append(f"| {name} | " + " | ".join(cells) + " |")


def stress_table(rows, out):
    out.append(f"\n## Stress\n\nLargest error where the specification defines the answer; ✓: within "
               f"{tables.STRESS_BOUND}. A class without such a sample has no figure: there colours are "
               "finite and in [0, 1]. NaN and infinity in every parameter of every call are tests "
               "(tests/stress/not_finite_test.cpp).\n")
    out.append("| class | samples | " + " | ".join(tables.VARIANTS) + " |")
    out.append("|---|---|" + "---|" * len(tables.VARIANTS))
    classes = {}
    for row in rows:
        classes.setdefault(row["class"], {})[row["variant"]] = row
    for name, row in classes.items():
        cells = []
        for variant in tables.VARIANTS:
            cell = row[variant]
            if int(cell["judged"]) == 0:
                text = "-"
            elif variant in ("default", "precise"):
                text = mark(figure(float(cell["largest"])), float(cell["largest"]), tables.STRESS_BOUND)
            else:
                text = figure(float(cell["largest"]))
            if int(cell["not_presentable"]):
                text += f", {cell['not_presentable']} not finite"
            cells.append(text)
        out.append(f"| {name} | {row['Mesa']['judged']} of {row['Mesa']['samples']} | " +
                   " | ".join(cells) + " |")


def summary(errors, times, out):
    def mean(table, variant):
        return statistics.geometric_mean(row[variant] / row["Mesa"] for row in table.values())
    middle = tables.medians(times)
    out.append("\n| geometric mean over the classes, relative to Mesa | " +
               " | ".join(tables.VARIANTS[1:]) + " |")
    out.append("|---|" + "---|" * (len(tables.VARIANTS) - 1))
    out.append("| largest error | " + " | ".join(f"{mean(errors, v):.3f}" for v in tables.VARIANTS[1:]) + " |")
    out.append("| CPU time | " + " | ".join(f"{mean(middle, v):.2f}" for v in tables.VARIANTS[1:]) + " |")


def tessellation_table(rows, out):
    shapes = list(dict.fromkeys(row["shape"] for row in rows))
    kinds = [(shape, shading) for shape in shapes for shading in tessellation.COLORS]
    found = {(r["shape"], r["shading"], r["slices"]): r for r in rows}
    out.append("| slices | " + " | ".join(f"{shape}, {shading}" for shape, shading in kinds) + " |")
    out.append("|---|" + "---|" * len(kinds))
    for slices in dict.fromkeys(row["slices"] for row in rows):
        cells = []
        for kind in kinds:
            row = found[(*kind, slices)]
            cells.append(f"{float(row['error_of_shading']):.2f} in {float(row['cpu_ms']):.2f} ms")
        out.append(f"| {slices} | " + " | ".join(cells) + " |")


def write_csv(path, rows):
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    results, docs = (pathlib.Path(argument) for argument in sys.argv[1:3])
    error_rows = tables.read(results / "errors.csv")
    time_paths = sorted(results.glob("times_*.csv"))
    time_rows = [{"process": i + 1, **row} for i, path in enumerate(time_paths)
                 for row in tables.read(path)]
    stress_rows = tables.read(results / "stress.csv")
    errors = tables.medians(tables.by_class(error_rows, "largest"))
    times = tables.by_class(time_rows, "cpu_ratio_to_mesa")
    out = [INTRODUCTION.format(processes=len(time_paths), machine=tables.machine(),
                               driver=tables.driver(results))]
    summary(errors, times, out)
    errors_table(errors, out)
    least = min(int(row["samples"]) for row in error_rows)
    out.append(f"\nAt least {least:,} samples a class and variant; alpha is exact in all.")
    times_table(times, out)
    stress_table(stress_rows, out)
    out.append(TESSELLATION)
    tessellation_rows = tables.read(results / "tessellation.csv")
    tessellation_table(tessellation_rows, out)
    out.append(EPILOGUE)
    (docs / "accuracy.md").write_text("\n".join(out))
    write_csv(docs / "accuracy_errors.csv", error_rows)
    write_csv(docs / "accuracy_times.csv", time_rows)
    write_csv(docs / "accuracy_stress.csv", stress_rows)
    write_csv(docs / "accuracy_tessellation.csv", tessellation_rows)
    tessellation.write(tessellation_rows, results / "pictures", docs)
    charts.overview(errors, tables.medians(times), docs)
    charts.each_class(errors, tables.medians(times), docs)


if __name__ == "__main__":
    main()
