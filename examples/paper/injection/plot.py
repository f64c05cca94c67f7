#!/usr/bin/env python3
"""Draws what rme_injection --output DIR has written.

Left, each estimated mass with its 90 % interval over the true mass; right, how often intervals of every level hold the
true mass. The colours show whether the payload was announced to the estimator.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from plotting import main, plt, read

TABLES = (("payload announced", "#0072b2"), ("payload", "#d55e00"))
HALF_WIDTH = 1.644854  # of a 90 % interval [standard deviations]


def draw(folder):
    rows = read(folder / "injection.csv")
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
    masses.legend(loc="upper left")
    levels.set_aspect("equal")
    levels.set_xlabel("level of the interval")
    levels.set_ylabel("holds the mass")
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw)
