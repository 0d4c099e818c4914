"""Strokes at random places and angles, and the pictures that pens of many kinds make of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Floats = NDArray[np.float64]
SIZE = 260
_SUBPIXELS = 5


@dataclass(frozen=True)
class Stroke:
    """A line (n, 2) in pixels, points about half a pixel apart, and its curvature (n,) in 1/px.

    `inner` (n,) says which points lie away from its own ends and corners, where its pen is round.
    `free` says that its curvature is not that of a line or an arc.
    """

    points: Floats
    curvature: Floats
    inner: NDArray[np.bool_]
    free: bool = False


@dataclass(frozen=True)
class Pen:
    """Full width in pixels, and whether edges are anti-aliased."""

    width: float
    smooth: bool

    def __str__(self) -> str:
        return f"{self.width:g} px {'smooth' if self.smooth else 'hard'}"


@dataclass
class Sheet:
    """Strokes of one drawing."""

    rng: np.random.Generator
    margin: float
    """pixels from the ends and corners of a stroke within which it is not judged"""
    strokes: list[Stroke] = field(default_factory=list)

    def line(self, start: Floats, end: Floats, joined: tuple[bool, bool] = (False, False)) -> None:
        """A straight stroke; where it is `joined` to others it is judged up to its end."""
        length = float(np.hypot(*(end - start)))
        s = np.linspace(0.0, length, max(2, int(2 * length)))
        points = start + s[:, None] / length * (end - start)
        from_start = s >= (0.0 if joined[0] else self.margin)
        inner = from_start & (length - s >= (0.0 if joined[1] else self.margin))
        self.strokes.append(Stroke(points, np.zeros(len(s)), inner))

    def arc(
        self, center: Floats, radius: float, first: float, turn: float, ends: bool = True
    ) -> None:
        """Part of a circle from an angle on; without `ends` it is judged all along."""
        length = radius * abs(turn)
        s = np.linspace(0.0, length, max(8, int(2 * length)))
        angle = first + s / length * turn
        points = center + radius * np.column_stack([np.cos(angle), np.sin(angle)])
        inner = (np.minimum(s, length - s) >= self.margin) if ends else np.ones(len(s), bool)
        self.strokes.append(Stroke(points, np.full(len(s), 1.0 / radius), inner))


def _unit(angle: float) -> Floats:
    return np.array([np.cos(angle), np.sin(angle)])


def _middle(sheet: Sheet) -> Floats:
    return np.asarray(SIZE / 2 + sheet.rng.uniform(-12.0, 12.0, 2))


def _straight(sheet: Sheet) -> None:
    middle, ahead = _middle(sheet), _unit(sheet.rng.uniform(0, np.pi))
    sheet.line(middle - 95 * ahead, middle + 95 * ahead)


def _crossing(sheet: Sheet) -> None:
    middle, angle = _middle(sheet), sheet.rng.uniform(0, np.pi)
    skew = np.radians(sheet.rng.uniform(25.0, 90.0))
    for ahead in (_unit(angle), _unit(angle + skew)):
        sheet.line(middle - 95 * ahead, middle + 95 * ahead)


def _tee(sheet: Sheet) -> None:
    middle, angle = _middle(sheet), sheet.rng.uniform(0, 2 * np.pi)
    ahead = _unit(angle)
    sheet.line(middle - 95 * ahead, middle + 95 * ahead)
    skew = np.radians(sheet.rng.uniform(35.0, 145.0))
    sheet.line(middle, middle + 95 * _unit(angle + skew), (True, False))


def _star(sheet: Sheet) -> None:
    middle, count = _middle(sheet), int(sheet.rng.choice([3, 5]))
    free = 2 * np.pi - count * np.radians(45.0)
    cuts = np.sort(np.concatenate([[0.0, 1.0], sheet.rng.random(count - 1)]))
    angles = sheet.rng.uniform(0, 6.28) + np.cumsum(np.radians(45.0) + free * np.diff(cuts))
    for angle in angles:
        sheet.line(middle, middle + 100 * _unit(angle), (True, False))


def _corner(sheet: Sheet) -> None:
    middle, angle = _middle(sheet), sheet.rng.uniform(0, 2 * np.pi)
    turn = np.radians(sheet.rng.uniform(30.0, 110.0))
    sheet.line(middle - 90 * _unit(angle), middle)
    sheet.line(middle, middle + 90 * _unit(angle + turn))


def _bend(sheet: Sheet) -> None:
    rng = sheet.rng
    at, angle = _middle(sheet), rng.uniform(0, 2 * np.pi)
    turn = np.radians(rng.uniform(30.0, 100.0))
    radius = float(rng.uniform(25.0, 50.0))
    ahead = _unit(angle)
    sheet.line(at - 80 * ahead, at)
    center = at + radius * _unit(angle + np.pi / 2)
    sheet.arc(center, radius, angle - np.pi / 2, turn)
    end = center + radius * _unit(angle - np.pi / 2 + turn)
    sheet.line(end, end + 80 * _unit(angle + turn))


def _circle(sheet: Sheet) -> None:
    radius = float(sheet.rng.uniform(40.0, 95.0))
    sheet.arc(_middle(sheet), radius, float(sheet.rng.uniform(0, 6)), 2 * np.pi, ends=False)


def _roundabout(sheet: Sheet) -> None:
    middle, radius = _middle(sheet), float(sheet.rng.uniform(35.0, 55.0))
    first = float(sheet.rng.uniform(0, 6))
    sheet.arc(middle, radius, first, 2 * np.pi, ends=False)
    for quarter in range(4):
        away = _unit(first + np.pi / 2 * quarter + sheet.rng.uniform(-0.3, 0.3))
        sheet.line(middle + radius * away, middle + 110 * away, (True, False))


def _grid(sheet: Sheet) -> None:
    middle, angle = _middle(sheet), sheet.rng.uniform(0, np.pi)
    for heading in (angle, angle + np.pi / 2):
        ahead, beside = _unit(heading), _unit(heading + np.pi / 2)
        for place in np.cumsum(sheet.rng.uniform(48.0, 62.0, 3)) - 105:
            at = middle + place * beside
            sheet.line(at - 95 * ahead, at + 95 * ahead)


def _wobble(sheet: Sheet) -> None:
    """A hand's line: waves of 1 to 4 px, 70 to 190 px long."""
    rng = sheet.rng
    middle, angle = _middle(sheet), float(rng.uniform(0, np.pi))
    s = np.linspace(-95.0, 95.0, 381)
    off, slope, bend = np.zeros_like(s), np.zeros_like(s), np.zeros_like(s)
    for _ in range(3):
        size, phase = rng.uniform(1.0, 4.0), rng.uniform(0, 6)
        wave = 2 * np.pi / rng.uniform(70, 190)
        off += size * np.sin(wave * s + phase)
        slope += size * wave * np.cos(wave * s + phase)
        bend -= size * wave**2 * np.sin(wave * s + phase)
    points = middle + s[:, None] * _unit(angle) + off[:, None] * _unit(angle + np.pi / 2)
    inner = np.abs(s) < 95 - sheet.margin
    curvature = np.abs(bend) / (1 + slope**2) ** 1.5
    sheet.strokes.append(Stroke(points, curvature, inner, free=True))


SHAPES: dict[str, Callable[[Sheet], None]] = {
    "straight": _straight,
    "crossing": _crossing,
    "T": _tee,
    "star": _star,
    "corner": _corner,
    "bend": _bend,
    "circle": _circle,
    "roundabout": _roundabout,
    "grid": _grid,
    "by hand": _wobble,
}


def strokes_of(shape: str, seed: int, pen: Pen) -> list[Stroke]:
    """The strokes of a shape."""
    sheet = Sheet(np.random.default_rng([seed, list(SHAPES).index(shape)]), 1.5 * pen.width + 4)
    SHAPES[shape](sheet)
    return sheet.strokes


def drawn(strokes: list[Stroke], pen: Pen) -> NDArray[np.uint8]:
    """A picture (h, w, 3) of dark strokes with round ends on white."""
    steps = _SUBPIXELS if pen.smooth else 1
    offsets = (np.arange(steps) + 0.5) / steps - 0.5
    y, x = np.mgrid[:SIZE, :SIZE]
    pixels = np.column_stack([x.ravel(), y.ravel()]).astype(float)
    trees = [cKDTree(_dense(stroke.points)) for stroke in strokes]
    near = pen.width / 2 + 2.0  # how far anything farther is away does not matter
    away = np.min([tree.query(pixels, distance_upper_bound=near)[0] for tree in trees], axis=0)
    covered = (away <= pen.width / 2).astype(float)
    edge = np.flatnonzero(np.abs(away - pen.width / 2) < 1.0)
    if steps > 1:
        shifts = np.stack(np.meshgrid(offsets, offsets), axis=-1).reshape(1, -1, 2)
        at = (pixels[edge, None] + shifts).reshape(-1, 2)
        nearest = np.min([tree.query(at, distance_upper_bound=near)[0] for tree in trees], axis=0)
        covered[edge] = (nearest <= pen.width / 2).reshape(len(edge), -1).mean(axis=1)
    gray = (255 - 215 * covered).reshape(SIZE, SIZE, 1)
    return np.asarray(np.rint(gray).repeat(3, axis=2), np.uint8)


def _dense(points: Floats) -> Floats:
    """Five times as many points, so that the nearest is hardly farther than the line."""
    place = np.arange(len(points))
    at = np.linspace(0, len(points) - 1, 5 * len(points))
    return np.column_stack([np.interp(at, place, column) for column in points.T])
