"""Photos read before: results kept by the digest of picture, request, net and code."""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import tempfile
import zipfile
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from ..colors.tones import Image
from ..networks.found_network import FoundNetwork, FoundRoad
from .aerial import Request, roads_of_photo
from .classical import roads_by_ribbons
from .crosscheck import checked_roads
from .road_net import Net, road_net


def remembered(image: Image, request: Request, net: Net | None = None) -> FoundNetwork:
    """The roads of a photo, read again only if anything that decides them has changed.

    `ROADLANG_CACHE` names the folder, or is `off`; by default it is in the user's cache folder.
    A cache that cannot be read or written is done without.
    """
    checked = net is None
    if net is None:
        try:
            net = road_net()
        except (OSError, cv2.error) as error:
            reason = f"the neural network cannot be read ({error}): ribbon filters were used"
            return replace(roads_by_ribbons(image), remarks=(reason,))
    read = checked_roads if checked else roads_of_photo
    folder = _folder()
    if folder is None:
        return read(image, request, net)
    place = folder / f"{_digest(image, request, net, checked)}.roads"
    found = _read(place)
    if found is None:
        found = read(image, request, net)
        _write(place, found)
    return found


def _folder() -> Path | None:
    configured = os.environ.get("ROADLANG_CACHE", "")
    if configured == "off":
        return None
    if configured:
        return Path(configured)
    home = os.environ.get("XDG_CACHE_HOME") or (Path.home() / ".cache")
    return Path(home) / "roadlang" / "photos"


def _digest(image: Image, request: Request, net: Net, checked: bool) -> str:
    makers = f"{net.digest} {checked} {_code()} {cv2.__version__}"
    digest = hashlib.sha256(f"{image.shape} {request} {makers}".encode())
    digest.update(np.ascontiguousarray(image).data)
    return digest.hexdigest()


@cache
def _code() -> str:
    """Digest of the source of all extractors: another back end gives other roads."""
    sources = sorted(Path(__file__).parent.parent.rglob("*.py"))
    return hashlib.sha256(b"".join(path.read_bytes() for path in sources)).hexdigest()


def _read(place: Path) -> FoundNetwork | None:
    unusable = contextlib.suppress(OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile)
    with unusable, np.load(place, allow_pickle=False) as stored:
        return _unpacked(dict(stored))
    return None


def _write(place: Path, found: FoundNetwork) -> None:
    buffer = io.BytesIO()
    arrays: dict[str, Any] = _packed(found)
    np.savez_compressed(buffer, **arrays)
    with contextlib.suppress(OSError):
        place.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=place.parent)
        with os.fdopen(handle, "wb") as file:
            file.write(buffer.getvalue())
        os.replace(name, place)


def _packed(found: FoundNetwork) -> dict[str, np.ndarray]:
    roads = found.roads
    return {
        "nodes": found.nodes,
        "ends": np.array([(road.start, road.end) for road in roads], int).reshape(-1, 2),
        "counts": np.array([len(road.points) for road in roads], int),
        "points": np.vstack([np.zeros((0, 2)), *[road.points for road in roads]]),
        "widths": np.concatenate([np.zeros(0), *[road.widths for road in roads]]),
        "confidences": np.concatenate([np.zeros(0), *[_confidences(road) for road in roads]]),
        "doubts": np.array(
            [(road.width_error, road.confidence, road.linked) for road in roads]
        ).reshape(-1, 3),
        "mask": np.packbits(found.mask),
        "shape": np.array(found.mask.shape),
        "words": np.array([found.method, *found.remarks]),
        "score_names": np.array(list(found.scores), dtype=str),
        "scores": np.array(list(found.scores.values()), float),
    }


def _confidences(road: FoundRoad) -> np.ndarray:
    same = np.full(len(road.points), road.confidence)
    return same if road.confidences is None else road.confidences


def _unpacked(stored: dict[str, np.ndarray]) -> FoundNetwork:
    cuts = np.cumsum(stored["counts"])[:-1]
    shape = tuple(int(side) for side in stored["shape"])
    mask = np.unpackbits(stored["mask"], count=shape[0] * shape[1]).reshape(shape).astype(bool)
    parts = zip(
        stored["ends"],
        np.split(stored["points"], cuts),
        np.split(stored["widths"], cuts),
        stored["doubts"].tolist(),
        np.split(stored["confidences"], cuts),
        strict=False,
    )
    roads = tuple(
        FoundRoad(int(start), int(end), points, widths, error, confidence, linked, sure)
        for (start, end), points, widths, (error, confidence, linked), sure in parts
    )
    method, *remarks = map(str, stored["words"])
    scores = dict(zip(map(str, stored["score_names"]), map(float, stored["scores"]), strict=True))
    return FoundNetwork(stored["nodes"], roads, mask, method, tuple(remarks), scores)
