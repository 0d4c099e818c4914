"""What a net says about a picture: where the road surface is, by tiles without seams."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.api import Code

from ..colors.tones import Image
from .exposure import EvenView

Layer = NDArray[np.float32]
Predictor = Callable[[Image], NDArray[np.float32]]
"""From an evenly exposed tile (h, w, 3), sides multiples of 32, to maps (2, h/2, w/2): road
surface, and its center line, which is not used."""
_TILE, _MARGIN = 768, 96


@dataclass(frozen=True)
class Net:
    """A net that OpenCV reads, one that helps it where roads are wide, and the digest of both."""

    predict: Predictor
    digest: str
    second: Predictor | None = None


@lru_cache(maxsize=4)
def road_net(path: str = "") -> Net:
    """The net in an ONNX file; without a path those that are shipped. A net of one map serves as
    both.

    Raises OSError for a file that cannot be read and cv2.error for one that is no net.
    """
    if path:
        data = Path(path).read_bytes()
        return Net(_predictor(data), hashlib.sha256(data).hexdigest())
    first, second = (_shipped(name) for name in ("roads.onnx", "wide_roads.onnx"))
    digest = hashlib.sha256(first + second).hexdigest()
    return Net(_predictor(first), digest, _predictor(second))


def _predictor(data: bytes) -> Predictor:
    net = cv2.dnn.readNetFromONNX(np.frombuffer(data, np.uint8))

    def predict(tile: Image) -> NDArray[np.float32]:
        net.setInput(cv2.dnn.blobFromImage(tile, swapRB=True))
        maps = np.asarray(net.forward(), np.float32)[0]
        return maps if len(maps) >= 2 else np.repeat(maps, 2, axis=0)

    return predict


def checked_net(path: str) -> Net:
    """A user's net, tried on a tile. Raises DiagnosticError RL424 for what is no road net."""
    from roadlang.api import DiagnosticError, diagnose

    try:
        net = road_net(path)
        maps = net.predict(np.full((64, 64, 3), 115, np.uint8))
        if maps.shape != (2, 32, 32) or not np.isfinite(maps).all():
            raise ValueError(f"gives maps of shape {maps.shape} for a tile of 64 x 64")
        if maps.min() < 0 or maps.max() > 1:
            raise ValueError("gives values outside 0 to 1: end it with a sigmoid")
    except (OSError, ValueError, IndexError, cv2.error) as error:
        reason = getattr(error, "err", None) or str(error).splitlines()[0]
        raise DiagnosticError(diagnose(Code.UNUSABLE_MODEL, path=path, reason=reason)) from None
    return net


def _shipped(name: str) -> bytes:
    return files(__package__).joinpath("weights", name).read_bytes()


def evidence(view: EvenView, predict: Predictor, mirrored: bool = True) -> Layer:
    """Probability of road surface (h, w) in 0..1 in a view at its own size; mirrored, it is looked
    at twice, and both averaged."""
    seen: Layer = _tiled(view.even, predict)
    if mirrored:
        seen += _tiled(cv2.flip(view.even, 1), predict)[:, ::-1]
        seen /= 2
    height, width = view.even.shape[:2]
    size = (2 * seen.shape[1], 2 * seen.shape[0])
    surface: Layer = cv2.resize(seen, size, interpolation=cv2.INTER_LINEAR)[:height, :width]
    if view.nothing is not None:
        surface[view.nothing] = 0
    return np.ascontiguousarray(surface)


def _tiled(image: Image, predict: Predictor) -> Layer:
    """The surface (ceil(h/2), ceil(w/2)); tiles overlap and fade into each other."""
    height, width = image.shape[:2]
    rows, columns = -(-height // 2), -(-width // 2)
    total = np.zeros((rows, columns), np.float32)
    weight = np.zeros((rows, columns), np.float32)
    for top, bottom in _spans(height):
        for left, right in _spans(width):
            seen = _predicted(image[top:bottom, left:right], predict)
            fade = np.outer(_fade(top, bottom, height), _fade(left, right, width)).astype(
                np.float32
            )
            tile = (
                slice(top // 2, top // 2 + seen.shape[0]),
                slice(left // 2, left // 2 + seen.shape[1]),
            )
            total[tile] += seen * fade
            weight[tile] += fade
    return np.asarray(total / weight)


def _predicted(tile: Image, predict: Predictor) -> Layer:
    height, width = tile.shape[:2]
    down, right = -height % 32, -width % 32
    border = cv2.BORDER_REFLECT_101 if min(height, width) > 32 else cv2.BORDER_REPLICATE
    padded = cv2.copyMakeBorder(tile, 0, down, 0, right, border)
    return predict(padded)[0, : -(-height // 2), : -(-width // 2)]


def _spans(size: int) -> Iterator[tuple[int, int]]:
    """Even starts of tiles that overlap by two margins and cover 0..size."""
    start = 0
    while True:
        end = start + _TILE
        if end + _TILE // 4 >= size:
            yield start, size
            return
        yield start, end
        start = end - 2 * _MARGIN


def _fade(start: int, end: int, size: int) -> NDArray[np.float64]:
    """Weight along one side of a tile: zero near its edges, but not at those of the picture."""
    count = -(-(end - start) // 2)
    at = 2 * np.arange(count) + 1.0
    weight = np.ones(count)
    if start > 0:
        weight = np.minimum(weight, at / _MARGIN - 0.25)
    if end < size:
        weight = np.minimum(weight, (end - start - at) / _MARGIN - 0.25)
    return np.clip(weight, 1e-4, 1)
