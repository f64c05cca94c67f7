#!/usr/bin/env python3
"""Draws what rme_injection --output DIR has written: DIR/injection.png.

    python3 plot.py DIR [PICTURE]

Left, each estimated mass with its 90 % interval over the true one; right, how often intervals of every level hold the
true mass. Colours: whether the estimator was told the instant or had to detect it.
"""
import argparse
import csv
import math
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

TABLES = (("instant known", "#0072b2"), ("instant detected", "#d55e00"))
HALF_WIDTH = 1.644854  # of a 90 % interval [standard deviations]


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise ValueError(f"{path}: no rows")
    return rows


def draw(rows, picture):
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    figure, (masses, levels) = plt.subplots(1, 2, figsize=(8, 4), constrained_layout=True)
    masses.axline((0, 0), slope=1, color="grey", linestyle=":", linewidth=1)
    levels.plot([0, 1], [0, 1], color="grey", linestyle=":", linewidth=1)
    for table, colour in TABLES:
        mine = [row for row in rows if row["table"] == table]
        if not mine:
            continue
        truth, error, std = ([float(row[key]) for row in mine] for key in ("mass", "mass_error", "mass_std"))
        masses.errorbar(
            truth,
            [t + e for t, e in zip(truth, error)],
            yerr=[HALF_WIDTH * s for s in std],
            fmt=".",
            color=colour,
            elinewidth=0.6,
            label=f"{table} ({len(mine)})",
        )
        needed = sorted(math.erf(abs(e) / s / math.sqrt(2)) for e, s in zip(error, std))
        levels.plot([0] + needed + [1], [i / len(needed) for i in range(len(needed) + 1)] + [1], color=colour)
    masses.set_xlabel("injected mass [kg]")
    masses.set_ylabel("estimate and 90 % interval [kg]")
    masses.legend(frameon=False, loc="upper left")
    levels.set_aspect("equal")
    levels.set_xlabel("level of the interval")
    levels.set_ylabel("holds the mass")
    figure.savefig(picture, dpi=150)


def main():
    parser = argparse.ArgumentParser(description="Draws what rme_injection has written.")
    parser.add_argument("folder", type=pathlib.Path, help="what was given to --output")
    parser.add_argument("picture", type=pathlib.Path, nargs="?", help="file to write (default: injection.png there)")
    arguments = parser.parse_args()
    try:
        draw(read(arguments.folder / "injection.csv"), arguments.picture or arguments.folder / "injection.png")
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot.py: {error}")


if __name__ == "__main__":
    main()
