#!/usr/bin/env python3
"""Draws what rme_limit_cycle --output DIR has written: DIR/limit_cycle.png.

    python3 plot.py DIR [PICTURE]

Left, the path of the flange in the y-z plane: the turn before the attach, and what follows it with the estimator and
without. Right, the distance to the cycle over time.
"""
import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

RADIUS, TURN = 0.1, 2 * np.pi  # [m], [s]
WITH, WITHOUT, BEFORE = "#0072b2", "#d55e00", "#9a9a9a"


def read(path):
    """Columns by name."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise ValueError(f"{path}: no rows")
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def draw(folder, picture):
    runs = [(read(folder / "without.csv"), WITHOUT, "without the estimator"),
            (read(folder / "with.csv"), WITH, "with the estimator")]
    plt.rcParams.update({"font.size": 10, "axes.spines.top": False, "axes.spines.right": False})
    figure, (path, distance) = plt.subplots(1, 2, figsize=(9, 4), constrained_layout=True,
                                            gridspec_kw={"width_ratios": [1, 1.25]})
    angle = np.linspace(0, 2 * np.pi, 361)
    path.plot(1e3 * RADIUS * np.cos(angle), 1e3 * RADIUS * np.sin(angle), color="black", linestyle=":", linewidth=1,
              label="cycle")
    for run, colour, label in runs:
        before = (run["t"] >= -TURN) & (run["t"] <= 0)
        if run is runs[0][0]:
            path.plot(1e3 * run["y"][before], 1e3 * run["z"][before], color=BEFORE, label="before the attach")
        after = run["t"] >= 0
        path.plot(1e3 * run["y"][after], 1e3 * run["z"][after], color=colour, label=label)
        shown = run["t"] >= -TURN
        distance.plot(run["t"][shown], 1e3 * run["distance"][shown], color=colour)
    stopped = runs[0][0]
    path.plot(1e3 * stopped["y"][-1], 1e3 * stopped["z"][-1], "o", color=WITHOUT, markersize=5)
    attached = np.argmax(stopped["t"] >= 0)
    path.plot(1e3 * stopped["y"][attached], 1e3 * stopped["z"][attached], "s", color="black", markersize=5,
              label="attach")
    path.set_aspect("equal")
    path.set_xlabel("y [mm]")
    path.set_ylabel("z [mm]")
    path.legend(frameon=False, loc="center", bbox_to_anchor=(0.42, 0.5), fontsize=8)
    distance.axvline(0, color="grey", linestyle=":", linewidth=1)
    distance.set_ylim(bottom=0)
    distance.set_xlabel("time since the attach [s]")
    distance.set_ylabel("distance to the cycle [mm]")
    path.set_title(f"{stopped['m'].max():g} kg attached on the move", loc="left")
    figure.savefig(picture, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path, nargs="?")
    arguments = parser.parse_args()
    try:
        draw(arguments.folder, arguments.picture or arguments.folder / "limit_cycle.png")
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot.py: {error}")


if __name__ == "__main__":
    main()
