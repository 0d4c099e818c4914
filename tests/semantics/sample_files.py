"""The samples of the language, with the files they name beside them."""

from __future__ import annotations

import shutil
from pathlib import Path

SAMPLES = Path(__file__).parents[1] / "syntax" / "samples"
_FIRST_AND_LAST_BYTES = {
    "hairpin.jpg": b"\xff\xd8\xff\xda\x00\x02\xff\xd9",
    "town.png": b"\x89PNG\r\n\x1a\nIEND\xae\x42\x60\x82",
    "town.tif": b"II*\x00",
    "town.xodr": b"<OpenDRIVE/>",
    "Town01.xodr": b"<OpenDRIVE/>",
    "spa.csv": b"x,y\n0,0\n100,0\n100,100\n",
    "mpc.onnx": b"onnx",
}


def copy_samples(folder: Path) -> list[Path]:
    """Copy all samples to `folder`, with stand-ins for the files that they name."""
    for name, content in _FIRST_AND_LAST_BYTES.items():
        (folder / name).write_bytes(content)
    return [Path(shutil.copy(path, folder)) for path in sorted(SAMPLES.glob("*.rl"))]
