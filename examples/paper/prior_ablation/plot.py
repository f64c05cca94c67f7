#!/usr/bin/env python3
"""Draws what rme_prior_ablation --output DIR has written, after Figure 10 of the paper.

Parity plots: each parameter's estimate over its truth, on the dotted line if perfect. A row for the network alone, one for
each likelihood; a colour for each prior.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "experiment"))
from plotting import main, plt, read

PARAMETERS = (("mass", "mass [kg]", 1), ("x", "x [mm]", 1e3), ("y", "y [mm]", 1e3), ("z", "z [mm]", 1e3))
COLOURS = {"network": "#0072b2", "zero": "#d55e00", "fixed": "#bbbbbb"}
TITLES = {"none": "network alone", "estimator": "estimator", "published": "published likelihood"}


def draw(folder):
    rows = read(folder / "data_sets.csv")
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
                ax.set_title(label)
            if ax in axes[-1]:
                ax.set_xlabel("truth")
        line[0].set_ylabel(f"{title}")
    axes[1, 0].legend(loc="upper left")
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw)
