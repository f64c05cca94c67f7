#!/usr/bin/env python3
"""Draws what rme_sequential_interaction --output DIR has written.

From above, for each method of compensation: the estimated and the true mass, the position error, and the distance of the
nearest joint to its limit. Pushes are shaded.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from plotting import columns, main, plt

TRACKER, PUBLISHED, ALONE = "#0072b2", "#009e73", "#d55e00"
PUSH, FORBIDDEN = "#e8e8e8", "#f6d5d5"


def spans(t, active):
    """(begin, end) of each time span in which `active` is true [s]."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], active, [False]]).astype(int)))
    t = np.append(t, t[-1])
    return [(t[a], t[b]) for a, b in edges.reshape(-1, 2)]


def draw(folder):
    on, published, off = (columns(folder / f"{name}.csv") for name in ("tracker", "published", "alone"))
    figure, (mass, error, limit) = plt.subplots(3, 1, figsize=(7.2, 7.2), sharex=True, constrained_layout=True)
    mass.fill_between(on["t"], on["mass"] - 2 * on["mass_std"], on["mass"] + 2 * on["mass_std"], color=TRACKER,
                      alpha=0.3, linewidth=0)
    mass.plot(published["t"], published["mass"], color=PUBLISHED, linewidth=1, label="published pipeline")
    mass.plot(on["t"], on["mass"], color=TRACKER, label="tracker, 2 std. dev.")
    mass.plot(on["t"], on["m"], color="black", linestyle="--", linewidth=1, label="truth")
    mass.set_ylim(-0.1, 1.25 * on["m"].max())
    mass.set_ylabel("mass in the hand [kg]")
    mass.legend(loc="upper left")
    mass.set_title("a basket and two objects come and go (pushes in grey)")

    for axis, name, scale, label in ((error, "error", 1e3, "position error [mm]"),
                                     (limit, "limit", 1, "distance to the nearest\njoint limit [rad]")):
        axis.plot(off["t"], scale * off[name], color=ALONE, label="CPIC alone")
        axis.plot(published["t"], scale * published[name], color=PUBLISHED, label="published pipeline")
        axis.plot(on["t"], scale * on[name], color=TRACKER, label="tracker")
        axis.set_ylabel(label)
    error.set_ylim(bottom=0)
    error.legend(loc="upper right")
    limit.set_ylim(-0.01, 1.05 * max(on["limit"].max(), off["limit"].max()))
    limit.axhspan(-0.01, 0, color=FORBIDDEN, zorder=0)
    limit.set_xlabel("time [s]")
    for axis in (mass, error, limit):
        for begin, end in spans(on["t"], on["push"] > 0):
            axis.axvspan(begin, end, color=PUSH, linewidth=0, zorder=0)
        axis.set_xlim(0, on["t"][-1])
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw)
