#!/usr/bin/env python3
"""Draws what rme_prior_ablation --output DIR has written, after Figure 10 of the paper.

Parity plots for the arms with link-side sensing: each parameter's estimate over its true value. Perfect estimates are on the
dotted line. The rows are the network alone, the published pipeline with the published solver and with the exact posterior,
and the tracker half a second after the attachment; the colours tell estimates with the network from those without.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from plotting import main, plt, read

PARAMETERS = (("mass", "mass [kg]", 1), ("x", "x [mm]", 1e3), ("y", "y [mm]", 1e3), ("z", "z [mm]", 1e3))
WITH, WITHOUT = "#0072b2", "#d55e00"
ROWS = (("network alone", ((WITH, "network alone"),)),
        ("published pipeline", ((WITHOUT, "published pipeline without network"), (WITH, "published pipeline"))),
        ("pipeline (exact)", ((WITHOUT, "pipeline (exact) without network"), (WITH, "pipeline (exact)"))),
        ("tracker", ((WITHOUT, "tracker"),)))


def draw(folder):
    rows = [row for row in read(folder / "data_sets.csv") if row["sensing"] == "link side"]
    figure, axes = plt.subplots(len(ROWS), 4, figsize=(10, 9), constrained_layout=True, sharex="col", sharey="col")
    for line, (title, series) in zip(axes, ROWS):
        for ax, (name, label, unit) in zip(line, PARAMETERS):
            for colour, by in series:
                mine = [row for row in rows if row["by"] == by]
                ax.plot([unit * row[name] for row in mine], [unit * row[f"{name}_estimate"] for row in mine], ".",
                        markersize=3, color=colour, label="with the network" if colour == WITH else "without")
            truths = [unit * row[name] for row in rows]
            ax.plot([min(truths), max(truths)], [min(truths), max(truths)], color="grey", linestyle=":", linewidth=1)
            if ax in axes[0]:
                ax.set_title(label)
            if ax in axes[-1]:
                ax.set_xlabel("truth")
        line[0].set_ylabel(title)
    axes[1, 0].legend(loc="upper left")
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw)
