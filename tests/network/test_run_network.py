#!/usr/bin/env python3
"""run_network as a user runs it: test_run_network.py PROGRAM MODEL.json GOLDEN.json

GOLDEN.json holds what PyTorch said to the windows of examples/training/golden.py. Needs the standard library only.
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, MODEL, GOLDEN = sys.argv[1:4]


def windows(mean, std, count):
    """golden.py's random_windows(Uniform(2), ...)."""
    state = 2

    def uniform():
        nonlocal state
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        return 2 * (state >> 11) * 2.0**-53 - 1

    return [[[m + 3 * s * uniform() for m, s in zip(mean, std)] for _ in range(20)] for _ in range(count)]


class RunNetwork(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.model = json.loads(Path(MODEL).read_text(encoding="utf-8"))

    def file(self, name, value):
        path = Path(self.folder.name) / name
        path.write_text(value if isinstance(value, str) else json.dumps(value), encoding="utf-8")
        return path

    def run_network(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)

    def refused(self, code, part, *arguments):
        result = self.run_network(*arguments)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertIn(part, result.stderr)

    def test_prints_what_pytorch_says_with_nine_digits(self):
        expected = json.loads(Path(GOLDEN).read_text(encoding="utf-8"))["outputs"][:50]
        normalization = self.model["normalization"]
        inputs = self.file("inputs.json", windows(normalization["mean"], normalization["std"], 50))
        result = self.run_network(MODEL, inputs)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        outputs = json.loads(result.stdout)
        self.assertEqual(len(outputs), 50)
        for got, wanted in zip(outputs, expected):
            self.assertEqual(len(got), 4)
            for g, w in zip(got, wanted):
                self.assertLessEqual(abs(g - w), 1e-8 * abs(w) + 1e-10)

    def test_no_windows_give_no_outputs(self):
        result = self.run_network(MODEL, self.file("inputs.json", []))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(json.loads(result.stdout), [])

    def test_arguments_it_cannot_use_end_with_2(self):
        self.refused(2, "usage")
        self.refused(2, "usage", MODEL)
        self.refused(2, "usage", MODEL, "a", "b")

    def test_files_it_cannot_read_or_use_end_with_3(self):
        good = self.file("good.json", [[[0] * 6] * 20])
        self.refused(3, "absent.json: cannot be opened", "absent.json", good)
        self.refused(3, "absent.json: cannot be opened", MODEL, "absent.json")
        self.refused(3, self.folder.name, MODEL, self.folder.name)
        self.refused(3, "cut.json: ", self.file("cut.json", Path(MODEL).read_text(encoding="utf-8")[:-100]), good)
        self.model["architecture"]["heads"] = 4
        self.refused(3, "architecture.heads: expected 8, got 4", self.file("heads.json", self.model), good)

    def test_inputs_of_another_shape_end_with_3_and_are_named(self):
        def refused(part, inputs):
            self.refused(3, part, MODEL, self.file("inputs.json", inputs))

        refused("expected an array of windows, got an object", {})
        refused("[0]: expected an array of 20, got an array of 6", [[0] * 6])
        refused("[1]: expected an array of 20, got an array of 19", [[[0] * 6] * 20, [[0] * 6] * 19])
        refused("[0][19]: expected an array of 6, got an array of 7", [[[0] * 6] * 19 + [[0] * 7]])
        refused("[0][0][5]: expected a number, got null", [[[0] * 5 + [None]] * 20])
        refused("invalid literal", "[[[NaN]]]")
        refused("1e999", "[[[1e999]]]")
        refused("not finite", [[[1e308] * 6] * 20])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
