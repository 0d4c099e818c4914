"""The classical path: ribbons that differ from both their sides, without a net."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from ..colors.tones import Image, Layer
from ..masks.hysteresis import hysteresis
from ..masks.skeleton import skeleton
from ..networks.found_network import FoundNetwork

if TYPE_CHECKING:
    from .aerial import Cutoffs

_ANGLES = 12
_WIDTHS = (5, 9, 13)
_LENGTH = 21
_BEYOND = 9
"""What is at most half as many pixels beyond a turned picture may be sampled to turn it back."""
_ROWS = 32
"""Number of rows that are evaluated together: more do not stay in a processor's cache."""
_SMALLER = 1 / 3
"""Scale at which a photo without fine detail is processed."""
_STRIP, _REACH = 4, 40
"""Long strips are rotated in pieces whose length is `_STRIP` times the shorter side: a long strip
rotated as a whole fills little of its canvas. Pieces overlap by `_REACH` pixels, more than the
filters reach."""
_CHROMA = 0.03
"""Reduction of the response at a pixel of full color: asphalt is gray."""


def roads_by_ribbons(image: Image, longest: float = float("inf")) -> FoundNetwork:
    """The road network of a photo (h, w, 3), found without the net.

    None of it where ribbons are longer in all than `longest` sides of the picture, or in a copy of
    half its size than so many sides of the copy.
    """
    from .aerial import Cutoffs, Request, roads_of_evidence
    from .photo_evidence import Seen
    from .scale import has_detail, resized

    scale = 1.0 if has_detail(image) else max(_SMALLER, min(1.0, 64 / min(image.shape[:2])))
    whole = resized(image, scale)
    cutoffs = Cutoffs(strong=0.62, weak=0.42, floor=0.35, link_cost=1.2)
    # A copy of half the size is a quarter of the work, and shows most busy pictures to be so.
    for look in (resized(whole, 0.5), whole) if np.isfinite(longest) else (whole,):
        evidence = ribbon_evidence(look)
        if _length(evidence, cutoffs) > longest * max(evidence.shape):
            return FoundNetwork(np.zeros((0, 2)), (), np.zeros(image.shape[:2], bool), "aerial")
    found = roads_of_evidence(Seen(evidence, evidence), Request(), cutoffs)
    return found if scale == 1 else found.scaled(1 / scale, image.shape[:2])


def _length(evidence: Layer, cutoffs: Cutoffs) -> int:
    """Of all ribbons, pixels."""
    return int(skeleton(hysteresis(evidence, cutoffs.strong, cutoffs.weak)).sum())


def ribbon_evidence(image: Image) -> Layer:
    """How much each pixel (h, w) looks like a road surface, 0..1.

    A road differs from the ground on both sides, brighter or darker, and is even along itself. The
    filters are boxes on turned copies of the picture (Steger 1998 uses derivatives instead).
    """
    lab = cv2.cvtColor(image, cv2.COLOR_BGR2LAB).astype(np.float32)
    chroma = np.hypot(lab[..., 1] - 128, lab[..., 2] - 128)
    light = lab[..., 0]
    mean = cv2.GaussianBlur(light, (0, 0), 25)
    spread = np.sqrt(cv2.GaussianBlur((light - mean) ** 2, (0, 0), 25))
    even = (light - mean) / np.maximum(spread, 4.0)
    is_tall = light.shape[0] > 2 * _piece(light.shape[1])
    best = _best(even.T).T if is_tall else _best(even)
    best *= np.exp(-_CHROMA * np.maximum(chroma - np.median(chroma), 0))
    top = float(np.quantile(best, 0.985))
    return np.asarray(np.clip(best / max(top, 1e-3), 0, 1), np.float32)


def _piece(short: int) -> int:
    """The length of the pieces of a picture whose shorter side has so many pixels."""
    return max(_STRIP * short, 10 * _REACH)


def _best(even: Layer) -> Layer:
    """The greatest response of ribbons at each pixel (h, w); a wide strip is seen in pieces."""
    height, width = even.shape
    piece = _piece(height) if width > 2 * _piece(height) else width
    best = np.zeros(even.shape, np.float32)
    for left in range(0, width, piece):
        start = max(0, left - _REACH)
        part = np.ascontiguousarray(even[:, start : left + piece + _REACH])
        for angle in np.arange(_ANGLES) * 180.0 / _ANGLES:
            response = _along(part, float(angle))[:, left - start : left - start + piece]
            np.maximum(best[:, left : left + piece], response, out=best[:, left : left + piece])
    return best


def _along(even: Layer, angle: float) -> Layer:
    """The response of ribbons that run at `angle` degrees."""
    height, width = even.shape
    diagonal = int(np.ceil(np.hypot(height, width)))
    turn = cv2.getRotationMatrix2D((width / 2, height / 2), angle, 1.0)
    turn[:, 2] += (diagonal - width) / 2, (diagonal - height) / 2
    turned = cv2.warpAffine(even, turn, (diagonal, diagonal), borderMode=cv2.BORDER_REFLECT)
    response = _response(turned, _shown(turn, even.shape, diagonal))
    back = cv2.warpAffine(response, turn, (width, height), flags=cv2.WARP_INVERSE_MAP)
    return np.asarray(back, np.float32)


def _shown(turn: NDArray[np.float64], shape: tuple[int, ...], side: int) -> NDArray[np.uint8]:
    """Where (side, side) a turned picture of some shape shows that, and a little beyond."""
    right, bottom = shape[1] - 1, shape[0] - 1
    corners = np.array([(0, 0, 1), (right, 0, 1), (right, bottom, 1), (0, bottom, 1)])
    shown = np.zeros((side, side), np.uint8)
    cv2.fillConvexPoly(shown, np.round(corners @ turn.T).astype(np.int32), 1)
    return np.asarray(cv2.dilate(shown, np.ones((_BEYOND, _BEYOND), np.uint8)))


def _response(turned: Layer, shown: NDArray[np.uint8]) -> Layer:
    """The response (side, side) of level ribbons in a turned picture, where that is `shown`."""
    response, squares = np.zeros_like(turned), turned * turned
    height = len(turned)
    for bar in _WIDTHS:
        shift = bar + 1
        around = ((shift, shift), (0, 0))
        wrapped = np.pad(cv2.blur(turned, (_LENGTH, bar)), around, mode="wrap")
        mean_squares = cv2.blur(squares, (_LENGTH, bar))
        for top in range(0, height, _ROWS):
            bottom = min(height, top + _ROWS)
            columns = np.flatnonzero(shown[top:bottom].any(axis=0))
            if not len(columns):
                continue
            part = (slice(top, bottom), slice(int(columns[0]), int(columns[-1]) + 1))
            above, inner, below = (
                wrapped[top + down : bottom + down, part[1]] for down in (0, shift, 2 * shift)
            )
            edge = _edge(inner, above, below, mean_squares[part])
            np.maximum(response[part], edge, out=response[part])
    return response


def _edge(inner: Layer, above: Layer, below: Layer, mean_squares: Layer) -> Layer:
    """By how much a strip is brighter, or darker, than both of its sides, less its roughness."""
    edge, other = np.maximum(above, below), np.minimum(above, below)
    np.subtract(inner, edge, out=edge)  # rounding keeps the order of numbers
    np.subtract(other, inner, out=other)
    np.maximum(edge, other, out=edge)
    np.multiply(inner, inner, out=other)
    np.subtract(mean_squares, other, out=other)
    np.maximum(other, 0, out=other)
    np.sqrt(other, out=other)
    other *= 0.35
    edge -= other
    return edge
