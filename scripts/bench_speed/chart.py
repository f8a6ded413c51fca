"""docs/performance.png and .svg: a bar for each scene and viewport, and the goal across it."""

import statistics

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "legacy_gl"  # the same figures give the same file
import matplotlib.pyplot as plt  # noqa: E402

SIZES = {256: "#3465a4", 16: "#9bbbe0"}


def _panel(axes, scenes, groups, frame, goal_of, title):
    shown = [s for s in scenes if any(key[0] == s.name and key[3] == frame for key in groups)]
    height = 0.38
    for place, scene in enumerate(shown):
        for offset, (size, color) in zip((-height / 2, height / 2), SIZES.items()):
            values = [float(r["cpu_ratio"]) for key, rows in groups.items()
                      if key[0] == scene.name and key[2] == size and key[3] == frame for r in rows]
            if not values:
                continue
            value = statistics.median(values)
            axes.barh(place + offset, value, height, color=color)
            axes.text(value + 0.015, place + offset, f"{value:.2f}", va="center", fontsize=8)
        goal = goal_of(scene)
        if goal:
            axes.plot([goal, goal], [place - 0.46, place + 0.46], color="#cc0000", linewidth=2.5)
    axes.axvline(1, color="#555555", linewidth=1, linestyle="--")
    axes.set_yticks(range(len(shown)), [s.name for s in shown])
    axes.invert_yaxis()
    axes.set_xlim(0, max(1.3, axes.get_xlim()[1]))
    axes.set_xlabel("CPU time, ours / Mesa's fixed function")
    axes.set_title(title, fontsize=11)
    axes.spines[["top", "right"]].set_visible(False)


def write(scenes, groups, docs):
    figure, (steady, first) = plt.subplots(1, 2, figsize=(12, 7))
    _panel(steady, scenes, groups, "steady", lambda s: s.goal_steady, "a steady frame")
    _panel(first, scenes, groups, "first", lambda s: s.goal_first, "the first frame: programs are compiled")
    handles = [plt.Rectangle((0, 0), 1, 1, color=color) for color in SIZES.values()]
    labels = [f"{size} x {size} pixels" for size in SIZES]
    handles.append(plt.Line2D([], [], color="#cc0000", linewidth=2.5))
    labels.append("goal")
    handles.append(plt.Line2D([], [], color="#555555", linewidth=1, linestyle="--"))
    labels.append("as fast as Mesa")
    figure.legend(handles, labels, loc="lower center", ncol=4, frameon=False)
    figure.tight_layout(rect=(0, 0.05, 1, 1))
    figure.savefig(docs / "performance.png", dpi=110)
    figure.savefig(docs / "performance.svg", metadata={"Date": None})
