#!/usr/bin/env python3
"""Draws what rme_01_static_payload --output DIR has written: DIR/static_payload.png.

    python3 plot.py DIR [PICTURE]

Top: the position error of the flange with and without compensation. Middle: the estimated mass. Bottom: the norm of the
external torque. Shaded: the times when the likeliest mode was neither an empty
hand nor a payload that stays as it is.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plotting import columns, main, plt

WITH, WITHOUT, CHANGE = "#0072b2", "#d55e00", "#cfe3f1"
SETTLED = ("empty", "held")


def norm(run, names):
    return np.sqrt(sum(run[name] ** 2 for name in names))


def changes(run):
    """(begin, end) of each interval in which the likeliest mode was not a settled one [s]."""
    changing = ~np.isin(run["mode"], SETTLED)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], changing, [False]]).astype(int)))
    t = np.append(run["t"], run["t"][-1])
    return [(t[a], t[b]) for a, b in edges.reshape(-1, 2)]


def draw(folder):
    runs = {name: columns(folder / f"{name}.csv") for name in ("compensated", "uncompensated")}
    torque = [f"tau_ext{i}" for i in range(1, 8)]
    error = [f"error_{axis}" for axis in "xyz"]
    on, off = runs["compensated"], runs["uncompensated"]
    attached = on["t"][np.argmax(on["m"] > 0)]

    plt.rcParams["font.size"] = 10
    figure, (above, middle, below) = plt.subplots(3, 1, figsize=(7.2, 6.6), sharex=True, constrained_layout=True)
    above.plot(off["t"], 1e3 * norm(off, error), color=WITHOUT, label="without compensation")
    above.plot(on["t"], 1e3 * norm(on, error), color=WITH, label="with compensation")
    above.set_ylabel("position error [mm]")
    above.set_ylim(bottom=0)
    above.legend(loc="center right")
    above.set_title(f"{on['m'].max():g} kg, unknown to the controller")

    known = on["mass"] > 0
    middle.fill_between(on["t"], on["mass"] - 2 * on["mass_std"], on["mass"] + 2 * on["mass_std"], where=known,
                        color=WITH, alpha=0.3, linewidth=0)
    middle.plot(on["t"], on["mass"], color=WITH, linewidth=1.2, label="estimate, 2 std. dev.")
    middle.plot(on["t"], on["m"], color="black", linestyle="--", linewidth=1, label="truth")
    middle.set_ylabel("mass [kg]")
    middle.legend(loc="lower right")

    below.plot(on["t"], norm(on, torque), color="black", linewidth=1)
    below.set_ylabel(r"$\Vert\tau_\mathrm{ext}\Vert_2$ [N m]")
    below.set_xlabel("time [s]")
    below.set_ylim(bottom=0)
    for begin, end in changes(on):
        for axes in (above, middle, below):
            axes.axvspan(begin, end, color=CHANGE, linewidth=0)
    for axes in (above, middle, below):
        axes.axvline(attached, color="grey", linestyle=":", linewidth=1)
        axes.set_xlim(0, on["t"][-1])
    above.annotate("payload appears", (attached, 0.97), xycoords=("data", "axes fraction"), xytext=(-4, 0),
                   textcoords="offset points", ha="right", va="top", fontsize=8, color="grey")
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw, "static_payload", dpi=150)
