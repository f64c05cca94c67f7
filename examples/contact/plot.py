#!/usr/bin/env python3
"""Draws what rme_touch --output DIR has written: DIR/touch.png.

    python3 plot.py DIR [PICTURE]

From top to bottom, for the same touch of three arms that carry 2 kg: what each way to detect a contact sees, relative to
its threshold. The touch is shaded; a dot marks when it was noticed, and the arm stopped.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plotting import columns, main, plt

TOUCH = "#e8e8e8"
ROWS = (("raw", "raw", "#d55e00"),
        ("static", "static compensation", "#009e73"),
        ("rme", "rme", "#0072b2"))


def draw(folder):
    run = columns(folder / "touch.csv")
    t, touched = run["t"], run["t"][run["force"] > 0]

    plt.rcParams["font.size"] = 10
    figure, axes = plt.subplots(3, 1, figsize=(7.2, 6.0), sharex=True, sharey=True, constrained_layout=True)
    for axis, (name, label, colour) in zip(axes, ROWS):
        level = run[name]
        axis.axvspan(touched[0], touched[-1], color=TOUCH, zorder=0)
        axis.axhline(1, color="black", linestyle="--", linewidth=1)
        axis.plot(t, level, color=colour, linewidth=1)
        above = (t > 0) & (t <= touched[-1]) & (level > 1)
        noticed = "not noticed"
        if above.any():
            first = np.argmax(above)
            axis.plot(t[first], 1, "o", color="black", markersize=5, zorder=3)
            noticed = f"noticed after {1e3 * t[first]:.0f} ms, at {run['force'][first]:.1f} N"
        axis.set_title(f"{label}: {noticed}", fontsize=10)
        axis.set_ylabel("signal / threshold")
    axes[0].set_yscale("log")  # what is far below its threshold, and far above it, is seen in one picture
    axes[0].set_ylim(0.08, 50)
    axes[0].set_yticks([0.1, 1, 10], ["0.1", "1", "10"])
    axes[0].set_xlim(t[0], t[-1])
    axes[0].text(t[0] + 0.05, 1.1, "threshold", fontsize=8, va="bottom")
    axes[0].text(touched[0] + 0.05, 40, f"touch of {run['force'].max():g} N", fontsize=8, va="top")
    axes[-1].set_xlabel("time since the touch began [s]")
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw, "touch", dpi=150)
