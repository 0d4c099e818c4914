"""GeoTIFFs, uncompressed, with the tags that say where they are."""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np


def written_geotiff(
    path: Path,
    pixels: np.ndarray,
    keys: Sequence[tuple[int, int]],
    numbers: Mapping[int, Sequence[float]],
) -> Path:
    """A gray picture (h, w); `keys` of its grid by their ids, `numbers` of other tags."""
    height, width = pixels.shape
    listed = [1, 1, 0, len(keys)]
    for id, value in keys:
        listed += [id, 0, 1, value]
    start = 8
    body = pixels.astype(np.uint8).tobytes()
    entries = [
        (256, 4, 1, width), (257, 4, 1, height), (258, 3, 1, 8), (259, 3, 1, 1), (262, 3, 1, 1),
        (273, 4, 1, start), (277, 3, 1, 1), (278, 4, 1, height), (279, 4, 1, len(body)),
    ]  # fmt: skip
    for tag, values in numbers.items():
        entries.append((tag, 12, len(values), start + len(body)))
        body += struct.pack(f"<{len(values)}d", *values)
    entries.append((34735, 3, len(listed), start + len(body)))
    body += struct.pack(f"<{len(listed)}H", *listed)
    table = struct.pack("<H", len(entries))
    table += b"".join(struct.pack("<HHII", *entry) for entry in sorted(entries)) + b"\0\0\0\0"
    path.write_bytes(b"II*\0" + struct.pack("<I", start + len(body)) + body + table)
    return path
