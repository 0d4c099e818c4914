"""Rendered maps drawn for tests: streets with casings, a river, a park, buildings, names."""

from __future__ import annotations

from dataclasses import dataclass, replace
from types import SimpleNamespace

import cv2
import numpy as np

from roadlang_standard.extraction.maps.map_tones import MapTone
from roadlang_standard.extraction.maps.tone_shape import Steadiness, ToneShape
from tests.extraction.graph_drawings import dense

Color = tuple[int, int, int]
_FINER = 4

STREETS = (
    ((-10.0, 90.0), (130.0, 100.0), (330.0, 80.0), (490.0, 95.0)),
    ((-10.0, 270.0), (200.0, 250.0), (490.0, 280.0)),
    ((140.0, 100.0), (120.0, 257.0)),
    ((330.0, 80.0), (340.0, 265.0), (320.0, 370.0)),
)
"""Center lines (x, y); the first one is the main road."""


@dataclass(frozen=True)
class MapStyle:
    """Colors (red, green, blue) of a map."""

    land: Color
    street: Color
    casing: Color
    main: Color
    water: Color
    park: Color
    building: Color
    letters: Color
    halo: Color


CARTO = MapStyle(
    (242, 239, 233), (255, 255, 255), (187, 187, 187), (252, 214, 164), (170, 211, 223),
    (200, 250, 204), (217, 208, 201), (0, 0, 0), (255, 255, 255),
)  # fmt: skip
LIGHT = MapStyle(
    (236, 233, 227), (255, 255, 255), (187, 187, 187), (252, 208, 158), (164, 205, 217),
    (194, 244, 198), (211, 202, 195), (0, 0, 0), (255, 255, 255),
)  # fmt: skip
"""Close to the style of openstreetmap-carto, but none that is known by its colors."""
PALE = MapStyle(
    (245, 245, 245), (255, 255, 255), (227, 227, 227), (255, 242, 175), (170, 218, 255),
    (205, 235, 176), (235, 233, 230), (95, 99, 104), (255, 255, 255),
)  # fmt: skip
DARK = MapStyle(
    (14, 14, 14), (44, 44, 44), (11, 11, 11), (67, 67, 67), (44, 53, 60),
    (20, 40, 20), (24, 24, 24), (138, 138, 138), (14, 14, 14),
)  # fmt: skip
INK = MapStyle(
    (255, 255, 255), (0, 0, 0), (255, 255, 255), (0, 0, 0), (0, 0, 0),
    (232, 232, 232), (222, 222, 222), (0, 0, 0), (255, 255, 255),
)  # fmt: skip


def drawn_map(style: MapStyle, names: bool = True, river: int = 20) -> np.ndarray:
    """A map (360, 480, 3) BGR of `STREETS`, 8 pixels wide, the main road 14."""
    canvas = np.full((360 * _FINER, 480 * _FINER, 3), style.land, np.uint8)
    cv2.circle(canvas, _at((60, 190)), 45 * _FINER, style.park, -1)
    _stroke(
        canvas, ((230.0, -10.0), (250.0, 150.0), (210.0, 200.0), (230.0, 370.0)), river, style.water
    )
    for x, y in ((190, 130), (410, 150), (400, 220), (170, 320), (60, 320), (440, 40), (60, 40)):
        cv2.rectangle(canvas, _at((x, y)), _at((x + 22, y + 15)), style.building, -1)
    for width, colors in ((2, (style.casing, style.casing)), (0, (style.main, style.street))):
        for index in (1, 2, 3, 0):
            wide = (14 if index == 0 else 8) + width
            _stroke(canvas, STREETS[index], wide, colors[index > 0])
    image = cv2.resize(canvas, (480, 360), interpolation=cv2.INTER_AREA)
    for text, place in (("Mill Lane", (395, 274)), ("High St", (40, 268)), ("Oak Road", (230, 93))):
        for thick, color in ((3, style.halo), (1, style.letters)) if names else ():
            cv2.putText(
                image, text, place, cv2.FONT_HERSHEY_SIMPLEX, 0.34, color, thick, cv2.LINE_AA
            )
    return np.ascontiguousarray(image[..., ::-1])


def crowded(image: np.ndarray, style: MapStyle) -> np.ndarray:
    """A drawn map with small houses wherever its land is wide enough, as towns have them."""
    free = (image == style.land[::-1]).all(axis=2).astype(np.uint8)
    crowded = image.copy()
    for x, y in ((x, y) for y in range(4, 340, 20) for x in range(4, 460, 20)):
        if free[y - 3 : y + 14, x - 3 : x + 14].all():
            crowded[y : y + 11, x : x + 11] = style.building[::-1]
    return crowded


def as_jpeg(image: np.ndarray, quality: int) -> np.ndarray:
    """What is read of a picture that was saved as JPEG."""
    coded = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, quality])[1]
    return np.asarray(cv2.imdecode(coded, cv2.IMREAD_COLOR), np.uint8)


def on_streets(points: np.ndarray, within: float = 3.0) -> np.ndarray:
    """Which points (n, 2) lie within so many pixels of a street."""
    return _near(points, np.vstack([dense(*street) for street in STREETS]), within)


def found_streets(points: np.ndarray, within: float = 3.0) -> np.ndarray:
    """Which points of the streets, of those well within the picture, have one of `points` near."""
    streets = np.vstack([dense(*street) for street in STREETS])
    inside = ((streets > 6) & (streets < np.array([474, 354]))).all(axis=1)
    return _near(streets[inside], points, within)


def _near(points: np.ndarray, others: np.ndarray, within: float) -> np.ndarray:
    away = np.hypot(*(points[:, None] - others[None]).transpose(2, 0, 1)).min(axis=1)
    return np.asarray(away <= within)


def _stroke(
    canvas: np.ndarray, line: tuple[tuple[float, float], ...], width: int, color: Color
) -> None:
    points = np.array([_at(point) for point in line], np.int32)
    cv2.polylines(canvas, [points], False, color, width * _FINER)


def _at(point: tuple[float, float]) -> tuple[int, int]:
    return round((point[0] + 0.5) * _FINER), round((point[1] + 0.5) * _FINER)


def known_tone(color: np.ndarray, mask: np.ndarray, *shape: float) -> MapTone:
    """A tone whose shape is given, not measured: the values of a `ToneShape` and, after the first
    six, of a `Steadiness`."""
    known = SimpleNamespace(shape=ToneShape(*shape[:6]), steadiness=Steadiness(*shape[6:]))
    return MapTone(color, mask, known)


def shaped(tone: MapTone, steady: float, **values: float) -> MapTone:
    """A tone of which another share is steady, with other values of its shape."""
    seen = tone.surface
    known = SimpleNamespace(
        shape=replace(seen.shape, **values), steadiness=replace(seen.steadiness, share=steady)
    )
    return replace(tone, surface=known)
