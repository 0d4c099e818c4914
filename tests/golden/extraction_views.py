"""What is extracted from synthetic pictures, in lines: tones, surfaces and evidence of roads."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import cv2
import numpy as np

from roadlang_standard.extraction.colors.nodata import nodata
from roadlang_standard.extraction.drawings.drawing import roads_of_drawing
from roadlang_standard.extraction.drawings.thresholding import ContourSteps, roads_by_contour
from roadlang_standard.extraction.free_space import roads_of_free_space
from roadlang_standard.extraction.networks.found_network import FoundNetwork
from roadlang_standard.extraction.photos.aerial import Cutoffs, Request, roads_of_evidence
from roadlang_standard.extraction.photos.classical import roads_by_ribbons
from roadlang_standard.extraction.photos.exposure import even_exposure
from roadlang_standard.extraction.photos.photo_evidence import Seen
from roadlang_standard.extraction.photos.scale import fine_share, view_scales
from roadlang_standard.extraction.picture_kinds.picture_kind import picture_kind
from tests.golden.summaries import array

_SIZE = (190, 240)


def _line(rng: np.random.Generator) -> Any:
    x = np.linspace(-5.0, _SIZE[1] + 5.0, 40)
    a, b = rng.uniform(8.0, 30.0), rng.uniform(20.0, 45.0)
    y = rng.uniform(60.0, 130.0) + a * np.sin(x / b) + rng.uniform(-0.2, 0.2) * x
    return np.stack([x, y], axis=1)


def _roads(rng: np.random.Generator) -> list[Any]:
    """A road from side to side, one that meets it, a loop and a part of its own."""
    through = _line(rng)
    at = through[int(rng.integers(12, 28))]
    meets = np.stack([at, at + np.array([rng.uniform(-30.0, 30.0), -60.0]), (at[0] + 20.0, -5.0)])
    turn = np.linspace(0.0, 2.0 * np.pi, 40)
    middle, radius = rng.uniform((50.0, 140.0), (190.0, 160.0)), rng.uniform(16.0, 24.0)
    ring = middle + radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    dead_end = np.array([[30.0, 30.0], [60.0, 25.0], [80.0, 40.0]]) + rng.uniform(-9.0, 9.0, 2)
    return [through, meets, ring, dead_end]


def _surface(rng: np.random.Generator, gaps: bool = False) -> Any:
    """(h, w) 0..1: soft roads of several widths, some with gaps."""
    out = np.zeros(_SIZE, np.uint8)
    for number, line in enumerate(_roads(rng)):
        width = int(rng.integers(5, 11))
        points = [np.round(line * 16).astype(np.int32)]
        cv2.polylines(out, points, False, 255, width, cv2.LINE_AA, 4)
        if gaps and number < 2:
            x, y = np.round(line[len(line) // 2] + (8.0, 0.0)).astype(int).tolist()
            cv2.circle(out, (x, y), int(rng.integers(6, 12)), 30, -1)
    return cv2.GaussianBlur(out.astype(np.float32) / 255.0, (0, 0), 1.5)


def _painted(rng: np.random.Generator, surface: Any, noise: float) -> Any:
    road, ground = rng.uniform(90.0, 140.0, 3), rng.uniform((30.0, 70.0, 20.0), (70.0, 120.0, 60.0))
    picture = ground + surface[..., None] * (road - ground)
    picture += rng.normal(0.0, noise, picture.shape)
    return np.clip(picture, 0, 255).astype(np.uint8)


def found_lines(name: str, found: FoundNetwork) -> Iterator[str]:
    """Nodes, roads and how they were found."""
    scores = {key: round(value, 6) for key, value in found.scores.items()}
    yield f"  {name}: {found.method} {found.remarks} {scores} sure {found.confidence:.6g}"
    yield f"    nodes {array(found.nodes.ravel().tolist())} mask {int(found.mask.sum())}"
    for road in found.roads:
        points, widths = array(road.points.ravel().tolist()), array(np.ravel(road.widths).tolist())
        yield f"    {road.start}-{road.end} {points} width {widths} sure {road.confidence:.6g}"


_REQUESTS = {
    "all": Request(),
    "threshold": Request(threshold=0.35),
    "width": Request(width=9.0),
    "left out": Request(leave_out=(((100.0, 0.0), (180.0, 60.0)),)),
    "through": Request(through=((20.0, 90.0), (120.0, 95.0), (220.0, 90.0))),
    "only through": Request(through=((30.0, 100.0),), only_through=True),
    "long": Request(min_length=70.0),
}


def evidence_lines(first: int, count: int) -> Iterator[str]:
    """Roads of evidence as a network gives it: with gaps, faint, under every hint."""
    for number in range(first, first + count):
        rng = np.random.default_rng(number)
        surface = _surface(rng, gaps=True) * np.float32(rng.choice([0.98, 0.98, 0.7]))
        blend = cv2.GaussianBlur(surface, (0, 0), 2.0)
        yield f"{number}:"
        for name, request in _REQUESTS.items():
            yield from found_lines(name, roads_of_evidence(Seen(surface, blend), request))
        strict = Cutoffs(strong=0.6, weak=0.3, link_distance=90.0, shortest_branch=8.0)
        linked = roads_of_evidence(Seen(surface, blend), cutoffs=strict)
        yield from found_lines("linked", linked)
        yield from found_lines("half", linked.scaled(0.5, (95, 120)))


def picture_lines(first: int, count: int) -> Iterator[str]:
    """Pictures painted, drawn and turned: what kind they are, and their roads without a network."""
    for number in range(first, first + count):
        rng = np.random.default_rng(number)
        surface = _surface(rng)
        photo, plan = _painted(rng, surface, 9.0), _painted(rng, surface, 0.0)
        matrix = cv2.getRotationMatrix2D((120, 95), float(rng.uniform(10.0, 40.0)), 1.0)
        turned = cv2.warpAffine(photo, matrix, _SIZE[::-1], borderValue=(0, 0, 0))
        enlarged = cv2.resize(photo[:100, :100], None, fx=3.0, fy=3.0)
        yield f"{number}:"
        for name, image in {
            "photo": photo,
            "plan": plan,
            "turned": turned,
            "large": enlarged,
        }.items():
            margin = nodata(image)
            kind = picture_kind(image)
            yield f"  {name}: {kind.name} margin {0 if margin is None else int(margin.sum())}"
            scales = [view_scales(image, resolution) for resolution in (None, 0.3, 0.8)]
            light = even_exposure(image).astype(float)
            yield f"    {fine_share(image):.6g} {scales} {array(light.mean(axis=(0, 2)).tolist())}"
        yield from found_lines("ribbons", roads_by_ribbons(photo))
        yield from found_lines("drawing", roads_of_drawing(plan))
        yield from found_lines("outlined", roads_of_drawing(_outlined(surface), width=8.0))
        for steps in (ContourSteps(), ContourSteps(blur=2.0, road="light", between=False)):
            yield from found_lines("contour", roads_by_contour(plan, steps))
        free = surface > 0.5
        moved = roads_of_free_space(free, 0.2, None, 0.5)
        yield f"  free space: {len(moved.network.edges)} {moved.network.length:.9g}"


def _outlined(surface: Any) -> Any:
    """The roads as two lines on white paper."""
    wide = (surface > 0.3).astype(np.uint8)
    edge = cv2.morphologyEx(wide, cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8))
    return np.where(edge[..., None] > 0, 20, 255).repeat(3, axis=2).astype(np.uint8)
