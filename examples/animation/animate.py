#!/usr/bin/env python3
"""Makes DIR/animation.gif of what rme_animation --output DIR and rme_render_arm DIR --film RATE have written.

    python3 animate.py DIR RATE [PICTURE]

Above, the arm without rme and with it, and in outline where it would be without the payload. Below, the mass that is
believed beside the true one, and how far the flange is from where it is to be.
"""
import argparse
import pathlib
import sys

import matplotlib.image
import numpy as np
from PIL import Image

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plotting import columns, plt

WITH, WITHOUT, TRUTH = "#0072b2", "#d55e00", "#5c6673"
# What happens, from when on [s]; as in animation.cpp.
STORY = (
    (0, "an empty hand"),
    (1, "somebody hands it a cup"),
    (2.5, "something is poured in"),
    (4.5, "held"),
    (5.5, "carried elsewhere"),
    (8, "dropped"),
)
SHOWN = (slice(40, 470), slice(30, 450))  # rows and columns of each half of a frame that show something
COLOURS = 96
LAST = 1500  # how long the last picture stays [ms]


def halves(path):
    picture = matplotlib.image.imread(path)[:, :, :3]
    middle = picture.shape[1] // 2
    return picture[:, :middle][SHOWN], picture[:, middle:][SHOWN]


class Page:
    """One figure, drawn anew for each instant."""

    def __init__(self, runs, first):
        self.runs = runs
        self.figure = plt.figure(figsize=(7.6, 5.6), dpi=100)
        self.views = []
        for image, name, colour, left in zip(first, ("without rme", "with rme"), (WITHOUT, WITH), (0.01, 0.505)):
            axis = self.figure.add_axes((left, 0.36, 0.485, 0.57))
            axis.set_axis_off()
            self.views.append(axis.imshow(image, interpolation="lanczos"))
            axis.text(0.03, 0.95, name, transform=axis.transAxes, color=colour, fontsize=13, weight="bold")
        self.caption = self.figure.text(0.5, 0.955, "", ha="center", fontsize=12)
        with_rme, without = runs
        mass = self.figure.add_axes((0.075, 0.085, 0.4, 0.24))
        mass.set_title("in the hand [kg]", fontsize=10)
        mass.plot(with_rme["t"], with_rme["m"], color=TRUTH, linewidth=3, alpha=0.35, label="true mass")
        self.mass = mass.plot([], [], color=WITH, linewidth=1.3, label="believed by rme")[0]
        mass.legend(loc="upper left")
        mass.set_ylim(0, 1.6 * with_rme["m"].max())
        distance = self.figure.add_axes((0.575, 0.085, 0.4, 0.24))
        distance.set_title("flange away from where it is to be [mm]", fontsize=10)
        self.distances = [
            distance.plot([], [], color=colour, linewidth=1.3)[0] for colour in (WITHOUT, WITH)
        ]
        distance.set_ylim(0, 1.15e3 * without["distance"].max())
        for axis in (mass, distance):
            axis.set_xlim(0, with_rme["t"][-1])
            axis.set_xlabel("time [s]", labelpad=1)
        self.now = [axis.axvline(0, color="0.75", linewidth=0.8) for axis in (mass, distance)]

    def at(self, t, images):
        with_rme, without = self.runs
        for view, image in zip(self.views, images):
            view.set_data(image)
        so_far = with_rme["t"] <= t + 1e-9
        self.mass.set_data(with_rme["t"][so_far], with_rme["mass"][so_far])
        for line, run in zip(self.distances, (without, with_rme)):  # in the order of their colours
            line.set_data(run["t"][so_far], 1e3 * run["distance"][so_far])
        for line in self.now:
            line.set_xdata([t, t])
        self.caption.set_text([what for begin, what in STORY if begin <= t + 1e-9][-1])
        self.figure.canvas.draw()
        return Image.fromarray(np.asarray(self.figure.canvas.buffer_rgba())[:, :, :3])


def animate(folder, rate, picture):
    runs = columns(folder / "with.csv"), columns(folder / "without.csv")
    files = sorted((folder / "frames").glob("*.png"))
    if not files:
        raise ValueError(f"{folder}/frames: no pictures")
    page = Page(runs, halves(files[0]))
    pages = [page.at(i / rate, halves(file)) for i, file in enumerate(files)]
    # One palette for all. What stays as it was is left transparent: that is what makes the file small.
    palette = pages[len(pages) // 2].quantize(COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    indices = [np.asarray(page.quantize(palette=palette, dither=Image.Dither.NONE)) for page in pages]
    changes = [np.where(now == before, COLOURS, now) for before, now in zip(indices, indices[1:])]
    images = [Image.fromarray(pixels.astype(np.uint8), mode="P") for pixels in [indices[0], *changes]]
    for image in images:
        image.putpalette(palette.getpalette())
    durations = [round(1000 / rate)] * (len(images) - 1) + [LAST]
    images[0].save(picture, save_all=True, append_images=images[1:], duration=durations, loop=0, optimize=False,
                   transparency=COLOURS, disposal=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("rate", type=float, help="pictures for each second")
    parser.add_argument("picture", type=pathlib.Path, nargs="?")
    arguments = parser.parse_args()
    try:
        animate(arguments.folder, arguments.rate, arguments.picture or arguments.folder / "animation.gif")
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"animate.py: {error}")


if __name__ == "__main__":
    main()
