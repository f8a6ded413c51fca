#!/usr/bin/env python3
"""Writes docs/performance.* from the tables of tests/benchmark/speed: report.py <results> <docs>."""

import csv
import pathlib
import platform
import re
import statistics
import sys
from dataclasses import dataclass

import chart


@dataclass
class Scene:
    name: str
    goal_steady: float
    goal_first: float
    what: str


def read_scenes(path):
    rows = (line.rstrip("\n").split("\t") for line in path.open())
    return [Scene(name, float(steady), float(first), what) for name, steady, first, what in rows]


def read_tables(results, prefix):
    """Rows of every process, by (scene, units, viewport, frame)."""
    groups = {}
    for path in sorted(results.glob(f"{prefix}_*.csv")):
        with path.open() as file:
            for row in csv.DictReader(file):
                key = (row["scene"], int(row["units"]), int(row["viewport"]), row["frame"])
                groups.setdefault(key, []).append(row)
    return groups


def median(rows, column):
    return statistics.median(float(row[column]) for row in rows)


def spread(rows, column):
    values = [float(row[column]) for row in rows]
    return min(values), max(values)


def ratio(rows):
    low, high = spread(rows, "cpu_ratio")
    return f"{median(rows, 'cpu_ratio'):.2f} ({low:.2f} to {high:.2f})"


def verdict(value, goal):
    if not goal:
        return "-"
    return f"{goal:g}, {'reached' if value <= goal else 'not reached'}"


def machine():
    model = "unknown processor"
    cpuinfo = pathlib.Path("/proc/cpuinfo")
    if cpuinfo.exists():
        found = re.search(r"^model name\s*:\s*(.*)$", cpuinfo.read_text(), re.M)
        model = found.group(1) if found else model
    cores = len(re.findall(r"^processor\s*:", cpuinfo.read_text(), re.M)) if cpuinfo.exists() else 0
    return f"{model}, {cores} processors, {platform.system()} {platform.machine()}"


def driver():
    import subprocess
    package = subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", "libosmesa6"],
                             capture_output=True, text=True, check=False).stdout
    return f"OSMesa (llvmpipe), Debian's libosmesa6 {package}" if package else "OSMesa (llvmpipe)"


EMPTY = "S9e"  # a frame's clear and finish


def is_calls(scene):
    """Calls alone, judged without their frame."""
    return scene.name.startswith("S9") and scene.name != EMPTY


def steady_table(scenes, groups, culled):
    out = ["| scene | what | goal | 256 x 256 | 16 x 16 | without rasteriser | ms, ours / Mesa |",
           "|---|---|---|---|---|---|---|"]
    for scene in scenes:
        cells, times, verdicts = [], "-", "-"
        for size in (256, 16):
            rows = [r for key, rows in groups.items() if key[0] == scene.name and key[2:] == (size, "steady")
                    for r in rows]
            if not rows:
                break
            cells.append(ratio(rows))
            if size == 256:
                verdicts = (f"{scene.goal_steady:g}, see below" if is_calls(scene)
                            else verdict(median(rows, "cpu_ratio"), scene.goal_steady))
                times = f"{median(rows, 'ours_cpu_ms'):.3g} / {median(rows, 'mesa_cpu_ms'):.3g}"
        if not cells:
            continue
        rows = [r for key, rows in culled.items() if key[0] == scene.name and key[3] == "steady" for r in rows]
        cells.append(ratio(rows) if rows else "-")
        out.append(f"| {scene.name} | {scene.what} | {verdicts} | " + " | ".join(cells) + f" | {times} |")
    return out


def first_table(scenes, groups):
    out = ["| scene | goal | CPU, ours / Mesa | ms, ours / Mesa |", "|---|---|---|---|"]
    for scene in scenes:
        rows = [r for key, rows in groups.items() if key[0] == scene.name and key[2:] == (256, "first") for r in rows]
        if rows:
            out.append(f"| {scene.name} | {verdict(median(rows, 'cpu_ratio'), scene.goal_first)} | {ratio(rows)} | "
                       f"{median(rows, 'ours_cpu_ms'):.3g} / {median(rows, 'mesa_cpu_ms'):.3g} |")
    return out


def empty_frame(groups, viewport):
    rows = [r for key, rows in groups.items() if key[0] == EMPTY and key[2:] == (viewport, "steady") for r in rows]
    return [median(rows, f"{side}_cpu_ms") if rows else 0 for side in ("ours", "mesa")]


def calls_table(scenes, groups):
    """S9 without what a frame costs besides."""
    out = ["| scene | goal | of Mesa's | ns of CPU a frame's calls, ours / Mesa |", "|---|---|---|---|"]
    empty = empty_frame(groups, 256)
    for scene in scenes:
        rows = [r for key, rows in groups.items() if key[0] == scene.name and key[2:] == (256, "steady") for r in rows]
        if rows and is_calls(scene):
            ours, mesa = (median(rows, f"{side}_cpu_ms") - less for side, less in zip(("ours", "mesa"), empty))
            out.append(f"| {scene.name} | {verdict(ours / mesa, scene.goal_steady)} | {ours / mesa:.2f} | "
                       f"{1e6 * ours:.3g} / {1e6 * mesa:.3g} |")
    return out


def growth_table(growth, groups):
    """What each costs, less an empty frame, and what each of those costs that the row before had not."""
    out = ["| what | number | ns of CPU each, ours | Mesa | each of those added, ours | Mesa |", "|---|---|---|---|---|---|"]
    empty = empty_frame(groups, 16)
    before = {}
    for (scene, units, _, frame), rows in sorted(growth.items()):
        if frame != "steady":
            continue
        now = [median(rows, f"{side}_cpu_ms") - less for side, less in zip(("ours", "mesa"), empty)]
        last_units, last = before.get(scene, (0, [0, 0]))
        each = [1e6 * ms / units for ms in now]
        added = [1e6 * (ms - last_ms) / (units - last_units) for ms, last_ms in zip(now, last)]
        before[scene] = units, now
        out.append(f"| {scene} | {units} | {each[0]:.0f} | {each[1]:.0f} | {added[0]:.0f} | {added[1]:.0f} |")
    return out


def lights_lines(results):
    rows = [row for path in sorted(results.glob("lights_*.csv")) for row in csv.DictReader(path.open())]
    if not rows:
        return []
    few, many = median(rows, "few_cpu_ms"), median(rows, "many_cpu_ms")
    return ["## More than eight lights", "",
            f"{rows[0]['objects']} objects under {rows[0]['many']} lamps, of which each object has few: {many:.3g} ms of",
            f"CPU a frame, beside {few:.3g} ms under {rows[0]['few']} of the lamps. Ratio {ratio(rows)}; goal",
            f"{verdict(median(rows, 'cpu_ratio'), 2)}. {float(rows[0]['culled_per_object']):.0f} lamps are left out of an object; steady frames",
            f"compiled {max(int(row['compiled']) for row in rows)} programs.", ""]


def write_csv(path, groups):
    columns = ["cpu_ratio", "wall_ratio", "ours_cpu_ms", "mesa_cpu_ms", "ours_wall_ms", "mesa_wall_ms"]
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["scene", "viewport", "frame", "processes", *columns, "programs_compiled", "image_difference"])
        for (scene, _, viewport, frame), rows in groups.items():
            writer.writerow([scene, viewport, frame, len(rows)] +
                            [f"{median(rows, column):.4g}" for column in columns] +
                            [max(int(r["programs_compiled"]) for r in rows),
                             max(int(r["image_difference"]) for r in rows)])


def main():
    results, docs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    scenes = read_scenes(results / "scenes.tsv")
    groups, culled = read_tables(results, "scenes"), read_tables(results, "culled")
    growth = read_tables(results, "growth")
    if not groups:
        sys.exit(f"report.py: no tables in {results}")
    write_csv(docs / "performance.csv", groups)
    chart.write(scenes, groups, docs)

    processes = max(len(rows) for rows in groups.values())
    worst = max(int(row["image_difference"]) for rows in groups.values() for row in rows)
    text = ["# Performance", "",
            "Written by `scripts/bench speed`: CPU time of a frame of this library divided by that of Mesa's fixed",
            "function, both in one process and in turns. Each figure is the median over the frames and over",
            f"{processes} process{'es' if processes > 1 else ''}; in brackets the lowest and the highest process. The",
            "goals are for 256 x 256 pixels. \"Without rasteriser\" is 16 x 16 with every face culled: what is left is",
            "the calls, the state and the vertices.", "",
            f"Machine: {machine()}. Driver: {driver()}.",
            f"Images: compared in the same run, after the first and after the last frame; the largest difference is {worst} of 255.",
            "", "![steady frames](performance.png)", "", "## Steady frames", "", *steady_table(scenes, groups, culled),
            "", "## First frames", "",
            "Programs are compiled in it; the driver's cache on disk is off.", "", *first_table(scenes, groups), "",
            *lights_lines(results),
            "## Calls without their frame", "", "S9 less S9e.", "", *calls_table(scenes, groups), "",
            "## Growth", "", *growth_table(growth, groups), "",
            "What these figures say: [performance_notes.md](performance_notes.md).", ""]
    (docs / "performance.md").write_text("\n".join(text))


if __name__ == "__main__":
    main()
