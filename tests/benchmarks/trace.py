#!/usr/bin/env python3
"""trace.py MODEL.json MODEL.pt: a weights file as TorchScript, frozen and optimised for inference."""
import json
import sys
from pathlib import Path

import torch

sys.path.insert(0, str(Path(__file__).parents[2] / "examples" / "training"))
from network import from_json  # noqa: E402

with open(sys.argv[1], encoding="utf-8") as file:
    network = from_json(json.load(file)).float()
with torch.no_grad():
    traced = torch.jit.optimize_for_inference(torch.jit.freeze(torch.jit.trace(network, torch.zeros(1, 20, 6))))
traced.save(sys.argv[2])
