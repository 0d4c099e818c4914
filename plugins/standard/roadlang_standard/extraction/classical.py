"""The classical path: ribbons that differ from both their sides, without a net."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cv2
import numpy as np

from .found_network import FoundNetwork
from .hysteresis import hysteresis
from .skeleton import skeleton
from .tones import Image, Layer

if TYPE_CHECKING:
    from .aerial import Cutoffs

_ANGLES = 12
_WIDTHS = (5, 9, 13)
_LENGTH = 21
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
    response, squares = np.zeros_like(turned), turned * turned
    for bar in _WIDTHS:
        inner = cv2.blur(turned, (_LENGTH, bar))
        rough = cv2.blur(squares, (_LENGTH, bar)) - inner * inner
        shift = bar + 1
        above, below = inner - np.roll(inner, shift, 0), inner - np.roll(inner, -shift, 0)
        brighter, darker = np.minimum(above, below), -np.maximum(above, below)
        edge = np.maximum(brighter, darker) - 0.35 * np.sqrt(np.maximum(rough, 0))
        np.maximum(response, edge, out=response)
    back = cv2.warpAffine(response, turn, (width, height), flags=cv2.WARP_INVERSE_MAP)
    return np.asarray(back, np.float32)
