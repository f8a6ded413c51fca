"""Run time against error: docs/accuracy.* over all classes, docs/accuracy_classes.* class by class."""

import statistics

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "legacy_gl"  # the same figures give the same file
import matplotlib.patheffects  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402

import tables  # noqa: E402

HIGHEST = 1e-2  # of the error's axis
LABEL_PLACES = {"fastest": (-12, -18, "center"), "Mesa": (10, 6, "left")}

# Labels stay readable over points and lines.
HALO = [matplotlib.patheffects.withStroke(linewidth=3, foreground="white")]

COLORS = {
    "Mesa": "#555555",
    "textbook GLSL": "#b5651d",
    "fastest": "#4e9a06",
    "default": "#3465a4",
    "precise": "#a40000",
}


def front(points):
    """Those that no other point beats in both coordinates, from left to right."""
    best, kept = float("inf"), []
    for point in sorted(points):
        if point[1] < best:
            best = point[1]
            kept.append(point)
    return kept


def draw_front(axes, points):
    kept = front(points)
    axes.plot(*zip(*kept), color="#999999", linewidth=1.2, linestyle="--", zorder=1)


def scatter(axes, points, **style):
    """Points above the axis are triangles at its upper end."""
    inside = [p for p in points if p[1] <= HIGHEST]
    above = [(p[0], HIGHEST) for p in points if p[1] > HIGHEST]
    if inside:
        axes.scatter(*zip(*inside), **style)
    if above:
        axes.scatter(*zip(*above), marker="^", clip_on=False, **style)


def scales(axes, ticks):
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(1e-6, HIGHEST)
    axes.set_xticks(ticks, [f"{t:g}" for t in ticks])
    axes.minorticks_off()
    axes.grid(color="#eeeeee", zorder=0)
    axes.spines[["top", "right"]].set_visible(False)


def save(figure, docs, name):
    figure.savefig(docs / f"{name}.png", dpi=110)
    figure.savefig(docs / f"{name}.svg", metadata={"Date": None})
    plt.close(figure)


def overview(errors, times, docs):
    figure, axes = plt.subplots(figsize=(9, 6))
    centres = {}
    for variant in tables.VARIANTS:
        points = [(times[c][variant], errors[c][variant]) for c in errors if c in times]
        scatter(axes, points, s=14, color=COLORS[variant], alpha=0.35, linewidths=0, zorder=2)
        centres[variant] = tuple(statistics.geometric_mean(axis) for axis in zip(*points))
    draw_front(axes, list(centres.values()))
    for variant, (x, y) in centres.items():
        axes.scatter([x], [y], s=110, color=COLORS[variant], edgecolors="white", zorder=3)
        right, up, side = LABEL_PLACES.get(variant, (9, 7, "left"))
        axes.annotate(variant, (x, y), (right, up), textcoords="offset points", ha=side,
                      color=COLORS[variant], fontsize=11, fontweight="bold", zorder=4,
                      path_effects=HALO)
    scales(axes, [0.7, 1, 1.5, 2, 3, 5])
    axes.set_xlabel("CPU time of lit vertices / Mesa's fixed function")
    axes.set_ylabel("largest error of a colour, in steps of 1/255")
    axes.set_title("Run time against error: geometric means over the classes, each class a small dot;\n"
                   "dashed: the Pareto front; triangle: an error beyond the axis", fontsize=11, loc="left")
    figure.tight_layout()
    save(figure, docs, "accuracy")


def each_class(errors, times, docs):
    names = [name for name in errors if name in times]
    columns = 4
    rows = -(-len(names) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(13, 2.6 * rows), sharex=True, sharey=True)
    for axes, name in zip(grid.flat, names):
        points = {v: (times[name][v], errors[name][v]) for v in tables.VARIANTS}
        draw_front(axes, list(points.values()))
        for variant, (x, y) in points.items():
            scatter(axes, [(x, y)], s=45, color=COLORS[variant], zorder=3)
        scales(axes, [1, 2, 4])
        axes.set_title(name, fontsize=10, loc="left")
    for axes in list(grid.flat)[len(names):]:
        axes.set_visible(False)
    handles = [plt.Line2D([], [], color=COLORS[v], marker="o", linestyle="") for v in tables.VARIANTS]
    figure.legend(handles, tables.VARIANTS, loc="upper center", ncol=len(handles), frameon=False,
                  fontsize=11)
    figure.supxlabel("CPU time / Mesa's fixed function", fontsize=11)
    figure.supylabel("largest error, in steps of 1/255", fontsize=11)
    figure.tight_layout(rect=(0.01, 0.01, 1, 0.965))
    save(figure, docs, "accuracy_classes")
