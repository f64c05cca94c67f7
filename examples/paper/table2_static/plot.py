#!/usr/bin/env python3
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from plotting import COLOURS, column, main, plt, read

# Table 2 of the paper: payload mass [kg], and the mean of the published estimates on the real arm (m, x, y, z) [kg, m].
PUBLISHED = {0.3: (0.380, -0.04, 0.02, 0.13), 0.5: (0.511, 0.04, 0.01, 0.15), 0.7: (0.681, 0.07, 0.00, 0.14),
             0.9: (0.861, 0.07, -0.02, 0.11), 1.1: (1.053, 0.07, 0.00, 0.00), 1.29: (1.269, 0.05, 0.00, 0.00)}
PARAMETERS = (("m", "mass [g]"), ("x", "x [mm]"), ("y", "y [mm]"), ("z", "z [mm]"))


def draw(folder):
    """Errors of every trial with its own 90 % interval, beside the errors of the published means."""
    rows = read(folder / "trials.csv")
    figure, axes = plt.subplots(1, 4, figsize=(10, 2.8), constrained_layout=True)
    masses = sorted(PUBLISHED)
    for axis, (key, title), index in zip(axes, PARAMETERS, range(4)):
        for place, mass in enumerate(masses):
            for method, colour, left in (("published pipeline", COLOURS[2], -0.45), ("tracker", COLOURS[0], -0.12),
                                         ("tracker told of the sensing", COLOURS[5], 0.2)):
                mine = [row for row in rows if row["m"] == mass and row["method"] == method]
                at = [place + left + 0.25 * (k + 0.5) / len(mine) for k in range(len(mine))]
                axis.errorbar(at, [1e3 * row[f"{key}_error"] for row in mine],
                              yerr=[1.645e3 * row[f"{key}_std"] for row in mine], fmt=".", markersize=3, linewidth=0.8,
                              color=colour, label=f"{method}, 90 % intervals" if place == 0 else None)
            truth = {"m": mass, "x": mine[0]["rx"], "y": mine[0]["ry"], "z": mine[0]["rz"]}[key]
            axis.plot(place, 1e3 * (PUBLISHED[mass][index] - truth), "x", color=COLOURS[1],
                      label="published mean of ten, real arm" if place == 0 else None)
        axis.axhline(0, color="grey", linewidth=0.8, zorder=0)
        axis.set_title("error of " + title)
        axis.set_xticks(range(6), [f"{mass:g}" for mass in masses])
        axis.set_xlabel("payload [kg]")
    axes[1].legend(fontsize=6.5)
    return figure


if __name__ == "__main__":
    main("Draws what rme_table2_static --output DIR has written.", draw)
