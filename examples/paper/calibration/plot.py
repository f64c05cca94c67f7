#!/usr/bin/env python3
"""Draws what rme_calibration --output DIR has written.

Above, the rank histogram of each parameter, with the band in which 99 % of the bars of an honest posterior lie; below,
how often intervals of every level hold the truth.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from plotting import COLOURS, main, plt, read

PARAMETERS = ("mass", "x", "y", "z")


def coverage(events, parameter):
    """(level, share of the intervals of that level that hold the truth), level by level."""
    levels = sorted(
        math.erf(abs(float(row[f"{parameter}_error"])) / float(row[f"{parameter}_std"]) / math.sqrt(2)) for row in events
    )
    return [0] + levels + [1], [i / len(levels) for i in range(len(levels) + 1)] + [1]


def draw(folder):
    events, ranks = read(folder / "events.csv"), read(folder / "ranks.csv")
    cases = list(dict.fromkeys(row["case"] for row in ranks))
    figure, axes = plt.subplots(2, 4, figsize=(10, 5), constrained_layout=True, squeeze=False)
    for column, parameter in enumerate(PARAMETERS):
        above, below = axes[:, column]
        for case, colour in zip(cases, COLOURS):
            bars = [row for row in ranks if row["case"] == case and row["parameter"] == parameter]
            edges = [i / len(bars) for i in range(len(bars) + 1)]
            above.stairs([row["count"] for row in bars], edges, color=colour, label=case)
            mine = [row for row in events if row["case"] == case]
            below.plot(*coverage(mine, parameter), color=colour, label=case)
        above.axhspan(float(bars[0]["least"]), float(bars[0]["most"]), color="#e8e8e8", linewidth=0,
                      zorder=0)
        above.set_ylim(bottom=0)
        above.set_title(parameter)
        above.set_xlabel("rank of the truth")
        below.plot([0, 1], [0, 1], color="grey", linestyle=":", linewidth=1)
        below.set_aspect("equal")
        below.set_xlabel("level of the interval")
    axes[0, 0].set_ylabel("events")
    axes[1, 0].set_ylabel("holds the truth")
    axes[1, 0].legend(loc="lower right", fontsize=6)
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw)
