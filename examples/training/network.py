"""The mismatch network in PyTorch, and its JSON form (docs/weights.md)."""
import json
import math

import torch
from torch import nn

SAMPLES, CHANNELS, CONV_CHANNELS, CONV_KERNEL = 20, 6, 64, 5
HEADS, MLP_HIDDEN, MLP_REPEATS = 8, 256, 3
OUTPUTS = ["mass", "com_x", "com_y", "com_z"]


class MismatchNetwork(nn.Module):
    """From raw pseudo-wrenches [batch][20][6] to (mass [kg], com_x, com_y, com_z [m]); Table 4 of the paper."""

    def __init__(self, mean=None, std=None, dropout=0.1):
        super().__init__()
        # Not persistent, so that state_dict() omits them: they are exported as "normalization", not as weights.
        self.register_buffer("mean", torch.zeros(CHANNELS) if mean is None else mean, persistent=False)
        self.register_buffer("std", torch.ones(CHANNELS) if std is None else std, persistent=False)
        self.convolution = nn.Conv1d(CHANNELS, CONV_CHANNELS, CONV_KERNEL, padding=CONV_KERNEL // 2)
        self.positional_embedding = nn.Parameter(0.02 * torch.randn(SAMPLES, CONV_CHANNELS))
        self.attention = nn.MultiheadAttention(CONV_CHANNELS, HEADS, batch_first=True)
        self.mlp = nn.Sequential(nn.Linear(CONV_CHANNELS, MLP_HIDDEN), nn.ReLU(),
                                 nn.Linear(MLP_HIDDEN, CONV_CHANNELS), nn.Dropout(dropout))
        self.head = nn.Linear(CONV_CHANNELS, len(OUTPUTS))

    def forward(self, window):
        x = (window - self.mean) / self.std
        x = self.convolution(x.transpose(1, 2)).transpose(1, 2)
        x = x + self.positional_embedding
        x, _ = self.attention(x, x, x, need_weights=False)
        x = x.mean(dim=1)
        for _ in range(MLP_REPEATS):
            x = self.mlp(x)
        return self.head(x)


def rounded(tensor):
    """Nested lists of floats with 9 significant digits, which suffice for every 32-bit float."""
    if tensor.dim() == 0:
        value = float(tensor)
        if not math.isfinite(value):
            raise ValueError("a weight is not finite")
        return float(f"{value:.9g}")
    return [rounded(row) for row in tensor]


def to_json(network, frame, robot, end_effector, training):
    """The JSON value of a network; frame is "world" or "end_effector", training says freely how it was trained."""
    network = network.cpu()
    return {
        "format": "rme.mismatch_network",
        "version": 1,
        "input": {"samples": SAMPLES, "channels": CHANNELS, "frame": frame},
        "architecture": {"conv_channels": CONV_CHANNELS, "conv_kernel": CONV_KERNEL, "heads": HEADS,
                         "mlp_hidden": MLP_HIDDEN, "mlp_repeats": MLP_REPEATS, "outputs": len(OUTPUTS)},
        "normalization": {"mean": rounded(network.mean), "std": rounded(network.std)},
        "outputs": OUTPUTS,
        "robot": robot,
        "end_effector": end_effector,
        "training": training,
        "weights": {name: rounded(tensor) for name, tensor in network.state_dict().items()},
    }


def from_json(value):
    """The network that a JSON value describes, in double precision and in evaluation mode."""
    network = MismatchNetwork().double()
    network.mean = torch.tensor(value["normalization"]["mean"], dtype=torch.float64)
    network.std = torch.tensor(value["normalization"]["std"], dtype=torch.float64)
    weights = {name: torch.tensor(numbers, dtype=torch.float64) for name, numbers in value["weights"].items()}
    network.load_state_dict(weights)
    return network.eval()


def write_json(path, value):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(value, file, allow_nan=False, separators=(",", ":"))
        file.write("\n")
