#!/usr/bin/env python3
"""Draws the output of `replay_log LOG --json`: the estimate at each instant of a log.

    replay_log LOG.csv ... --json > beliefs.json
    python3 plot.py beliefs.json [PICTURE]

At the top, the mass with its 90 % interval, the true mass where the log has it, and with --compare the masses of other
methods; instants at which something probably touches the arm are shaded. In the middle, the probabilities of the modes; at
the bottom, health, which is about 1 if the torque is as model and payload predict it.
"""
import argparse
import json
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plotting import COLOURS, plt

BELIEVED, TRUTH = "#0072b2", "#5c6673"
MODES = {"empty": "#d9dde1", "held": "#0072b2", "pouring": "#56b4e9", "disturbed": "#d55e00", "changing": "#009e73"}
DEVIATIONS = 1.645  # of a 90 % interval
TOUCHED = 0.5  # probability of "disturbed" from which on contact is shaded


def read(path):
    with open(path, encoding="utf-8") as file:
        entries = [json.loads(line) for line in file]
    beliefs = [entry for entry in entries if entry["type"] == "estimate"]
    if not beliefs:
        raise ValueError(f"{path}: no estimates")
    rivals = {}
    for entry in entries:
        if entry["type"] == "rival":
            rivals.setdefault(entry["by"], []).append((entry["t"], entry["mass"]))
    return beliefs, rivals


def draw(beliefs, rivals, picture):
    t, mass, deviation = (np.array(column) for column in zip(*((b["t"], b["mass"], b["std"][0]) for b in beliefs)))
    figure, (above, middle, below) = plt.subplots(
        3, 1, figsize=(7.2, 5.4), sharex=True, constrained_layout=True, gridspec_kw={"height_ratios": (3, 1.3, 1)}
    )
    if all(b["truth"] for b in beliefs):
        above.plot(t, [b["truth"][0] for b in beliefs], color=TRUTH, linewidth=3, alpha=0.35, label="true mass")
    low, high = mass - DEVIATIONS * deviation, mass + DEVIATIONS * deviation
    above.fill_between(t, np.maximum(low, 0), high, color=BELIEVED, alpha=0.25, linewidth=0, label="90 % interval")
    above.plot(t, mass, color=BELIEVED, linewidth=1.2, label="believed")
    for (name, masses), colour in zip(rivals.items(), COLOURS[1:]):
        if len(masses) > 1:
            above.plot(*np.array(masses).T, color=colour, linewidth=0.8, label=name)
    touched = np.array([b["probability"]["disturbed"] > TOUCHED for b in beliefs])
    if touched.any():
        above.fill_between(t, 0, 1, where=touched, transform=above.get_xaxis_transform(), color=MODES["disturbed"],
                           alpha=0.15, linewidth=0, label="contact")
    above.set_ylabel("mass [kg]")
    above.set_ylim(0, 1.1 * max(mass.max(), 1e-3))
    above.legend(loc="lower left", bbox_to_anchor=(0, 1), ncol=4, fontsize=8)
    shares = [[b["probability"][name] for b in beliefs] for name in MODES]
    middle.stackplot(t, shares, colors=list(MODES.values()), labels=list(MODES))
    middle.set_ylabel("probability")
    middle.set_ylim(0, 1)
    middle.legend(loc="lower left", bbox_to_anchor=(0, 1), ncol=len(MODES), fontsize=8)
    below.semilogy(t, [b["health"] for b in beliefs], color=TRUTH, linewidth=1)
    below.axhline(1, color="0.8", linewidth=0.8)
    below.set_ylim(0.09, 110)
    below.set_ylabel("health")
    below.set_xlabel("time [s]")
    figure.savefig(picture, dpi=130)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("beliefs", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path, nargs="?")
    arguments = parser.parse_args()
    picture = arguments.picture or arguments.beliefs.with_suffix(".png")
    try:
        draw(*read(arguments.beliefs), picture)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot.py: {error}")
    print(picture)


if __name__ == "__main__":
    main()
