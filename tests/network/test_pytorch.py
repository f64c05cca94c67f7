#!/usr/bin/env python3
"""A network made and exported by PyTorch says the same in C++: test_pytorch.py RUN_NETWORK TRAINING_FOLDER

Ends with 77 (skipped) where there is no PyTorch.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import torch
except ImportError as missing:
    print(f"skipped: needs python3-{missing.name.split('.')[0].lower()}")  # Debian's name of the package
    sys.exit(77)
sys.path.insert(0, sys.argv[2])
from network import MismatchNetwork, from_json, to_json, write_json  # noqa: E402

torch.set_num_threads(1)
for seed, frame in ((1, "world"), (2, "end_effector")):
    torch.manual_seed(seed)
    network = MismatchNetwork(5 * torch.randn(6), 1 + torch.rand(6)).eval()
    with torch.no_grad():
        for tensor in network.parameters():
            tensor += 0.1 * torch.randn(tensor.shape)  # PyTorch starts with some biases at zero
    with tempfile.TemporaryDirectory() as folder:
        weights, inputs = Path(folder) / "weights.json", Path(folder) / "inputs.json"
        value = to_json(network, frame, "an arm", "its flange", {"seed": seed})
        write_json(weights, value)
        windows = (network.mean + 2 * network.std * torch.randn(1000, 20, 6)).double()
        inputs.write_text(json.dumps(windows.tolist()), encoding="utf-8")
        printed = subprocess.run([sys.argv[1], weights, inputs], capture_output=True, text=True, check=True).stdout
    with torch.no_grad():
        exact = from_json(value)(windows)
        single = network(windows.float()).double()
    outputs = torch.tensor(json.loads(printed), dtype=torch.float64)
    difference = ((outputs - exact).abs() / (exact.abs() + 1e-2)).max().item()
    print(f"seed {seed}, {frame}: largest relative difference from PyTorch in double {difference:.1e}, "
          f"from PyTorch in float {(outputs - single).abs().max().item():.1e} of outputs up to {exact.abs().max():.2f}")
    assert difference <= 1e-8, "beyond what nine printed digits explain"
    assert (outputs - single).abs().max() <= 1e-5
