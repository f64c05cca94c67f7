#!/usr/bin/env python3
"""Draws what check_arm --output DIR has written: DIR/check_arm.png.

    python3 plot.py DIR [PICTURE]

For each joint, the torque of an empty hand before and after friction and offset are subtracted: on the left over the
joint's velocity, on the right over time. At the bottom, the lightest payload that shows within each time.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plotting import columns, main, plt

BEFORE, AFTER = "#d55e00", "#0072b2"


def draw(folder):
    blocks, windows = columns(folder / "blocks.csv"), columns(folder / "windows.csv")
    joints = sum(name.startswith("tau") for name in blocks)
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
    axes[0][1].legend(loc="upper right", ncols=2)
    axes[0][1].set_title("torque of an empty hand, means over 20 ms")
    axes[joints][0].axis("off")
    seen = axes[joints][1]
    names = [f"{w:g} s" for w in windows["window"]]
    seen.bar(names, 4 * windows["mass"], color=AFTER, width=0.5)
    seen.set_ylabel("[kg]")
    seen.set_title("lightest payload that shows within")
    return figure


if __name__ == "__main__":
    main(__doc__.splitlines()[0], draw, "check_arm")
