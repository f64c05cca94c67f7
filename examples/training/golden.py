#!/usr/bin/env python3
"""Golden vectors: PyTorch's outputs, in double precision, for reproducible windows.

    golden.py                     for a network with reproducible random weights
    golden.py --model MODEL.json  for the network of a weights file

Prints {"windows": 1000, "outputs": [1000][4]}. Windows and random weights come from the generator below, so
the file contains outputs only; tests/network/golden.hpp has the same generator in C++.
"""
import argparse
import json

import torch

from network import CHANNELS, SAMPLES, MismatchNetwork, from_json

# Half the width of each random tensor's uniform distribution. With these, the attention is far from uniform and every
# bias is non-zero. With PyTorch's own initial values, an error in either would not show.
WIDTHS = [
    ("convolution.weight", 0.3), ("convolution.bias", 0.3), ("positional_embedding", 1.0),
    ("attention.in_proj_weight", 0.3), ("attention.in_proj_bias", 0.3),
    ("attention.out_proj.weight", 0.2), ("attention.out_proj.bias", 0.2),
    ("mlp.0.weight", 0.2), ("mlp.0.bias", 0.2), ("mlp.2.weight", 0.1), ("mlp.2.bias", 0.1),
    ("head.weight", 0.2), ("head.bias", 0.2),
]


class Uniform:
    """Knuth's 64-bit linear congruential generator; the top 53 bits as a double in [-1, 1)."""

    def __init__(self, seed):
        self.state = seed

    def __call__(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return 2 * (self.state >> 11) * 2.0**-53 - 1

    def tensor(self, *shape):
        count = int(torch.tensor(shape).prod())
        return torch.tensor([self() for _ in range(count)], dtype=torch.float64).reshape(shape)


def random_network(uniform):
    network = MismatchNetwork().double().eval()
    network.mean = 5 * uniform.tensor(CHANNELS)
    network.std = 3 + 2 * uniform.tensor(CHANNELS)
    state = network.state_dict()
    network.load_state_dict({name: width * uniform.tensor(*state[name].shape) for name, width in WIDTHS})
    return network


def random_windows(uniform, network, count):
    """Up to three standard deviations from the mean, sample by sample."""
    return network.mean + 3 * network.std * uniform.tensor(count, SAMPLES, CHANNELS)


def vectors(model, count):
    """The outputs for `count` windows as JSON; model is a weights file's JSON value, or None for random weights."""
    network = random_network(Uniform(1)) if model is None else from_json(model)
    with torch.no_grad():
        outputs = network(random_windows(Uniform(2), network, count))
    rows = ",\n".join(json.dumps(row) for row in outputs.tolist())
    return f'{{"windows": {count}, "outputs": [\n{rows}\n]}}\n'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--model", help="weights file; default: random weights")
    parser.add_argument("--windows", type=int, default=1000)
    arguments = parser.parse_args()
    model = None
    if arguments.model:
        with open(arguments.model, encoding="utf-8") as file:
            model = json.load(file)
    print(vectors(model, arguments.windows), end="")


if __name__ == "__main__":
    main()
