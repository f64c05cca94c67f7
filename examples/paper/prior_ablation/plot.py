#!/usr/bin/env python3
"""Draws what rme_prior_ablation --output DIR has written: DIR/prior_ablation.png, after Figure 10 of the paper.

    python3 plot.py DIR [PICTURE]

Parity plots: each parameter's estimate over its truth, on the dotted line if perfect. A row for the network alone, one for
each likelihood; a colour for each prior.
"""
import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

PARAMETERS = (("mass", "mass [kg]", 1), ("x", "x [mm]", 1e3), ("y", "y [mm]", 1e3), ("z", "z [mm]", 1e3))
COLOURS = {"network": "#0072b2", "zero": "#d55e00", "fixed": "#bbbbbb"}
TITLES = {"none": "network alone", "estimator": "estimator", "published": "published likelihood"}


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise ValueError(f"{path}: no rows")
    return rows


def draw(folder, picture):
    rows = read(folder / "data_sets.csv")
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    figure, axes = plt.subplots(len(TITLES), 4, figsize=(10, 7), constrained_layout=True, sharex="col", sharey="col")
    for line, (likelihood, title) in zip(axes, TITLES.items()):
        for ax, (name, label, unit) in zip(line, PARAMETERS):
            for prior in ("fixed", "zero", "network"):
                mine = [row for row in rows if (row["likelihood"], row["prior"]) == (likelihood, prior)]
                ax.plot([unit * float(row[name]) for row in mine], [unit * float(row[f"{name}_estimate"]) for row in mine],
                        ".", markersize=4, color=COLOURS[prior], label=f"{prior} prior" if mine else None)
            truths = [unit * float(row[name]) for row in rows]
            ax.plot([min(truths), max(truths)], [min(truths), max(truths)], color="grey", linestyle=":", linewidth=1)
            if ax in axes[0]:
                ax.set_title(label, loc="left")
            if ax in axes[-1]:
                ax.set_xlabel("truth")
        line[0].set_ylabel(f"{title}")
    axes[1, 0].legend(frameon=False, loc="upper left")
    figure.savefig(picture, dpi=150)


def main():
    parser = argparse.ArgumentParser(description="Draws what rme_prior_ablation has written.")
    parser.add_argument("folder", type=pathlib.Path, help="what was given to --output")
    parser.add_argument("picture", type=pathlib.Path, nargs="?", help="file to write (default: prior_ablation.png there)")
    arguments = parser.parse_args()
    try:
        draw(arguments.folder, arguments.picture or arguments.folder / "prior_ablation.png")
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot.py: {error}")


if __name__ == "__main__":
    main()
