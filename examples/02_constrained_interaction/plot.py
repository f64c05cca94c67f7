#!/usr/bin/env python3
"""Draws what rme_02_constrained_interaction --output DIR has written: DIR/constrained_interaction.png.

    python3 plot.py DIR [PICTURE]

From above: distance to the wall, distance to the nearest joint limit, torque of the joint that is busiest, stored energy.
The two pushes are shaded.
"""
import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

WITH, WITHOUT, PUSH, FORBIDDEN = "#0072b2", "#d55e00", "#e8e8e8", "#f6d5d5"


def read(path):
    """Columns by name."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise ValueError(f"{path}: no rows")
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def draw(folder, picture):
    runs = {name: read(folder / f"{name}.csv") for name in ("constrained", "unconstrained")}
    on, off = runs["constrained"], runs["unconstrained"]
    torque = max((f"tau{j}" for j in range(1, 8)), key=lambda name: np.ptp(on[name]))

    plt.rcParams.update({"font.size": 10, "axes.spines.top": False, "axes.spines.right": False})
    figure, axes = plt.subplots(4, 1, figsize=(7.2, 8.4), sharex=True, constrained_layout=True)
    rows = [
        ("h_wall", 1e3, "distance to\nthe wall [mm]"),
        ("h_limit", 1, "distance to the nearest\njoint limit [rad]"),
        (torque, 1, f"torque of joint {torque[3:]} [N m]"),
        ("stored", 1, "stored energy [J]"),
    ]
    for axis, (name, scale, label) in zip(axes, rows):
        axis.plot(off["t"], scale * off[name], color=WITHOUT, label="unconstrained")
        axis.plot(on["t"], scale * on[name], color=WITH, label="CPIC")
        axis.set_ylabel(label)
        pushed = np.abs(on["push_x"]) > 0
        for edge in np.flatnonzero(np.diff(pushed.astype(int)) == 1):
            end = edge + 1 + np.argmin(pushed[edge + 1 :])
            axis.axvspan(on["t"][edge], on["t"][end], color=PUSH, zorder=0)
        if name.startswith("h_"):
            low, high = axis.get_ylim()
            axis.axhspan(min(low, 0), 0, color=FORBIDDEN, zorder=0)
            axis.set_ylim(low, high)
    axes[0].legend(frameon=False, loc="best")
    axes[0].set_title("pushed into a wall, then up against a joint limit (pushes in grey)", loc="left")
    axes[-1].set_xlabel("time [s]")
    figure.savefig(picture, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path, nargs="?")
    arguments = parser.parse_args()
    try:
        draw(arguments.folder, arguments.picture or arguments.folder / "constrained_interaction.png")
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot.py: {error}")


if __name__ == "__main__":
    main()
