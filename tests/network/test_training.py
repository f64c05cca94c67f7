#!/usr/bin/env python3
"""A small training end to end: generate, train, export, load in C++, compare.

test_training.py GENERATE_DATASET RUN_NETWORK TRAIN.py TEST_RUN_NETWORK.py. Ends with 77 (skipped) without PyTorch.
"""
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import torch  # noqa: F401
except ImportError as missing:
    print(f"skipped: needs python3-{missing.name.split('.')[0].lower()}")  # Debian's name of the package
    sys.exit(77)
generator, program, train, test_run_network = sys.argv[1:5]

with tempfile.TemporaryDirectory() as name:
    folder = Path(name)

    def run():
        return subprocess.run([sys.executable, train, "panda", "--generator", generator, "--output", folder, "--events",
                               "500", "--epochs", "6", "--threads", "1"], capture_output=True, text=True, check=True)

    print(run().stdout)
    with open(folder / "loss.csv", encoding="utf-8") as file:
        losses = [float(row["validation"]) for row in csv.DictReader(file)]
    # Payloads of 0.2 to 2 kg have a standard deviation of 0.52 kg, which is what a network that learned nothing scores.
    errors = json.loads((folder / "metrics.json").read_text(encoding="utf-8"))
    assert len(losses) == 6 and losses[-1] < 0.6 * losses[0], losses
    assert errors["test_any_pose"]["mass_rmse"] < 0.35, errors
    subprocess.run([sys.executable, test_run_network, program, folder / "model.json", folder / "golden.json"], check=True)

    # Started again, it goes on from the checkpoint: no epoch is left, and the result is the same.
    first = (folder / "model.json").read_text(encoding="utf-8")
    (folder / "model.json").unlink()
    assert "going on after epoch 6" in run().stdout
    assert (folder / "model.json").read_text(encoding="utf-8") == first
