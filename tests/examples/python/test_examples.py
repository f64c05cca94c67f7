#!/usr/bin/env python3
"""The examples of examples/python do what they say, and every block of Python in docs/python.md is theirs or runs.

test_examples.py ROOT. Without matplotlib, what draws is left out.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import support
from support import np

import rme
import synthetic_arm

root = Path(sys.argv[1])
examples, logs = root / "examples" / "python", root / "tests" / "data" / "mujoco"


def output_of(script, *arguments):
    ended = subprocess.run([sys.executable, examples / script, *arguments], capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr
    return ended.stdout


def body(script):
    """The lines between the imports and the next empty line."""
    text = (examples / script).read_text(encoding="utf-8")
    return text.split("import synthetic_arm\n\n")[1].split("\n\n")[0].splitlines()


# Ten lines each.
assert len(body("close_loop.py")) == 10 and len(body("replay.py")) == 10

# The loop: nothing at first, 60 mm of sag without compensation, 2 mm and less half a second after the attachment.
lines = output_of("close_loop.py").splitlines()
assert len(lines) == 7
sag = [float(re.match(r"[0-9.]+ s, (-?[0-9.]+) mm: PayloadGaussian\(", line)[1]) for line in lines]
mass = [float(re.search(r"\(([0-9.]+) \+- [0-9.]+ kg", line)[1]) for line in lines]
assert max(map(abs, sag[:3])) < 0.5 and max(mass[:3]) < 0.01, lines
assert max(sag[3:]) < 3 and abs(sag[-1]) < 1 and all(abs(m - 1.1) < 0.02 for m in mass[3:]), lines

# Slower: a row for each rate, at each of which the arm is back in its place.
rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in output_of("rates.py", "2").splitlines()[2:]]
assert [row[0] for row in rows] == ["1000", "250", "100", "50", "20", "10", "without compensation"]
assert all(float(row[1]) < 500 and float(row[2]) < 30 and float(row[3]) < 15 and float(row[4]) < 2 for row in rows[:-1]), rows
assert float(rows[-1][4]) > 40

# Times are those of another machine; that there are some is all that a test can say.
table = output_of("time_calls.py", logs / "panda_attach.csv", "1").splitlines()
assert len(table) == 5 and all(float(row[42:].split()[0]) > 0 for row in table[1:])

# The picture: a blue line, which rises when the arm is handed 0.7 kg.
try:
    import matplotlib.image
except ImportError:
    print("replay.py left out: no matplotlib")
else:
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "replay.png"
        output_of("replay.py", logs / "link_side.csv.gz", picture)
        pixels = matplotlib.image.imread(picture)[:, :, :3]
    assert pixels.shape[1] > 800
    red, green, blue = (pixels[:, :, i] for i in range(3))
    drawn = (blue > 0.6) & (red < 0.3)
    rows, across = np.nonzero(drawn)
    assert drawn.sum() > 1000
    assert np.median(rows[across < 0.4 * pixels.shape[1]]) > np.median(rows[across > 0.6 * pixels.shape[1]]) + 50, "it rises"

# The guide: each block is marked as a copy or as code that runs, and is that.
guide = (root / "docs" / "python.md").read_text(encoding="utf-8")
blocks = re.findall(r"(?:<!-- snippet: (\S+) -->\n)?```python\n(.*?)```", guide, re.DOTALL)
assert len(blocks) == guide.count("```python") == 5
defined = {}
for name, code in blocks:
    assert name, f"a block that nothing checks:\n{code}"
    if "/" in name:
        assert code in (root / name).read_text(encoding="utf-8"), f"{name} has other lines than docs/python.md"
    else:
        defined[name] = {"np": np, "rme": rme, "synthetic_arm": synthetic_arm, "estimator": rme.Estimator(7, 0.001)}
        exec(compile(code, name, "exec"), defined[name])
assert set(defined) == {"observer", "observation", "catalogue"}

arm = synthetic_arm.Panda(noise=False)
controller = synthetic_arm.PoseImpedance(arm)
estimator = rme.Estimator(7, 0.001)
arm.attach(0.8, com=(0, 0, 0.1))
for _ in range(500):
    arm.step(controller.torque())
    seen = defined["observer"]["external_torque"](arm.q, arm.dq, arm.tau_measured, 0.001)
    estimator.update(seen, arm.jacobian, arm.rotation, arm.dq)
assert np.allclose(seen, arm.tau_ext, atol=0.02), (seen, arm.tau_ext)
seen = defined["observation"]["observation"](estimator.state)
assert seen.shape == (13,) and abs(seen[0] - 0.8) < 0.02 and seen.flags.owndata
known = defined["catalogue"]
assert known["catalogue"].names == ["cup", "drill"] and known["held"].nothing > 0.9 and known["held"].name is None
assert known["catalogue"].identify(estimator.state).holding is rme.Holding.Unknown
print("ok")
