#!/usr/bin/env python3
"""Draws what rme_01_static_payload --output DIR has written: DIR/static_payload.png.

    python3 plot.py DIR [PICTURE]

Above, how far the flange strayed with and without compensation; below, the norm of the external torque with the window
in which the detector saw the change and the samples that were collected after it (Figure 7 of the paper).
"""
import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

DETECTOR_WINDOW = 0.5  # MismatchDetectorConfig::window [s]
WITH, WITHOUT, DETECTION, COLLECTION = "#0072b2", "#d55e00", "#e8e8e8", "#cfe3f1"


def read(path):
    """Columns by name; all numbers but the phase."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise ValueError(f"{path}: no rows")
    return {name: np.array([row[name] if name == "phase" else float(row[name]) for row in rows]) for name in rows[0]}


def norm(run, names):
    return np.sqrt(sum(run[name] ** 2 for name in names))


def collections(run):
    """(begin, end) of each time the estimator collected samples [s]."""
    collecting = run["phase"] == "Collecting"
    edges = np.flatnonzero(np.diff(np.concatenate([[False], collecting, [False]]).astype(int)))
    t = np.append(run["t"], run["t"][-1])
    return [(t[a], t[b]) for a, b in edges.reshape(-1, 2)]


def draw(folder, picture):
    runs = {name: read(folder / f"{name}.csv") for name in ("compensated", "uncompensated")}
    torque = [f"tau_ext{i}" for i in range(1, 8)]
    error = [f"error_{axis}" for axis in "xyz"]
    on, off = runs["compensated"], runs["uncompensated"]
    attached = on["t"][np.argmax(on["m"] > 0)]

    plt.rcParams.update({"font.size": 10, "axes.spines.top": False, "axes.spines.right": False})
    figure, (above, middle, below) = plt.subplots(3, 1, figsize=(7.2, 6.6), sharex=True, constrained_layout=True)
    above.plot(off["t"], 1e3 * norm(off, error), color=WITHOUT, label="without compensation")
    above.plot(on["t"], 1e3 * norm(on, error), color=WITH, label="with compensation")
    above.set_ylabel("position error [mm]")
    above.set_ylim(bottom=0)
    above.legend(frameon=False, loc="center right")
    above.set_title(f"{on['m'].max():g} kg nobody announced", loc="left")

    known = on["mass"] > 0
    middle.fill_between(on["t"], on["mass"] - 2 * on["mass_std"], on["mass"] + 2 * on["mass_std"], where=known,
                        color=WITH, alpha=0.3, linewidth=0)
    middle.plot(on["t"], on["mass"], color=WITH, linewidth=1.2, label="estimate, 2 std. dev.")
    middle.plot(on["t"], on["m"], color="black", linestyle="--", linewidth=1, label="truth")
    middle.set_ylabel("mass [kg]")
    middle.legend(frameon=False, loc="lower right")

    below.plot(on["t"], norm(on, torque), color="black", linewidth=1)
    below.set_ylabel(r"$\Vert\tau_\mathrm{ext}\Vert_2$ [N m]")
    below.set_xlabel("time [s]")
    below.set_ylim(bottom=0)
    for begin, end in collections(on):
        for axes in (above, middle, below):
            axes.axvspan(begin - DETECTOR_WINDOW, begin, color=DETECTION, linewidth=0)
            axes.axvspan(begin, end, color=COLLECTION, linewidth=0)
        for x, text in ((begin - DETECTOR_WINDOW / 2, "detection"), ((begin + end) / 2, "collection")):
            below.annotate(text, (x, 1.01), xycoords=("data", "axes fraction"), ha="center", fontsize=8)
    for axes in (above, middle, below):
        axes.axvline(attached, color="grey", linestyle=":", linewidth=1)
        axes.set_xlim(0, on["t"][-1])
    above.annotate("payload appears", (attached, 0.97), xycoords=("data", "axes fraction"), xytext=(-4, 0),
                   textcoords="offset points", ha="right", va="top", fontsize=8, color="grey")
    figure.savefig(picture, dpi=150)


def main():
    parser = argparse.ArgumentParser(description="Draws the runs that rme_01_static_payload has written.")
    parser.add_argument("folder", type=pathlib.Path, help="what was given to --output")
    parser.add_argument("picture", type=pathlib.Path, nargs="?", help="file to write (default: static_payload.png there)")
    arguments = parser.parse_args()
    try:
        draw(arguments.folder, arguments.picture or arguments.folder / "static_payload.png")
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot.py: {error}")


if __name__ == "__main__":
    main()
