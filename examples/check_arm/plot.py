#!/usr/bin/env python3
"""Draws what check_arm --output DIR has written: DIR/check_arm.png.

    python3 plot.py DIR [PICTURE]

For each joint, the torque of an empty hand before and after friction and offset are subtracted: on the left over the
joint's velocity, on the right over time. At the bottom, the promise and its test: on the left the mean error after each
time, on the right the error of each simulated payload over its mass, with the 90 % intervals.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plotting import columns, main, plt

BEFORE, AFTER = "#d55e00", "#0072b2"
DEVIATIONS = 1.645  # of a 90 % interval


def draw_promise(folder, promise, test):
    try:
        trials = columns(folder / "trials.csv")
    except ValueError:  # one path only
        promise.axis("off")
        test.axis("off")
        promise.set_title("no promise: the logs show one path only")
        return
    weighed = trials["weighed"] == 1
    times = sorted(set(trials["after"]))
    errors = [np.abs(trials["error"][weighed & (trials["after"] == after)]).mean() for after in times]
    names = [f"{after:g}" for after in times]
    promise.bar(names, errors, color=AFTER, width=0.5)
    promise.set_title("the promise: mean error")
    promise.set_xlabel("time after the attachment [s]")
    promise.set_ylabel("error of the mass [kg]")
    after = max(times)
    shown = weighed & (trials["after"] == after)
    mass, error, half = trials["mass"][shown], trials["error"][shown], DEVIATIONS * trials["deviation"][shown]
    spread = mass + np.random.default_rng(1).uniform(-0.02, 0.02, mass.size) * mass.max()
    held = np.abs(error) <= half
    test.axhline(0, color="grey", linestyle=":", linewidth=1)
    for chosen, colour in ((held, AFTER), (~held, BEFORE)):
        test.errorbar(spread[chosen], error[chosen], yerr=half[chosen], fmt=".", color=colour, elinewidth=0.6)
    test.set_title(f"its test after {after:g} s: {held.sum()} of {held.size} 90 % intervals hold the mass")
    test.set_xlabel("mass of the simulated payload [kg]")
    test.set_ylabel("error of the mass [kg]")


def draw(folder):
    blocks = columns(folder / "blocks.csv")
    joints = sum(name.startswith("tau") for name in blocks)
    figure, axes = plt.subplots(
        joints + 1,
        2,
        figsize=(9, 1.2 * joints + 3.2),
        constrained_layout=True,
        gridspec_kw={"width_ratios": (1, 2), "height_ratios": (1,) * joints + (2,)},
    )
    # Logs one after the other.
    jumps = np.diff(blocks["t"], prepend=blocks["t"][0])
    jumps[jumps < 0] = 0.02
    t = np.cumsum(jumps)
    for j in range(1, joints + 1):
        left, right = axes[j - 1]
        left.plot(blocks[f"dq{j}"], blocks[f"tau{j}"], ".", markersize=1.5, color=BEFORE)
        left.plot(blocks[f"dq{j}"], blocks[f"left{j}"], ".", markersize=1.5, color=AFTER)
        left.set_title(f"joint {j}", fontsize=8)
        right.plot(t, blocks[f"tau{j}"], linewidth=0.6, color=BEFORE)
        right.plot(t, blocks[f"left{j}"], linewidth=0.6, color=AFTER)
        if j < joints:
            left.tick_params(labelbottom=False)
            right.tick_params(labelbottom=False)
    axes[joints // 2][0].set_ylabel("torque of an empty hand, means over 20 ms [N m]")
    axes[joints - 1][0].set_xlabel("velocity [rad/s]")
    axes[joints - 1][1].set_xlabel("time [s]")
    for row in axes[:joints]:
        row[0].sharex(axes[joints - 1][0])
        row[1].sharex(axes[joints - 1][1])
    draw_promise(folder, *axes[joints])
    lines = [plt.Line2D([], [], color=colour) for colour in (BEFORE, AFTER)]
    names = ("as it is", "without offset and friction")
    axes[0][1].legend(lines, names, loc="lower right", bbox_to_anchor=(1, 1), ncol=2, borderaxespad=0)
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw, "check_arm")
