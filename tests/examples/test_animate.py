#!/usr/bin/env python3
"""The moving picture shows what its single pictures show, although it stores only what changes.

test_animate.py ANIMATE. Ends with 77 (skipped) without matplotlib or Pillow.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import matplotlib.image
    import numpy as np
    from PIL import Image
except ImportError as missing:
    print(f"skipped: needs python3-{missing.name.split('.')[0].lower()}")  # Debian's name of the package
    sys.exit(77)

COLOURS = np.array([[214, 94, 0], [0, 114, 178], [92, 102, 115], [214, 94, 0]])

with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    (folder / "frames").mkdir()
    for i, colour in enumerate(COLOURS):
        picture = np.full((560, 1280, 3), colour / 255)
        picture[200:300] = 0  # stays as it is
        matplotlib.image.imsave(folder / "frames" / f"{i:04}.png", picture)
    rows = "t,m,mass,distance\n" + "".join(f"{0.1 * i},1,0.9,0.05\n" for i in range(4))
    for run in ("with", "without"):
        (folder / f"{run}.csv").write_text(rows, encoding="utf-8")

    subprocess.run([sys.executable, sys.argv[1], folder, "10"], check=True)
    film = Image.open(folder / "animation.gif")
    assert film.n_frames == len(COLOURS), film.n_frames
    for i, colour in enumerate(COLOURS):
        film.seek(i)
        page = np.asarray(film.convert("RGB")).astype(int)
        seen = [np.all(abs(page - wanted) < 12, axis=2).sum() for wanted in (colour, (0, 0, 0))]
        assert seen[0] > 0.2 * page[:, :, 0].size, f"picture {i} has another colour"
        assert seen[1] > 0.05 * page[:, :, 0].size, f"picture {i} has lost what does not move"

    for file in (folder / "frames").iterdir():
        file.unlink()
    ended = subprocess.run([sys.executable, sys.argv[1], folder, "10"], capture_output=True, text=True, check=False)
    assert ended.returncode == 1 and "no pictures" in ended.stderr, ended.stderr
