#!/usr/bin/env python3
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from plotting import COLOURS, column, main, plt, read

PUBLISHED = {"m": (2.480, 2.436, 2.467, 2.081), "x": (1.607, 0.909, 0.860, 0.979), "y": (0.574, 0.468, 0.396, 0.477),
             "z": (8.935, 4.827, 3.880, 1.250)}  # 1e-3 kg^2 and m^2
INTERVALS = (0.05, 0.1, 0.2, 0.3)


def draw(folder):
    """Root mean square error of each method over the length of the data."""
    rows = read(folder / "errors.csv")
    figure, axes = plt.subplots(1, 4, figsize=(10, 2.6), constrained_layout=True)
    for axis, key in zip(axes, PUBLISHED):
        axis.plot([1e3 * t for t in INTERVALS], [1e3 * (1e-3 * e) ** 0.5 for e in PUBLISHED[key]], "x-",
                  color=COLOURS[1], label="published, real arm")
        for who, style, colour, label in (("first", "o:", COLOURS[2], "published pipeline, first estimate"),
                                          ("last", "o-", COLOURS[2], "published pipeline, last estimate"),
                                          ("tracker", "o:", COLOURS[0], "tracker, since the attachment"),
                                          ("told", "o-", COLOURS[0], "tracker told of the sensing")):
            points = []
            for interval in INTERVALS:
                errors = [row[f"{key}_error"] for row in rows if row["who"] == who and row["interval"] == interval]
                if errors:
                    points.append((1e3 * interval, 1e3 * (sum(e * e for e in errors) / len(errors)) ** 0.5))
            axis.plot(*zip(*points), style, color=colour, markersize=4, label=label)
        axis.set_yscale("log")
        axis.set_xticks([1e3 * t for t in INTERVALS])
        axis.set_xlabel("data [ms]")
        axis.set_title("rms error of mass [g]" if key == "m" else f"rms error of {key} [mm]")
    axes[0].legend(fontsize=7)
    return figure


if __name__ == "__main__":
    main("Draws what rme_table3_interval --output DIR has written.", draw)
