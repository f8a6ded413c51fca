"""docs/accuracy_tessellation.*: a finer mesh or a better interpolation, and what each looks like."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import charts  # noqa: E402

COLORS = {"flat": "#b5651d", "Gouraud": "#3465a4", "Phong": "#a40000"}
LABELLED = (8, 32, 128)
STRIP = (8, 16, 32, 64, 256)


def curves(rows, docs):
    shapes = list(dict.fromkeys(row["shape"] for row in rows))
    figure, panels = plt.subplots(1, len(shapes), figsize=(12, 5.5), sharey=True)
    for axes, shape in zip(panels, shapes):
        for shading, color in COLORS.items():
            points = [(float(r["cpu_ms"]), float(r["error_of_shading"]), int(r["slices"]))
                      for r in rows if r["shape"] == shape and r["shading"] == shading]
            axes.plot([p[0] for p in points], [p[1] for p in points], color=color, marker="o",
                      markersize=4, linewidth=1.5)
            for x, y, slices in points:
                if slices in LABELLED and shading != "flat":
                    axes.annotate(str(slices), (x, y), (-5, -13) if shading == "Gouraud" else (5, 4),
                                  textcoords="offset points", fontsize=8, color=color,
                                  path_effects=charts.HALO)
            axes.annotate(f"{shading}, {points[-1][2]}", points[-1][:2], (7, -3), textcoords="offset points",
                          color=color, fontsize=11, fontweight="bold", path_effects=charts.HALO)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlim(right=axes.get_xlim()[1] * 2.4)
        ticks = [t for t in (0.2, 0.5, 1, 2, 5, 10, 20) if axes.get_xlim()[0] <= t <= axes.get_xlim()[1]]
        axes.set_xticks(ticks, [f"{t:g}" for t in ticks])
        axes.minorticks_off()
        axes.set_title(f"{shape}, by slices around", fontsize=11, loc="left")
        axes.set_xlabel("CPU time of a frame of 256 x 256 pixels, ms")
        axes.grid(color="#eeeeee")
        axes.spines[["top", "right"]].set_visible(False)
    panels[0].set_ylabel("error of the shading, root mean square, steps of 1/255")
    figure.tight_layout()
    charts.save(figure, docs, "accuracy_tessellation")


def strip(shape, pictures, docs):
    figure, grid = plt.subplots(len(COLORS), len(STRIP), figsize=(11, 6.4))
    for row, shading in zip(grid, COLORS):
        for axes, slices in zip(row, STRIP):
            axes.imshow(plt.imread(pictures / f"{shape}_{slices}_{shading}.png"))
            axes.set_xticks([])
            axes.set_yticks([])
            axes.spines[:].set_visible(False)
            if shading == "flat":
                axes.set_title(f"{slices} slices", fontsize=11)
        row[0].set_ylabel(shading, fontsize=12, fontweight="bold", color=COLORS[shading])
    figure.tight_layout(pad=0.4)
    figure.savefig(docs / f"accuracy_{shape}.png", dpi=100)
    plt.close(figure)


def write(rows, pictures, docs):
    curves(rows, docs)
    for shape in dict.fromkeys(row["shape"] for row in rows):
        strip(shape, pictures, docs)
