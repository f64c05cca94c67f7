#!/usr/bin/env python3
"""Draws what rme_limit_cycle --output DIR has written.

Left, the path of the flange in the y-z plane: the turn before the attachment, and the path after it, for each method of
compensation. Right, the distance to the cycle over time.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from plotting import columns, main, plt

RADIUS, TURN = 0.1, 2 * np.pi  # [m], [s]
TRACKER, PUBLISHED, ALONE, BEFORE = "#0072b2", "#009e73", "#d55e00", "#9a9a9a"


def draw(folder):
    runs = [(columns(folder / "alone.csv"), ALONE, "CPIC alone"),
            (columns(folder / "published.csv"), PUBLISHED, "published pipeline"),
            (columns(folder / "tracker.csv"), TRACKER, "tracker")]
    figure, (path, distance) = plt.subplots(1, 2, figsize=(9, 4), constrained_layout=True,
                                            gridspec_kw={"width_ratios": [1, 1.25]})
    angle = np.linspace(0, 2 * np.pi, 361)
    path.plot(1e3 * RADIUS * np.cos(angle), 1e3 * RADIUS * np.sin(angle), color="black", linestyle=":", linewidth=1,
              label="cycle")
    for run, colour, label in runs:
        before = (run["t"] >= -TURN) & (run["t"] <= 0)
        if run is runs[0][0]:
            path.plot(1e3 * run["y"][before], 1e3 * run["z"][before], color=BEFORE, label="before the attachment")
        after = run["t"] >= 0
        path.plot(1e3 * run["y"][after], 1e3 * run["z"][after], color=colour, label=label)
        shown = run["t"] >= -TURN
        distance.plot(run["t"][shown], 1e3 * run["distance"][shown], color=colour)
    stopped = runs[0][0]
    path.plot(1e3 * stopped["y"][-1], 1e3 * stopped["z"][-1], "o", color=ALONE, markersize=5)
    attached = np.argmax(stopped["t"] >= 0)
    path.plot(1e3 * stopped["y"][attached], 1e3 * stopped["z"][attached], "s", color="black", markersize=5,
              label="attach")
    path.set_aspect("equal")
    path.set_xlabel("y [mm]")
    path.set_ylabel("z [mm]")
    path.legend(loc="center", bbox_to_anchor=(0.42, 0.5), fontsize=8)
    distance.axvline(0, color="grey", linestyle=":", linewidth=1)
    distance.set_ylim(bottom=0)
    distance.set_xlabel("time since the attachment [s]")
    distance.set_ylabel("distance to the cycle [mm]")
    path.set_title(f"{stopped['m'].max():g} kg attached on the move")
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw)
