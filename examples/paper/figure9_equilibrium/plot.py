#!/usr/bin/env python3
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from plotting import COLOURS, column, main, plt, read



def draw(folder):
    """Errors over time: CPIC alone dotted, with the published pipeline dashed, with the tracker solid."""
    rows = read(folder / "errors.csv")
    figure, axes = plt.subplots(1, 2, figsize=(8, 3), constrained_layout=True)
    for mass, colour in zip(sorted(set(column(rows, "m"))), COLOURS):
        for method, style in (("CPIC alone", ":"), ("published pipeline", "--"), ("tracker", "-")):
            mine = [row for row in rows if row["m"] == mass and row["method"] == method]
            for axis, key, unit in zip(axes, ("position", "orientation"), (1e3, 1)):
                axis.plot(column(mine, "t"), [max(1e-3, unit * row[key]) for row in mine], style, color=colour, linewidth=1,
                          label=f"{mass:g} kg" if style == "-" else None)
    for axis, title in zip(axes, ("position error [mm]", "orientation error [degrees]")):
        axis.set_yscale("log")
        axis.set_title(title)
        axis.set_xlabel("time since the attachment [s]")
    axes[0].set_ylim(bottom=0.02)
    axes[1].set_ylim(bottom=0.002)
    axes[0].legend(fontsize=7, ncol=2, title="dotted: CPIC alone; dashed: published pipeline", title_fontsize=7)
    return figure


if __name__ == "__main__":
    main("Draws what rme_figure9_equilibrium --output DIR has written.", draw)
