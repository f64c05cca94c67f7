#!/usr/bin/env python3
"""Draws what check_arm --output DIR has written: DIR/check_arm.png.

    python3 plot.py DIR [PICTURE]

For each joint, on the left the torque of an empty hand over the joint's velocity, before friction and offset are taken
off and after; on the right what is then left over time. Below, the lightest payload that shows through it.
"""
import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

BEFORE, AFTER = "#d55e00", "#0072b2"


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise ValueError(f"{path}: no rows")
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def draw(folder, picture):
    blocks, windows = read(folder / "blocks.csv"), read(folder / "windows.csv")
    joints = sum(name.startswith("tau") for name in blocks)
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    figure, axes = plt.subplots(
        joints + 1, 2, figsize=(9, 1.5 * joints + 2.4), constrained_layout=True, gridspec_kw={"width_ratios": (1, 2)}
    )
    # Logs one after the other.
    jumps = np.diff(blocks["t"], prepend=blocks["t"][0])
    jumps[jumps < 0] = 0.02
    t = np.cumsum(jumps)
    for j in range(1, joints + 1):
        left, right = axes[j - 1]
        left.plot(blocks[f"dq{j}"], blocks[f"tau{j}"], ".", markersize=1.5, color=BEFORE)
        left.plot(blocks[f"dq{j}"], blocks[f"left{j}"], ".", markersize=1.5, color=AFTER)
        left.set_ylabel(f"joint {j} [N m]")
        right.plot(t, blocks[f"tau{j}"], linewidth=0.6, color=BEFORE, label="as it is")
        right.plot(t, blocks[f"left{j}"], linewidth=0.6, color=AFTER, label="without offset and friction")
    axes[joints - 1][0].set_xlabel("velocity [rad/s]")
    axes[joints - 1][1].set_xlabel("time [s]")
    axes[0][1].legend(frameon=False, loc="upper right", ncols=2)
    axes[0][1].set_title("torque of an empty hand, means over 20 ms", loc="left")
    axes[joints][0].axis("off")
    seen = axes[joints][1]
    names = [f"{w:g} s" for w in windows["window"]]
    seen.bar(names, 4 * windows["mass"], color=AFTER, width=0.5)
    seen.set_ylabel("[kg]")
    seen.set_title("lightest payload that shows within", loc="left")
    figure.savefig(picture, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path, nargs="?")
    arguments = parser.parse_args()
    picture = arguments.picture or arguments.folder / "check_arm.png"
    try:
        draw(arguments.folder, picture)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot.py: {error}")
    print(picture)


if __name__ == "__main__":
    main()
