#!/usr/bin/env python3
"""The picture of an arm: a PNG that others can read, with the payload and the outline where they belong.

test_render_arm.py RENDER_ARM. Ends with 77 (skipped) without OpenGL or matplotlib.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import matplotlib.image
    import numpy as np
except ImportError as missing:
    print(f"skipped: needs python3-{missing.name.split('.')[0].lower()}")  # Debian's name of the package
    sys.exit(77)

HEAD = "m,t,q1,q2,q3,q4,q5,q6,q7\n"
OUTLINE = np.array([0, 114, 178]) / 255
READY, SUNK = "0,-0.785,0,-2.356,0,1.571,0.785", "0,-0.35,0,-2.6,0,2.2,0.785"


def centre(pixels):
    """Row and column of the middle of these pixels, and how many there are."""
    rows, columns = np.nonzero(pixels)
    return rows.mean(), columns.mean(), len(rows)


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    # The light payload comes first and the outline is the heavy one's: only that one's rows may count.
    for run, end in (("without", SUNK), ("with", READY)):
        (folder / f"equilibrium_{run}.csv").write_text(
            HEAD + f"0.3,0,{SUNK}\n0.3,1,{SUNK}\n1.1,0,{READY}\n1.1,1,{end}\n", encoding="utf-8")

    def run_with(*options):
        return subprocess.run([sys.argv[1], folder, *options], capture_output=True, text=True, check=False)

    def draw(*options):
        """Of both halves of the picture: where the payload is, and where the outline."""
        ended = run_with(*options)
        if "EGL: " in ended.stderr:
            print("skipped: needs libegl-mesa0 libgl1-mesa-dri")
            sys.exit(77)
        assert ended.returncode == 0, ended.stderr
        picture = matplotlib.image.imread(folder / "equilibrium.png")[:, :, :3]
        red, green, blue = (picture[:, :, i] for i in range(3))
        payload, outline = (red > 3 * blue) & (red > 1.5 * green), np.all(np.abs(picture - OUTLINE) < 1e-3, axis=2)
        middle = picture.shape[1] // 2
        return [(payload[:, half], outline[:, half]) for half in (slice(middle), slice(middle, None))]

    (without, outline), (held, same) = draw()
    assert min(centre(without)[2], centre(held)[2]) > 500
    assert centre(without)[0] > centre(held)[0] + 50, "the payload that nobody compensates for hangs lower"
    assert np.array_equal(outline, same) and outline.sum() > 1000, "both began in one pose"
    assert np.array_equal(draw("--mass", "1.1")[0][1], outline), "the heaviest payload is the default"
    assert not np.array_equal(draw("--mass", "0.3")[0][1], outline), "the light one began elsewhere"
    assert centre(draw("--com", "0,0,0.3")[1][0])[0] > centre(held)[0] + 50, "the box is drawn where it is said to be"

    missing = run_with("--mass", "9")
    assert missing.returncode == 3 and "nothing of this mass" in missing.stderr

    # A film: the payload gets heavier, and falls in the end.
    film = "t,m,q1,q2,q3,q4,q5,q6,q7\n" + "".join(
        f"{0.1 * i},{m},{READY}\n" for i, m in enumerate((0, 0.5, 1.5, 0, 0)))
    for run in ("nominal", "without", "with"):
        (folder / f"{run}.csv").write_text(film, encoding="utf-8")
    ended = run_with("--film", "10")
    assert ended.returncode == 0, ended.stderr
    boxes = []
    for i in range(5):
        picture = matplotlib.image.imread(folder / "frames" / f"{i:04}.png")[:, :, :3]
        red, green, blue = (picture[:, :, j] for j in range(3))
        boxes.append((red > 3 * blue) & (red > 1.5 * green))
    assert len(list((folder / "frames").iterdir())) == 5
    assert not boxes[0].any(), "an empty hand holds nothing"
    assert centre(boxes[2])[2] > 1.5 * centre(boxes[1])[2] > 500, "what is heavier is drawn larger"
    assert centre(boxes[4])[0] > centre(boxes[3])[0] + 5 > centre(boxes[2])[0] + 10, "what was dropped falls"
    assert run_with("--film", "0").returncode == 2
