#!/usr/bin/env python3
"""Draws the masses that rme and recursive least squares estimate during a run, from what score_run --output has written.

    python3 plot.py DIR/RUN.csv PICTURE
"""
import argparse
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plotting import COLOURS, plt, read

DEVIATIONS = 1.645  # of a 90 % interval
DRAWN = {"recursive least squares": COLOURS[1], "observer-matched": COLOURS[2]}


def draw(rows, picture):
    series = {}
    for row in rows:
        series.setdefault(row["by"], []).append((row["t"], row["mass"], row["deviation"]))
    truth = rows[0]["truth"]
    figure, axes = plt.subplots(figsize=(7.2, 3.4), constrained_layout=True)
    axes.axhline(truth, color="#5c6673", linewidth=3, alpha=0.35, label="true mass")
    for name, colour in DRAWN.items():
        t, mass, _ = np.array(series[name]).T
        axes.plot(t, mass, color=colour, linewidth=1, label=name)
    t, mass, deviation = np.array(series["rme"]).T
    low, high = mass - DEVIATIONS * deviation, mass + DEVIATIONS * deviation
    axes.fill_between(t, np.maximum(low, 0), high, color=COLOURS[0], alpha=0.2, linewidth=0, label="rme, 90 % interval")
    axes.plot(t, mass, color=COLOURS[0], linewidth=1.4, label="rme")
    axes.set_ylim(min(0, -0.1 * truth), 2 * max(truth, 0.5))
    axes.set_xlabel("time [s]")
    axes.set_ylabel("mass [kg]")
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), ncol=5, fontsize=8)
    figure.savefig(picture, dpi=110, metadata={"Software": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        draw(read(arguments.run), arguments.picture)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot.py: {error}")
    print(arguments.picture)


if __name__ == "__main__":
    main()
