#!/usr/bin/env python3
"""Trains a mismatch network on the synthetic arm and writes it as JSON.

    train.py panda     --generator build/examples/training/generate_dataset --output build/output/panda
    train.py published --generator build/examples/training/generate_dataset --output build/output/published

published: the paper's recipe (Table 4): 350 payloads at the ready pose, 3 windows each, world axes, Adam 1e-4.
panda:     the shipped model's: 8,000 payloads at any pose, 4 windows each, end-effector axes, a tenth of the damping,
           random rotations about the flange's axis, a loss relative to 0.1 kg and 0.02, 0.02, 0.05 m, a learning
           rate that falls from 1e-3 to 0 along a cosine.

Writes into the output folder: model.json, golden.json (PyTorch's outputs for 1,000 windows, see golden.py), loss.csv,
loss.png (Figure 12 of the paper), metrics.json. After an interruption, run it again: it continues at the last
checkpoint. The same seed, data and machine give the same network. Needs PyTorch 1.13 or later; a GPU is used if there
is one.
"""
import argparse
import csv
import json
import math
import os
import subprocess
import sys
import time
from dataclasses import asdict, dataclass

import numpy as np
import torch

import golden
from network import OUTPUTS, MismatchNetwork, to_json, write_json


@dataclass
class Recipe:
    events: int
    windows: int
    pose: str
    frame: str
    damping: float     # lambda of the pseudo-wrench
    epochs: int
    batch: int
    rate: float        # learning rate
    cosine: bool       # the learning rate rises over two epochs and then falls to zero; otherwise it is constant
    dropout: float
    turns: bool        # augment by random rotations under which the physics is the same
    scale: tuple       # the loss counts errors relative to these (kg, m, m, m)
    patience: int      # epochs without a better validation loss after which the training stops


RECIPES = {
    # 840 training windows in batches of 84: 5,000 epochs are the paper's 50,000 iterations.
    "published": Recipe(350, 3, "ready", "world", 1e-2, 5000, 84, 1e-4, False, 0.1, False, (1, 1, 1, 1), 5000),
    "panda": Recipe(8000, 4, "any", "end_effector", 1e-3, 50, 256, 1e-3, True, 0.0, True, (0.1, 0.02, 0.02, 0.05), 50),
}


class Dataset:
    """A file of generate_dataset: one tensor for each column."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.header = json.loads(file.readline())
            rows = np.fromfile(file, "<f4").reshape(self.header["rows"], -1)
        begin = 0
        for name, shape in self.header["columns"]:
            end = begin + int(np.prod(shape))
            setattr(self, name, torch.from_numpy(rows[:, begin:end].reshape(-1, *shape).copy()))
            begin = end
        assert begin == rows.shape[1], f"{path}: the header does not fit the numbers"


def generate(generator, path, events, windows, pose, damping, seed):
    """Reads a data set, and makes it first if the file does not exist."""
    if not os.path.exists(path):
        subprocess.run([generator, path + ".part", "--events", str(events), "--windows", str(windows), "--pose", pose,
                        "--damping", str(damping), "--seed", str(seed)], check=True)
        os.replace(path + ".part", path)
    return Dataset(path)


def turned(windows, theta, frame, generator):
    """The same events with the flange's axes, or the robot's base, turned about z by random angles.

    Turning the flange's axes adds a constant to the last joint's angle; turning the base adds one to the first joint's.
    Neither changes the joint torques.
    """
    angle = (2 * math.pi * torch.rand(len(windows), generator=generator)).to(windows.device)
    cos, sin, zero, one = angle.cos(), angle.sin(), torch.zeros_like(angle), torch.ones_like(angle)
    turn = torch.stack([cos, -sin, zero, sin, cos, zero, zero, zero, one], 1).reshape(-1, 3, 3)
    # Force and moment are rotated in the same way, in each sample.
    pairs = windows.reshape(len(windows), -1, 3) @ turn.transpose(1, 2)
    if frame == "end_effector":
        theta = torch.cat([theta[:, :1], (turn @ theta[:, 1:, None])[:, :, 0]], 1)
    return pairs.reshape(windows.shape), theta


def metrics(network, data, frame, device):
    """Errors on the payloads of 0.3 kg and more; the part of the CoM along gravity does not show at rest."""
    with torch.no_grad():
        predicted = torch.cat([network(part.to(device)).cpu() for part in getattr(data, frame).split(4096)])
    keep = data.theta[:, 0] >= 0.3
    friction = data.friction_shows[keep, 0] > 0.5
    error = (predicted - data.theta)[keep]
    down = data.gravity_direction[keep]
    along = (error[:, 1:] * down).sum(1)
    across = (error[:, 1:] - along[:, None] * down).norm(dim=1)

    def rms(x):
        return round(float(x.pow(2).mean().sqrt()), 5)

    return {"mass_rmse": rms(error[:, 0]), "mass_bias": round(float(error[:, 0].mean()), 5),
            "mass_rmse_joint_friction": rms(error[friction, 0]), "mass_rmse_link_side": rms(error[~friction, 0]),
            "com_across_gravity_rmse_per_axis": round(rms(across) / math.sqrt(2), 5),
            "com_across_gravity_mean": round(float(across.mean()), 5), "com_along_gravity_rmse": rms(along),
            **{f"{name}_rmse": rms(error[:, i]) for i, name in enumerate(OUTPUTS) if i > 0}}


def plot(history, path):
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError:
        print("no matplotlib: loss.png is left out")
        return
    figure, axes = pyplot.subplots(figsize=(6, 4))
    epochs = [row["epoch"] for row in history]
    axes.semilogy(epochs, [row["training"] for row in history], label="training")
    axes.semilogy(epochs, [row["validation"] for row in history], label="validation (other payloads)")
    axes.set(xlabel="epoch", ylabel="loss")
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("recipe", choices=RECIPES)
    parser.add_argument("--generator", required=True, help="the program generate_dataset")
    parser.add_argument("--output", required=True, help="folder; made if need be")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--frame", choices=["world", "end_effector"], help="other axes than the recipe's")
    parser.add_argument("--epochs", type=int, help="another number than the recipe's")
    parser.add_argument("--events", type=int, help="another number of payloads than the recipe's")
    parser.add_argument("--threads", type=int, default=torch.get_num_threads())
    arguments = parser.parse_args()
    recipe = RECIPES[arguments.recipe]
    recipe.frame = arguments.frame or recipe.frame
    recipe.epochs = arguments.epochs or recipe.epochs
    recipe.events = arguments.events or recipe.events
    os.makedirs(arguments.output, exist_ok=True)

    def output(name):
        return os.path.join(arguments.output, name)

    torch.set_num_threads(arguments.threads)
    torch.manual_seed(arguments.seed)
    device = "cuda" if torch.cuda.is_available() else "cpu"
    # Test events have another seed, and so other payloads, poses, gains and sensor errors.
    data = generate(arguments.generator, output("train.bin"), recipe.events, recipe.windows, recipe.pose,
                    recipe.damping, 1000 * arguments.seed + 1)
    tests = {f"test_{pose}_pose": generate(arguments.generator, output(f"test_{pose}.bin"), max(recipe.events // 8, 50),
                                           4, pose, recipe.damping, 1000 * arguments.seed + 2) for pose in ("any", "ready")}

    inputs, theta = getattr(data, recipe.frame).to(device), data.theta.to(device)
    # All windows of a payload belong to the same part of the split.
    validation = data.event[:, 0] >= 0.8 * data.header["events"]
    training = (~validation).nonzero()[:, 0]
    mean, std = inputs[training].mean((0, 1)), inputs[training].std((0, 1))
    network = MismatchNetwork(mean.cpu(), std.cpu(), recipe.dropout).to(device)
    # The head learns standardised outputs; at the end, their mean and scale are included in it.
    middle, spread = theta[training].mean(0), theta[training].std(0)
    unit = spread / torch.tensor(recipe.scale, device=device)

    def loss_of(windows, target):
        return ((network(windows) - (target - middle) / spread) * unit).pow(2).mean()

    optimizer = torch.optim.Adam(network.parameters(), lr=recipe.rate)
    batches = math.ceil(len(training) / recipe.batch)
    steps = recipe.epochs * batches

    def schedule(step):
        warm = min(1, (step + 1) / (2 * batches))
        return warm * 0.5 * (1 + math.cos(math.pi * min(1, step / steps))) if recipe.cosine else 1.0

    scheduler = torch.optim.lr_scheduler.LambdaLR(optimizer, schedule)
    shuffle = torch.Generator().manual_seed(arguments.seed)
    history, best, best_state, best_epoch, first, spent = [], math.inf, None, 0, 0, 0.0
    checkpoint = output("checkpoint.pt")
    if os.path.exists(checkpoint):
        saved = torch.load(checkpoint, map_location="cpu")
        if saved["arguments"] != (asdict(recipe), arguments.seed):
            sys.exit(f"{checkpoint}: belongs to another recipe or seed; remove it or choose another folder")
        network.load_state_dict(saved["network"])
        optimizer.load_state_dict(saved["optimizer"])
        scheduler.load_state_dict(saved["scheduler"])
        torch.set_rng_state(saved["random"])
        shuffle.set_state(saved["shuffle"])
        history, best, best_state, best_epoch, spent = saved["history"]
        first = len(history)
        print(f"going on after epoch {first}")

    start = time.monotonic() - spent
    for epoch in range(first, recipe.epochs):
        if epoch - best_epoch >= recipe.patience:
            print(f"\nno better validation loss for {recipe.patience} epochs")
            break
        network.train()
        total = 0.0
        for chosen in training[torch.randperm(len(training), generator=shuffle)].split(recipe.batch):
            windows, target = inputs[chosen], theta[chosen]
            if recipe.turns:
                windows, target = turned(windows, target, recipe.frame, shuffle)
            loss = loss_of(windows, target)
            optimizer.zero_grad()
            loss.backward()
            torch.nn.utils.clip_grad_norm_(network.parameters(), 1.0)
            optimizer.step()
            scheduler.step()
            total += loss.item() * len(chosen)
        network.eval()
        with torch.no_grad():
            parts = zip(inputs[validation].split(4096), theta[validation].split(4096))
            validated = sum(loss_of(*part).item() * len(part[0]) for part in parts) / int(validation.sum())
        history.append({"epoch": epoch + 1, "training": total / len(training), "validation": validated})
        if validated < best:
            best, best_epoch = validated, epoch
            best_state = {name: tensor.clone() for name, tensor in network.state_dict().items()}
        spent = time.monotonic() - start
        if recipe.epochs <= 200 or epoch % 50 == 49:
            torch.save({"arguments": (asdict(recipe), arguments.seed), "network": network.state_dict(),
                        "optimizer": optimizer.state_dict(), "scheduler": scheduler.state_dict(),
                        "random": torch.get_rng_state(), "shuffle": shuffle.get_state(),
                        "history": (history, best, best_state, best_epoch, spent)}, checkpoint + ".part")
            os.replace(checkpoint + ".part", checkpoint)
            print(f"epoch {epoch + 1} of {recipe.epochs}: training {history[-1]['training']:.5f}, "
                  f"validation {validated:.5f}, best {best:.5f}, {spent:.0f} s", flush=True)

    network.load_state_dict(best_state)
    network.eval()
    with torch.no_grad():
        network.head.weight.mul_(spread[:, None])
        network.head.bias.mul_(spread).add_(middle)
    report = {name: metrics(network, test, recipe.frame, device) for name, test in tests.items()}
    print(json.dumps(report, indent=1))

    provenance = {"program": "examples/training/train.py", "recipe": arguments.recipe, **asdict(recipe),
                  "seed": arguments.seed, "best_epoch": best_epoch + 1, "torch": torch.__version__,
                  "window": "20 samples 10 ms apart", "errors": report}
    model = to_json(network, recipe.frame, "Franka Emika Panda", "flange", provenance)
    write_json(output("model.json"), model)
    with open(output("golden.json"), "w", encoding="utf-8") as file:
        file.write(golden.vectors(model, 1000))
    with open(output("metrics.json"), "w", encoding="utf-8") as file:
        json.dump(report, file, indent=1)
    with open(output("loss.csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, history[0])
        writer.writeheader()
        writer.writerows(history)
    plot(history, output("loss.png"))


if __name__ == "__main__":
    main()
