#!/usr/bin/env python3
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from plotting import COLOURS, column, main, plt, read



def spans(rows, key):
    """(begin, length) of each time span in which a condition holds."""
    out, begin = [], None
    for row in rows:
        if row[key] and begin is None:
            begin = row["t"]
        if not row[key] and begin is not None:
            out.append((begin, row["t"] - begin))
            begin = None
    return out if begin is None else out + [(begin, rows[-1]["t"] - begin)]


def draw(folder):
    """The norm of tau_ext with the published conditions; below it, the estimated masses and the true one."""
    rows = read(folder / "detection.csv")
    scenarios = list(dict.fromkeys(row["scenario"] for row in rows))
    figure, axes = plt.subplots(2, len(scenarios), figsize=(2.1 * len(scenarios), 3.8), sharex="col", sharey="row",
                                constrained_layout=True, squeeze=False)
    for (above, below), scenario in zip(axes.T, scenarios):
        mine = [row for row in rows if row["scenario"] == scenario and row["t"] > -0.5]
        t = column(mine, "t")
        above.plot(t, column(mine, "norm"), color="black", linewidth=1)
        for place, (key, label) in enumerate((("rapid_change", "rapid change"), ("stabilised", "stabilised"),
                                              ("detected", "detected (published)"))):
            above.broken_barh(spans(mine, key), (-0.6 - 0.5 * place, 0.35), color=COLOURS[place],
                              label=label if scenario == scenarios[0] else None)
        above.set_title(scenario, fontsize=8)
        below.plot(t, column(mine, "true_mass"), color="grey", linestyle=":", label="true")
        below.plot(t, column(mine, "published_mass"), color=COLOURS[2], linewidth=1, label="published pipeline")
        below.plot(t, column(mine, "mass"), color=COLOURS[0], linewidth=1, label="tracker")
        below.set_xlabel("time since the event [s]")
    axes[0][0].set_ylabel("|tau_ext| [N m]")
    axes[1][0].set_ylabel("mass [kg]")
    axes[0][0].legend(fontsize=6, loc="center right")
    axes[1][0].legend(fontsize=7)
    return figure


if __name__ == "__main__":
    main("Draws what rme_figure7_detection --output DIR has written.", draw)
