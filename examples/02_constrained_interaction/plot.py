#!/usr/bin/env python3
"""Draws what rme_02_constrained_interaction --output DIR has written: DIR/constrained_interaction.png.

    python3 plot.py DIR [PICTURE]

From top to bottom: distance to the wall, distance to the nearest joint limit, torque of the joint whose torque varies
most, stored energy. The two pushes are shaded.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plotting import columns, main, plt

WITH, WITHOUT, PUSH, FORBIDDEN = "#0072b2", "#d55e00", "#e8e8e8", "#f6d5d5"


def draw(folder):
    runs = {name: columns(folder / f"{name}.csv") for name in ("constrained", "unconstrained")}
    on, off = runs["constrained"], runs["unconstrained"]
    torque = max((f"tau{j}" for j in range(1, 8)), key=lambda name: np.ptp(on[name]))

    plt.rcParams["font.size"] = 10
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
    axes[0].legend(loc="best")
    axes[0].set_title("pushed into a wall, then up against a joint limit (pushes in grey)")
    axes[-1].set_xlabel("time [s]")
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw, "constrained_interaction", dpi=150)
