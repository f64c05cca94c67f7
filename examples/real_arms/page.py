#!/usr/bin/env python3
"""Writes docs/real_arms.md from what examples/real_arms/all has measured.

    python3 page.py DIR PAGE

DIR has scores.csv (written by score_run), simulated.csv, untrusted.txt (the runs with settings of which check_arm says not to
trust them) and body.md. The first paragraph is written from these.
"""
import csv
import math
import pathlib
import sys

ONLINE = ("recursive least squares", "observer-matched", "published pipeline", "KDL's wrench")

HEAD = """# Real arms

{first}

It is written by

    bash examples/real_arms/all RECORDINGS

The recordings were made by others and are not part of rme. For each arm, `check_arm` makes settings from a recording of the
empty hand; the block of text is what it promises, from that recording alone ([your_arm.md](your_arm.md)). The tables compare
methods on other recordings. All have the same settings, and the tare of the same empty run: offset, Coulomb and viscous
friction of each joint. The column "by" names them:

- **rme**: `rme::Estimator`. The loaded run follows an empty one, as an arm's day does, or it begins with the load in the hand
  ("from the start").
- **recursive least squares**: (m, m r), with a memory of 5 s, on the torque minus the tare.
- **observer-matched**: recursive least squares for ten inertial parameters on a regressor that has passed the observer's filter,
  minus the virtual object that it finds in the empty run (Kurdas, Hamad, Vorndamme, Mansfeld, Abdolshah and Haddadin, "Online
  Payload Identification for Tactile Robots Using the Momentum Observer", ICRA 2022), with a memory of 5 s.
- **published pipeline**: `rme::PublishedPipeline`, the paper's estimator, with the network that was trained for a Panda.
- **KDL's wrench**: where the log has measured torque, and no payload is simulated: the force along gravity that Orocos KDL's
  `ChainExternalWrenchEstimator` (gain 50/s) finds at the tip, averaged over 5 s. Singular values below 0.1 are left out; with
  KDL's own 1e-5 the error is tens of kilograms.
- **batch least squares**: (m, m r), offsets and friction from the whole run, after it. It is no rival online; it shows what the
  recording holds.

"Within 10 %" is the time after which the error has stayed below 10 % of the mass for a second. "False mass" is the largest mass
that was estimated at any time of an empty run. "90 % interval holds" is the share of the time from 5 s on in which the interval
contains the true mass; least squares and KDL state none. Where a payload is "simulated", the torque of a cube, 6 cm from the
tip, is added to the recorded torque; only the further friction that a real payload would cause in the gears is missing.

"""


def number(text):
    return float(text) if text else math.nan


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def errors_by_run(scores):
    """For each run, each method's mean error [kg]."""
    runs = {}
    for row in scores:
        runs.setdefault(row["run"], {"truth": number(row["truth"])})[row["by"]] = number(row["mean"])
    return runs


def grams(kilograms):
    return f"{1000 * kilograms:.0f} g"


def first_paragraph(scores, simulated, untrusted):
    """What a reader may expect of another arm, and where other methods are better."""
    runs = errors_by_run(scores)
    parts = []
    rivals = {run: min((by[m], m) for m in ONLINE if m in by) for run, by in runs.items()}
    loaded = {run: by for run, by in runs.items() if by["truth"] > 0 and run not in untrusted}
    empty = {run: by for run, by in runs.items() if by["truth"] == 0}
    if simulated:
        later = {after: [number(r["mae"]) for r in simulated if r["after"] == after] for after in ("1", "5")}
        held = [number(r["held"]) for r in simulated]
        parts.append(
            f"What to expect of another arm: the mean error of a simulated payload of a tenth to half of what the arm is "
            f"rated for was {min(later['1']):.0f} to {max(later['1']):.0f} g a second after it was attached, and "
            f"{min(later['5']):.0f} to {max(later['5']):.0f} g after five, over {len(later['1'])} recordings; the 90 % "
            f"intervals held the mass in {min(held):.0f} to {max(held):.0f} %."
        )
    if loaded:
        ours = [by["rme"] for by in loaded.values()]
        parts.append(
            f"On {len(loaded)} runs with a load, rme's mean error from 5 s on was {grams(min(ours))} to {grams(max(ours))}, "
            f"mean {grams(sum(ours) / len(ours))}; that of the best online rival of each run, chosen afterwards, "
            f"{grams(sum(rivals[run][0] for run in loaded) / len(loaded))}."
        )
        for run in untrusted:
            parts.append(
                f"Settings of which `check_arm` says not to trust them ({run}) give {grams(runs[run]['rme'])}, "
                f"{rivals[run][1]} {grams(rivals[run][0])}."
            )
        trusted = {run: by for run, by in runs.items() if run not in untrusted}
        beaten = {run: rivals[run] for run, by in trusted.items() if round(1000 * rivals[run][0]) < round(1000 * by["rme"])}
        parts.append(
            f"To the gram, rme was at least as good as each of them in {len(trusted) - len(beaten)} of the {len(trusted)} "
            f"other runs, those of an empty hand included."
        )
        if beaten:
            listed = "; ".join(
                f"{run} ({method}: {grams(error)}, rme: {grams(runs[run]['rme'])})" for run, (error, method) in beaten.items()
            )
            parts.append(f"Another method was better here: {listed}.")
    if empty:
        false = {by: max(number(r["false"]) for r in scores if r["by"] == by and number(r["truth"]) == 0)
                 for by in ("rme", *ONLINE) if any(r["by"] == by and number(r["truth"]) == 0 for r in scores)}
        listed = ", ".join(f"{by} {mass:.2f} kg" for by, mass in false.items())
        parts.append(f"The largest mass that an empty hand was ever taken to hold: {listed}.")
    return " ".join(parts)


def wrapped(text, width=125):
    lines, line = [], ""
    for word in text.split():
        if line and len(line) + 1 + len(word) > width:
            lines.append(line)
            line = word
        else:
            line = f"{line} {word}".strip()
    return "\n".join(lines + [line])


def main():
    folder, page = map(pathlib.Path, sys.argv[1:])
    scores = rows_of(folder / "scores.csv") if (folder / "scores.csv").exists() else []
    simulated = rows_of(folder / "simulated.csv")
    untrusted = (folder / "untrusted.txt").read_text(encoding="utf-8").splitlines()
    head = HEAD.format(first=wrapped(first_paragraph(scores, simulated, untrusted)))
    body = (folder / "body.md").read_text(encoding="utf-8")
    if "| KDL's wrench |" not in body:
        body += "\nOrocos KDL was not found when this was built, so that the rows of its wrench estimator are missing.\n"
    page.write_text(head + body.rstrip("\n") + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
