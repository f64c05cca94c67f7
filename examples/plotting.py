"""What the plots of the examples share."""
import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
                     "axes.titlelocation": "left", "legend.frameon": False})


def read(path):
    """The rows of a CSV file, numbers where they are numbers."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text

    with open(path, newline="") as file:
        rows = [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]
    if not rows:
        raise ValueError(f"{path}: no rows")
    return rows


def column(rows, name):
    return [row[name] for row in rows]


def columns(path):
    """A CSV file of numbers as arrays by name."""
    rows = read(path)
    return {name: np.array(column(rows, name)) for name in rows[0]}


def main(description, draw, name=None, dpi=110):
    """plot.py DIR [PICTURE]: draws what a program has written to DIR with --output.

    draw(DIR) gives the figure. PICTURE is DIR/<name>.png unless said, the name that of the script's folder unless given.
    """
    name = name or pathlib.Path(sys.argv[0]).resolve().parent.name
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("folder", type=pathlib.Path, metavar="DIR")
    parser.add_argument("picture", type=pathlib.Path, metavar="PICTURE", nargs="?")
    arguments = parser.parse_args()
    picture = arguments.picture or arguments.folder / f"{name}.png"
    try:
        figure = draw(arguments.folder)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"{parser.prog}: {error}")
    picture.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(picture, dpi=dpi, metadata={"Software": None})
    print(picture)
