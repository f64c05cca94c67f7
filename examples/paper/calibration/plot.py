#!/usr/bin/env python3
"""Draws what rme_calibration --output DIR has written: DIR/calibration.png.

    python3 plot.py DIR [PICTURE]

Above, the rank histogram of each parameter, with the band in which 99 % of the bars of an honest posterior lie; below,
how often intervals of every level hold the truth.
"""
import argparse
import csv
import math
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

PARAMETERS = ("mass", "x", "y", "z")
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise ValueError(f"{path}: no rows")
    return rows


def coverage(events, parameter):
    """(level, share of the intervals of that level that hold the truth), level by level."""
    levels = sorted(
        math.erf(abs(float(row[f"{parameter}_error"])) / float(row[f"{parameter}_std"]) / math.sqrt(2)) for row in events
    )
    return [0] + levels + [1], [i / len(levels) for i in range(len(levels) + 1)] + [1]


def draw(folder, picture):
    events, ranks = read(folder / "events.csv"), read(folder / "ranks.csv")
    presets = list(dict.fromkeys(row["preset"] for row in ranks))
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    figure, axes = plt.subplots(2, 4, figsize=(10, 5), constrained_layout=True, squeeze=False)
    for column, parameter in enumerate(PARAMETERS):
        above, below = axes[:, column]
        for preset, colour in zip(presets, COLOURS):
            bars = [row for row in ranks if row["preset"] == preset and row["parameter"] == parameter]
            edges = [i / len(bars) for i in range(len(bars) + 1)]
            above.stairs([int(row["count"]) for row in bars], edges, color=colour, label=preset)
            mine = [row for row in events if row["preset"] == preset]
            below.plot(*coverage(mine, parameter), color=colour, label=preset)
        above.axhspan(float(bars[0]["least"]), float(bars[0]["most"]), color="#e8e8e8", linewidth=0,
                      zorder=0)
        above.set_ylim(bottom=0)
        above.set_title(parameter, loc="left")
        above.set_xlabel("rank of the truth")
        below.plot([0, 1], [0, 1], color="grey", linestyle=":", linewidth=1)
        below.set_aspect("equal")
        below.set_xlabel("level of the interval")
    axes[0, 0].set_ylabel("events")
    axes[1, 0].set_ylabel("holds the truth")
    axes[1, 0].legend(frameon=False, loc="lower right")
    figure.savefig(picture, dpi=150)


def main():
    parser = argparse.ArgumentParser(description="Draws what rme_calibration has written.")
    parser.add_argument("folder", type=pathlib.Path, help="what was given to --output")
    parser.add_argument("picture", type=pathlib.Path, nargs="?", help="file to write (default: calibration.png there)")
    arguments = parser.parse_args()
    try:
        draw(arguments.folder, arguments.picture or arguments.folder / "calibration.png")
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot.py: {error}")


if __name__ == "__main__":
    main()
